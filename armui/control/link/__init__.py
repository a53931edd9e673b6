"""The way to one arm: its device, what it was asked first, its identifiers."""
