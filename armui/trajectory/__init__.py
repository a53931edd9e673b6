"""Programs of motion: what they are, their files, their library, their time and their check."""
