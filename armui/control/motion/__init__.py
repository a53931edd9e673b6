"""Motions by hand: joints, poses, lines, arcs and jogging."""
