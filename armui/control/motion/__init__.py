"""Motions that the operator sends by hand: joints, poses, lines, arcs and jogging."""
