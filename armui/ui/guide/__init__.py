"""The user guide: its text, its window, and which of its sections belongs where."""
