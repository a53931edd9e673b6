"""Stands for what makes an .mf4 file, in the helper process: it begins one, and never ends."""

import time
from pathlib import Path


def make(folder: Path, _name: str, told: Path, unfinished: str) -> None:
    """Begin, say how much is done, and go on for ever."""
    (folder / unfinished).write_text("half of it")
    told.write_text("0.5000")
    while True:
        time.sleep(1.0)
