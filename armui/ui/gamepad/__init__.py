"""The gamepad's strip in the main window, and the window of its settings."""
