"""What is tried with other programs, by commands of its own: no part of the check."""
