"""The 3D picture of the arm."""
