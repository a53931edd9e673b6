"""The parameters that the arm keeps: reading, editing as a draft, saving and reading back."""
