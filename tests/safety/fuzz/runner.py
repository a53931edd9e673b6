"""Runs a script, and narrows a failure down to the actions it takes."""

from __future__ import annotations

import itertools
import sys
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Final

from armui.protocol.generation import Generation
from tests.safety.fuzz.actors import Actors
from tests.safety.fuzz.asked import Violation
from tests.safety.fuzz.breakage import InjectedError
from tests.safety.fuzz.oracle import Oracle
from tests.safety.fuzz.script import Action
from tests.safety.fuzz.world import STEP_S, World

_CHANNELS: Final = itertools.count()
_NOT_PRESSED: Final = frozenset(
    {
        "fail",
        "wait",
        "hush",
        "strange_frame",
        "get_ready",
        "exchange",
        "client_gets_the_arm",
        "client_comes_streaming",
        "client_comes_sending",
    }
)
"""Actions in which time passes: each step of it looks for itself what fails."""
_LEAST_WAIT_S: Final = STEP_S


@dataclass(frozen=True, slots=True)
class Failure:
    """A violation and how to come to it.

    Attributes:
        violation: What must not be.
        index: Of the action after which it was seen.
    """

    violation: Violation
    index: int


def run(
    actions: Sequence[Action], generation: Generation, ignored: Collection[str] = ()
) -> Failure | None:
    """Do all of it before a new arm that is ready to move; the first violation ends it.

    Args:
        actions: What happens.
        generation: Of the arm.
        ignored: Violations with one of these texts in their keys are passed over.
    """
    world = World(f"fuzz {next(_CHANNELS)}", generation)
    try:
        world.ready()
        world.events.clear()
        oracle = Oracle(world, ignored)
        world.watch = oracle.look
        actors = Actors(world, oracle)
        for index, action in enumerate(actions):
            violation = _do(world, oracle, actors, action)
            if violation is not None:
                return Failure(violation, index)
        return None
    finally:
        world.plug_cable_in()
        world.close()


def _do(world: World, oracle: Oracle, actors: Actors, action: Action) -> Violation | None:
    act = partial(getattr(actors, action.name), *action.figures)
    try:
        if world.breakage is None or action.name in _NOT_PRESSED:
            with oracle.timed(action.name):
                act()
        else:
            world.breakage.during(act)
    except InjectedError as error:
        sys.excepthook(type(error), error, error.__traceback__)  # as Qt does in a slot
    except Exception as error:  # noqa: BLE001 - whatever an action raises is a finding
        trace = error.__traceback__
        while trace is not None and trace.tb_next is not None:
            trace = trace.tb_next
        where = trace.tb_frame.f_code.co_filename.rsplit("/", 1)[-1] if trace else "?"
        said = f"{type(error).__name__} in {where}"
        return Violation("exception", f"{action.name}: {said}", f"{action}: {said}: {error}")
    world.pass_time(max(action.wait_s, _LEAST_WAIT_S))
    actors.after()
    return oracle.violation


def shrink(
    actions: Sequence[Action],
    failure: Failure,
    generation: Generation,
    *,
    ignored: Collection[str] = (),
    runs: int = 120,
) -> tuple[list[int], Failure]:
    """The indices of the actions that are enough for the same violation.

    Args:
        actions: All of them.
        failure: What they lead to.
        generation: Of the arm.
        ignored: As in `run`.
        runs: At most so many runs are spent on it.
    """
    kept = list(range(failure.index + 1))
    size = max(len(kept) // 2, 1)
    while runs > 0:
        shorter = False
        for start in range(0, len(kept), size):
            tried = kept[:start] + kept[start + size :]
            if not tried or runs <= 0:
                continue
            runs -= 1
            again = run([actions[index] for index in tried], generation, ignored)
            if again is not None and again.violation.key == failure.violation.key:
                kept = tried[: again.index + 1]
                failure = Failure(again.violation, len(kept) - 1)
                shorter = True
                break
        if not shorter:
            if size == 1:
                break
            size //= 2
    return kept, failure
