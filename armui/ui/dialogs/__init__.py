"""The dialogs: connecting, settings, backup, joint status, help, and questions. None is modal."""
