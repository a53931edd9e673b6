"""One check of many entries of a table: each that fails is told, not only the first."""

from collections.abc import Callable, Iterable
from typing import TypeVar

_Entry = TypeVar("_Entry")


def check_each(entries: Iterable[_Entry], check: Callable[[_Entry], None]) -> None:
    """Check every entry; fails with all that are wrong, and why.

    Args:
        entries: Of the table; there must be one.
        check: Asserts what has to be so of an entry. Its own errors count as failures, too.
    """
    count, wrong = 0, []
    for entry in entries:
        count += 1
        try:
            check(entry)
        except Exception as error:  # noqa: BLE001 - whatever it is, the other entries are looked at
            wrong.append(f"{entry!s}: {type(error).__name__}: {error}")
    assert count, "there is no entry"
    assert not wrong, f"{len(wrong)} of {count} are wrong:\n" + "\n".join(wrong)
