"""What surrounds the panels: top bar, menu, status bar, recovery line, pages."""
