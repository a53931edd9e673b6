"""How many examples hypothesis tries: as many as a check has time for, or a night."""

import os
import random
from collections.abc import Iterable
from typing import Final, TypeVar

import hypothesis

T = TypeVar("T")

USUAL: Final = "armui"
NIGHTLY: Final = "nightly"
PROFILE: Final = os.environ.get("HYPOTHESIS_PROFILE", USUAL)
"""`HYPOTHESIS_PROFILE=nightly python -m pytest` takes the night."""
_TIMES: Final = 20


def examples(usual: int) -> int:
    """A number of examples by the profile in use."""
    return usual * _TIMES if PROFILE == NIGHTLY else usual


def sample(cases: Iterable[T], usual: int, seed: object = "") -> list[T]:
    """Return a few of many cases, always the same ones in the same order; every one at night."""
    cases = list(cases)
    if PROFILE == NIGHTLY or usual >= len(cases):
        return cases
    kept = sorted(random.Random(f"{usual} {seed}").sample(range(len(cases)), usual))
    return [cases[place] for place in kept]


def load_profile() -> None:
    """Use the profile asked for.

    How long an example takes says more of the computer's other work than of the code: no deadline.
    """
    for name in (USUAL, NIGHTLY):
        count = 100 * (_TIMES if name == NIGHTLY else 1)
        hypothesis.settings.register_profile(name, deadline=None, max_examples=count)
    hypothesis.settings.load_profile(PROFILE)
