"""Recordings: samples over time, thinning, lookup at a time, preparation for replay."""
