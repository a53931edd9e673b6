"""The CAN bus: adapters and their search, the thread that owns the bus, and the outbox.

Only this room sends; the emergency stop passes everything that waits here.
"""
