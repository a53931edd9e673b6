"""What the operator sees and does, through the window, at a simulated arm."""
