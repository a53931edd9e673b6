"""What can go wrong with a simulated arm and its cable, and how the arm protects itself."""
