"""What the bytes on the bus mean, in both generations of the protocol; no Qt, no bus. Pure."""
