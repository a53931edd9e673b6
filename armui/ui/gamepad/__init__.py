"""What is seen of gamepads and SpaceMice: the sign in the main window, and their settings."""
