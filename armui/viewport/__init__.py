"""The 3D picture of the arm: its widget, and the link to the process that draws it."""
