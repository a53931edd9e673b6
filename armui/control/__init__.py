"""What the operator does: every action, checked, sent and followed to its end."""
