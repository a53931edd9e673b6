"""Pages beside the 3D picture, taken out and put back; what is kept of how they stand."""
