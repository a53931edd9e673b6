"""Commands by name and by key: shortcuts, their list, the command palette."""
