"""Motions sent by hand: joints, poses, lines, arcs, jogging, and what becomes of them."""
