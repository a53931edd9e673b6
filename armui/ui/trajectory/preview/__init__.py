"""The preview of a planned path with its time slider."""
