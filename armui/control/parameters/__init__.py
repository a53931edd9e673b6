"""The parameters the arm keeps: read, edited as a draft, saved and read back."""
