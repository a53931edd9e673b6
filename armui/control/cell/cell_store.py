"""The interface of what keeps cells between the program's runs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from armui.arm.refusal import Refusal
    from armui.cell.cell import Cell


class CellStore(Protocol):
    """Keeps cells, and which arm each belongs to; nobody waits for it."""

    def save(self, cell: Cell) -> None:
        """Keep a cell under its name."""

    def rename(self, name: str, cell: Cell) -> None:
        """Keep a cell under another name than before, for all arms that it belongs to."""

    def delete(self, name: str) -> None:
        """Keep a cell no longer."""

    def keep(self, arm_key: str, name: str) -> None:
        """Keep which cell an arm belongs to; "" for none."""

    def kept(self, arm_key: str) -> str:
        """Return the name of the cell an arm belongs to; "" if there is none."""

    def write(self, path: Path, cell: Cell, then: Callable[[Refusal | None], object]) -> None:
        """Export a cell to any file; `then` gets ``None``, or why it could not be written."""

    def read(self, path: Path, then: Callable[[Cell | Refusal], object]) -> None:
        """Read a cell from any file; `then` gets it, or why the file is refused."""
