"""The meaning of the bytes on the bus, in both generations of the protocol; no Qt, no bus. Pure."""
