"""The main window around the panels: top bar, menu, status bar, pages."""
