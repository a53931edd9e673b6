"""What stands over and around the 3D picture: views, what is shown in it, dragging."""
