"""The user guide: its text, its window, and the section for each place in the program."""
