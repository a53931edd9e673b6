"""What the bytes on the bus mean: both generations of the protocol, without Qt and without a bus."""
