"""What happens, in which order: drawn from a seed before anything runs.

An action is a name and its figures. None depends on another, so that any of them can be left out
when a failure is narrowed down.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, Final

from armui.sim.faults.schedule import FAULTS, FaultParameter

JOINT_RANGES_DEG: Final = ((-60, 60), (20, 90), (-90, -20), (-40, 40), (-40, 40), (-60, 60))
"""A part of each joint's range in which most poses can be reached."""

_WAITS_S: Final = (0.02, 0.02, 0.04, 0.04, 0.06, 0.1, 0.1, 0.2, 0.3, 0.6)
_SILENCES: Final = (
    (0x2A1,),
    (0x2A5, 0x2A6, 0x2A7),
    (0x2A6,),
    (0x2A2, 0x2A3, 0x2A4),
    (0x2A8,),
    (0x251, 0x252, 0x253, 0x254, 0x255, 0x256),
    (0x261, 0x262, 0x263, 0x264, 0x265, 0x266),
    (0x476,),
    tuple(range(0x2A1, 0x2A9)),
)
_LOST: Final = (0x150, 0x151, 0x471, 0x470, 0x475, 0x2A1, 0x476)
"""Not one of a target's three frames: the simulated arm completes it with the next target's."""


@dataclass(frozen=True, slots=True)
class Action:
    """One thing that happens, and how long nothing else does.

    Attributes:
        name: Of a method of `tests.safety.fuzz.actors.Actors`.
        figures: Its arguments.
        wait_s: How much time passes afterwards.
    """

    name: str
    figures: tuple[Any, ...] = ()
    wait_s: float = 0.04

    def __str__(self) -> str:
        said = ", ".join(map(repr, self.figures))
        return f"{self.name}({said}), then {self.wait_s:g} s"


Draw = Callable[[random.Random], tuple[Any, ...]]


def joints(chance: random.Random) -> tuple[float, ...]:
    """Six angles in degrees."""
    return tuple(round(chance.uniform(*bounds), 1) for bounds in JOINT_RANGES_DEG)


def _nothing(_: random.Random) -> tuple[Any, ...]:
    return ()


def _target(chance: random.Random) -> tuple[Any, ...]:
    return (joints(chance),)


def _joint_step(chance: random.Random) -> tuple[Any, ...]:
    return chance.randint(1, 6), chance.choice((-10.0, -1.0, -0.1, 0.1, 1.0, 5.0))


def _tool_step(chance: random.Random) -> tuple[Any, ...]:
    return (
        chance.randrange(6),
        chance.choice((-5.0, -1.0, 1.0, 5.0)),
        chance.choice(("base", "tool")),
    )


def _joint_hold(chance: random.Random) -> tuple[Any, ...]:
    return chance.randint(1, 6), chance.choice((-1, 1))


def _tool_hold(chance: random.Random) -> tuple[Any, ...]:
    return chance.randrange(6), chance.choice((-1, 1)), chance.choice(("base", "tool"))


def _joint(chance: random.Random) -> tuple[Any, ...]:
    return (chance.choice((1, 2, 3, 4, 5, 6, 7, 7, 7)),)


def _target_at_speed(chance: random.Random) -> tuple[Any, ...]:
    return joints(chance), chance.choice((5, 30, 100))


def _stream(chance: random.Random) -> tuple[Any, ...]:
    return joints(chance), chance.choice((5.0, 20.0)), chance.choice((5, 30, 100))


def _fault(chance: random.Random) -> tuple[Any, ...]:
    name = chance.choice(sorted(FAULTS))
    if FAULTS[name].parameter is FaultParameter.JOINT:
        return name, float(chance.randint(1, 6))
    return name, None


def _one(*choices: Any) -> Draw:
    return lambda chance: (chance.choice(choices),)


ACTIONS: Final[tuple[tuple[int, str, Draw], ...]] = (
    # the operator
    (14, "step", _joint_step),
    (8, "tool_step", _tool_step),
    (12, "send_joints", _target),
    (3, "go_home", _nothing),
    (5, "move_tool", lambda chance: (joints(chance), chance.choice((0, 2)))),
    (5, "hold_joint", _joint_hold),
    (4, "hold_tool", _tool_hold),
    (8, "let_go", _nothing),
    (6, "speed", _one(0, 5, 30, 100)),
    (8, "plan", _one(1, 2, 3, 4, 6, 6)),
    (8, "enable", _joint),
    (3, "disable", _joint),
    (8, "stop", _nothing),
    (8, "resume", _nothing),
    (4, "run", lambda chance: (joints(chance), joints(chance), chance.choice((1, 2)))),
    (3, "replay", lambda chance: (joints(chance), chance.choice((1, 2)))),
    (2, "pause_run", _nothing),
    (2, "go_on_run", _nothing),
    (2, "stop_run", _nothing),
    (3, "gripper", _one("move", "enable", "disable", "clear", "zero")),
    (3, "teach", _one(1, 2, 3, 4, 5, 6, 7)),
    (3, "read_settings", _nothing),
    (3, "save_setting", lambda chance: (chance.randint(1, 6), chance.choice((1, 2, 3)))),
    (2, "zero", _joint),
    (1, "link_as", _one(("output", 0), ("output", 0x10), ("input", 0))),
    (2, "light", _joint),
    (1, "load", _one(0, 1, 2)),
    (1, "end_reports", _one(True, False)),
    (6, "next_step", _nothing),
    (3, "record", _nothing),
    (5, "wait", _one(0.5, 1.0, 2.5)),
    (2, "disconnect", _nothing),
    (5, "connect", _nothing),
    (30, "get_ready", _nothing),
    (3, "take_over", _nothing),
    (2, "halt_and_hold", _nothing),
    # a second host
    (4, "other_target", _target_at_speed),
    (2, "other_pose", lambda chance: (joints(chance), chance.choice((0, 2)))),
    (2, "other_stream", _stream),
    (3, "other_resumes_stream", _one(1.0, 5.0)),
    (5, "other_ends_streams", _nothing),
    (3, "other_stop", _nothing),
    (4, "other_resume", _nothing),
    (4, "other_enable", _nothing),
    (2, "other_disable", _nothing),
    (3, "other_mode", _one("0000", "0105", "0101", "0100")),
    (2, "other_mit", _nothing),
    (2, "other_plan", _one(1, 2, 6)),
    (
        3,
        "other_setting",
        _one("474#010320FCE01F4000", "47A#0202020202020000", "475#0100AE00FFFF0000"),
    ),
    (1, "other_gripper", _nothing),
    (2, "other_question", _nothing),
    # a hand
    (3, "push", lambda chance: (chance.randint(1, 6), chance.choice((-5.0, 5.0)))),
    (2, "lead", _target),
    # what breaks
    (4, "fault", _fault),
    (6, "mend", _nothing),
    (4, "silence", _one(*_SILENCES)),
    (3, "lose", _one(*_LOST)),
    (2, "unplug", _nothing),
    (5, "plug_in", _nothing),
    (1, "power_cycle", _one(0.0, 0.3, 2.0)),
    (2, "suspend", _one(0.1, 0.4, 1.0, 12.0)),
    (1, "sleep", _one(1.0, 3600.0)),
    (1, "sag", _one(0.0, 0.1)),
    (2, "hang", _one(0.1, 0.5)),
)


def script(seed: int, actions: int) -> list[Action]:
    """The actions a seed stands for."""
    chance = random.Random(seed)
    return list(_drawn(chance, actions))


def _drawn(chance: random.Random, actions: int) -> Iterator[Action]:
    weights = [weight for weight, _, _ in ACTIONS]
    for _ in range(actions):
        _, name, draw = chance.choices(ACTIONS, weights)[0]
        yield Action(name, draw(chance), chance.choice(_WAITS_S))
