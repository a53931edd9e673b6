"""The values a simulated arm keeps: how a host reads and sets them, and where they are stored."""
