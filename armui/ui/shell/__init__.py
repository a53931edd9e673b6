"""What surrounds the panels: top bar, menu, status bar, recovery line, 3D region."""
