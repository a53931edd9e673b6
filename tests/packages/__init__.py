"""The packages: what they say of themselves, and what they do in a bare system."""
