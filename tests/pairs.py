"""Of all combinations of a test's values the few that show every value, or every pair of values.

A test with several values of several things is run with all their combinations by ``pytest --full``
only, if it has one of two marks; each says in `full` what that adds:

- ``each_value``: each value occurs, those of the shorter lists in turn;
- ``each_pair``: each two values of two things occur together.
"""

from collections import Counter
from collections.abc import Hashable, Mapping, Sequence
from itertools import combinations

SIZES = {"each_value": 1, "each_pair": 2}
"""How many values have to occur together, by mark."""

Case = Mapping[str, Hashable]
"""A value for each name."""


def few_of(cases: Sequence[Case], together: int) -> list[int]:
    """Choose cases, always the same, in which each values occur together that do in any.

    Args:
        cases: All there are. They need not be every combination.
        together: How many values are to occur together: 1 each value, 2 each pair.

    Returns:
        The places of the chosen in `cases`, in order.
    """
    parts = [
        set(combinations(sorted(case.items(), key=_name), min(together, len(case))))
        for case in cases
    ]
    missing = set().union(*parts)
    seen: Counter[tuple[tuple[str, Hashable], ...]] = Counter()
    chosen = []
    while missing:
        # of those that show as much, the one of which least was seen: values take turns
        worth = [
            (len(part & missing), -sum(seen[each] for each in part), -place)
            for place, part in enumerate(parts)
        ]
        best = -max(worth)[2]
        chosen.append(best)
        missing -= parts[best]
        seen.update(parts[best])
    return sorted(chosen)


def _name(value: tuple[str, Hashable]) -> str:
    return value[0]
