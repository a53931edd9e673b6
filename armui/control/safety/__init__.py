"""What stops the arm, what speaks against moving it, and guided recovery."""
