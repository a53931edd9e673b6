"""What can go wrong on the way to a picture."""

from __future__ import annotations


class SceneError(Exception):
    """The 3D picture can't be made; the text names the file, the reason and the remedy."""
