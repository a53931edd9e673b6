"""The connection to one arm: its device, the first questions to it, its identifiers."""
