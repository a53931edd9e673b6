"""The pictures of the user guide, made of the gallery's: ``python -m tests.gallery --guide``."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from PIL import Image

from armui.ui.guide.text import FOLDER
from tests.gallery_scenes.pictures import Looks

PICTURES: Final = {
    "start": "window-no-device",
    "connect": "dialog-connect-searching",
    "motion": "window-moving",
    "tool": "window-tool",
    "parameters": "window-joint-settings",
    "library": "window-library",
    "editor": "window-editor",
    "joint-status": "dialog-joint-status",
    "drawer": "window-drawer-curves",
    "plots": "dialog-plots-follow",
    "events": "dialog-events",
    "sessions": "dialog-sessions",
    "palette": "dialog-palette",
}
"""By the name in the guide: the kind and the name of the scene."""

LOOKS: Final = Looks(("zh", "en"), ("light",), ((1280, 800),))
_WIDEST_PX: Final = 900
_COLORS: Final = 255


def scenes() -> list[str]:
    """The names of the scenes that are needed."""
    return sorted({scene.partition("-")[2] for scene in PICTURES.values()})


def convert(folder: Path, target: Path = FOLDER / "pictures") -> list[Path]:
    """Make the guide's pictures of the gallery's: smaller, and of 256 colours.

    Args:
        folder: Where the gallery's are.
        target: Where the guide's go; others that are there are removed.

    Raises:
        OSError: One is missing, or cannot be written.
    """
    target.mkdir(parents=True, exist_ok=True)
    written = []
    for name, scene in PICTURES.items():
        size = "-1280x800" if scene.startswith("window-") else ""
        for language in LOOKS.languages:
            source = folder / f"{scene}-{language}-light{size}.png"
            with Image.open(source) as picture:
                small = picture.convert("RGB")
            small.thumbnail((_WIDEST_PX, small.height), Image.Resampling.LANCZOS)
            path = target / f"{name}-{language}.png"
            small.quantize(_COLORS, dither=Image.Dither.NONE).save(path, optimize=True)
            written.append(path)
    for other in set(target.glob("*.png")) - set(written):
        other.unlink()
    return written
