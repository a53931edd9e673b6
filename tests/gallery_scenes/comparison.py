"""Which pictures of two galleries differ."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from PySide6.QtGui import QImage


def differences(old: Path, new: Path) -> dict[str, str]:
    """Compare the pictures that stand in the new folder with those of the same names in the old.

    Args:
        old: The folder of the first gallery.
        new: The folder of the second.

    Returns:
        What differs, in words, by the file's name; empty when all are the same pixel by pixel.
    """
    found = {}
    for path in sorted(new.glob("*.png")):
        before = old / path.name
        words = _difference(before, path) if before.exists() else "is not in the old gallery"
        if words:
            found[path.name] = words
    return found


def _difference(before: Path, after: Path) -> str:
    if before.read_bytes() == after.read_bytes():
        return ""
    pixels = [_pixels(path) for path in (before, after)]
    sizes = [f"{image.shape[1]}x{image.shape[0]}" for image in pixels]
    if sizes[0] != sizes[1]:
        return f"was {sizes[0]} pixels, is {sizes[1]}"
    count = int((pixels[0] != pixels[1]).any(axis=2).sum())
    return f"{count} pixels differ" if count else ""


def _pixels(path: Path) -> np.ndarray:
    """Height × width × 4 bytes.

    Raises:
        ValueError: The file is no picture.
    """
    image = QImage(str(path)).convertToFormat(QImage.Format.Format_RGBA8888)
    if image.isNull():
        raise ValueError(f"{path} is no picture")
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), -1)
    return rows[:, : image.width() * 4].reshape(image.height(), image.width(), 4).copy()
