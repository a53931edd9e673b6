"""One panel of the operation area a file."""
