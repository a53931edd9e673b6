"""Recordings: samples over time, thinned, read forward, prepared for replay."""
