"""The tools of the 3D picture: views, overlays, dragging."""
