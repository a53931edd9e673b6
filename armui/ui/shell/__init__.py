"""The parts of the main window around the panels: top bar, menu, status bar, pages."""
