"""Stands for what makes an .mf4 file, in the helper process: it begins one, and never ends."""

import time
from pathlib import Path


def make(_folder: Path, _name: str, told: Path, unfinished: Path) -> None:
    """Begin, say how much is done, and go on for ever."""
    unfinished.write_text("half of it")
    told.write_text("0.5000")
    while True:
        time.sleep(1.0)
