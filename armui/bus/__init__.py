"""The wire: devices, and the thread that owns the bus."""
