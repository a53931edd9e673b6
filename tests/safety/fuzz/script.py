"""What happens, in which order: drawn from a seed before anything runs.

An action is a name and its figures. None depends on another, so that any of them can be left out
when a failure is narrowed down.
"""

from __future__ import annotations

import math
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
        chance.choice((-20.0, -1.0, 1.0, 5.0)),
        chance.choice(("base", "tool", "user")),
    )


def _joint_hold(chance: random.Random) -> tuple[Any, ...]:
    return chance.randint(1, 6), chance.choice((-1, 1))


def _tool_hold(chance: random.Random) -> tuple[Any, ...]:
    return chance.randrange(6), chance.choice((-1, 1)), chance.choice(("base", "tool", "user"))


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


def _failing(chance: random.Random) -> tuple[Any, ...]:
    """Which of the functions that run, how often it fails, and over how many actions."""
    return round(chance.random(), 4), chance.choice((1, 1, 2, 5, 1000)), chance.randint(1, 4)


_INDEXED: Final = (0x473, 0x47C, 0x476, 0x475, 0x477, 0x478, 0x47B, 0x47D, 0x47E, 0x4AF)
"""Answers and settings with a joint's number or another index in their first bytes."""
_PERIODIC: Final = (*range(0x2A1, 0x2A9), *range(0x251, 0x257), *range(0x261, 0x267))
_COMMANDS: Final = (*range(0x150, 0x160), *range(0x181, 0x188), 0x121, 0x191, 0x422)


def _strange(chance: random.Random) -> tuple[Any, ...]:
    """A frame nobody should say: any index, any length; how often, and how far apart.

    What the arm says over and over is only said too short: whole, it would be the arm's own word.
    """
    kind = chance.randrange(4)
    length, index = chance.randint(0, 8), chance.choice((0, 1, 6, 7, 8, 127, 128, 200, 255))
    if kind == 0:
        identifier = chance.choice(_INDEXED)
    elif kind == 1:
        identifier, length = chance.choice(_PERIODIC), chance.randint(0, 7)
    elif kind == 2:
        identifier, length = chance.choice(_COMMANDS), chance.randint(0, 7)
    else:
        identifier = chance.randrange(0x800)
        if identifier in (*_PERIODIC, *_COMMANDS):
            identifier = 0x7FF
    data = bytes([index, *(chance.randrange(256) for _ in range(7))])[:length]
    said = f"{identifier:03X}#{data.hex().upper()}"
    return said, chance.choice((1, 1, 5)), round(chance.choice((0.02, 0.1, chance.random())), 2)


def _hush(chance: random.Random) -> tuple[Any, ...]:
    return chance.choice(_SILENCES), round(chance.uniform(0.02, 2.5), 2)


def _exchange(chance: random.Random) -> tuple[Any, ...]:
    """Another generation or not, version, angles and limits, and the silence between."""
    versions = ("S-V1.5-2", "S-V1.6-5", "S-V1.8-2", "S-V1.8-7", "S-V1.8-9")
    return (
        chance.choice((True, False, False, False)),
        chance.choice(versions),
        joints(chance),
        chance.randint(1, 40),
        round(chance.choice((0.02, 0.3, 0.45, 0.7, 2.0)), 2),
    )


def _tool(chance: random.Random) -> tuple[Any, ...]:
    return (chance.choice(((0.0,) * 6, (0.0, 0.0, 120.0, 0.0, 0.0, 0.0), (30.0, 0, 60, 0, 45, 0))),)


def _user_frame(chance: random.Random) -> tuple[Any, ...]:
    """Where a user frame lies in the base, or nothing: the base itself is chosen again."""
    place = [round(chance.uniform(-300.0, 300.0), 1) for _ in range(3)]
    turned = [round(chance.uniform(-180.0, 180.0), 1) for _ in range(3)]
    return (chance.choice(((*place, *turned), (*place, *turned), ())),)


def _zone(chance: random.Random) -> tuple[Any, ...]:
    """The middle and the edges of a box along the base's axes, or nothing: none is in force."""
    if chance.random() < 0.3:
        return ((), ())
    turn, away = chance.uniform(-2.0, 2.0), chance.uniform(250.0, 550.0)
    middle = (away * math.cos(turn), away * math.sin(turn), chance.uniform(50.0, 500.0))
    edges = [round(chance.uniform(40.0, 200.0), 1) for _ in range(3)]
    return tuple(round(each, 1) for each in middle), tuple(edges)


_WORDS: Final = (
    "",
    "{",
    "[]",
    "null",
    '{"jsonrpc":"2.0","id":1}',
    '{"jsonrpc":"2.0","id":1,"method":"motion.send","params":[1]}',
    '{"jsonrpc":"2.0","id":null,"method":"stream.target","params":{"lease":1,"joints_deg":[1e999]}}',
    '{"jsonrpc":"2.0","method":"stream.target","params":{"lease":null,"joints_deg":[0,0,0,0,0,0]}}',
    '{"jsonrpc":"2.0","id":"a","method":"hello","params":{"client":"x","protocol":99}}',
    '{"jsonrpc":"2.0","id":2,"method":"state.subscribe","params":{"rate_hz":50}}',
    '{"jsonrpc":"2.0","id":2,"method":"events.subscribe"}',
    '{"jsonrpc":"2.0","id":2,"method":"operations.list"}',
    '{"jsonrpc":"2.0","id":2,"method":"state.get","params":{"fields":["nothing"]}}',
    '{"jsonrpc":"2.0","id":2,"method":"lease.request","params":{"max_speed_percent":"x"}}',
    '{"jsonrpc":"2.0","id":2,"method":"kinematics.ik","params":{"flange_pose_mm_deg":[9e9,0,0,0,0,0]}}',
    '{"jsonrpc":"2.0","id":2,"method":"motion.send","params":{"lease":-1,"angles_deg":[0,0,0,0,0,0]}}',
    '{"jsonrpc":"2.0","id":2,"method":"jog.begin","params":{}}',
    '{"a":' * 2000,
    "\udcff\udcfe",
    "x" * 70000,
)


def _said_by_client(chance: random.Random) -> tuple[Any, ...]:
    return (tuple(chance.choice(_WORDS) for _ in range(chance.choice((1, 1, 3, 20)))),)


def _client_stream(chance: random.Random) -> tuple[Any, ...]:
    return joints(chance), chance.choice((0.0, 5.0, 20.0, 200.0)), chance.choice((10.0, 25.0, 50.0))


def _wanted_by_client(chance: random.Random) -> tuple[Any, ...]:
    """An operation with its arguments."""
    joint = chance.choice((1, 2, 3, 4, 5, 6, 7))
    return chance.choice(
        (
            ("motors.enable", {"joint": joint}),
            ("motors.disable", {"joint": joint}),
            ("motors.resume", {}),
            ("joints.set_zero", {"joint": joint}),
            ("joints.clear_error", {"joint": joint}),
            ("gripper.move", {"travel": 30.0, "effort": 1.0}),
            ("gripper.enable", {"effort": 1.0}),
            ("gripper.disable", {}),
            ("lamps.set", {"joint": 1, "lamp": "nothing", "red": 1, "green": 1, "blue": 1}),
            ("end_load.set", {"load": "half"}),
            ("recorder.start", {}),
        )
    )


def _run_otherwise(chance: random.Random) -> tuple[Any, ...]:
    return (
        joints(chance),
        joints(chance),
        chance.choice((1, 2)),
        chance.choice((5, 50, 100)),
        chance.random() < 0.5,
    )


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
    (6, "override", _one(0, 5, 30, 100)),
    (2, "dip_override", _one(5, 100)),
    (2, "step_speed", _one(-10, 10)),
    (8, "plan", _one(1, 2, 3, 4, 6, 6)),
    (8, "enable", _joint),
    (3, "disable", _joint),
    (8, "stop", _nothing),
    (8, "resume", _nothing),
    (4, "run", lambda chance: (joints(chance), joints(chance), chance.choice((1, 2)))),
    (3, "replay", lambda chance: (joints(chance), chance.choice((1, 2)))),
    (3, "run", _run_otherwise),
    (3, "tool", _tool),
    (4, "user_frame", _user_frame),
    (4, "zone", _zone),
    (2, "set_limit", lambda chance: (chance.randint(1, 6), chance.randint(60, 150))),
    (2, "pause_run", _nothing),
    (2, "go_on_run", _nothing),
    (2, "stop_run", _nothing),
    (3, "gripper", _one("move", "open", "close", "enable", "disable", "clear", "zero")),
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
    # a client of the local interface
    (6, "client_gets_the_arm", _one(5, 30, 100)),
    (
        24,
        "client_comes_streaming",
        lambda chance: (chance.choice((5, 30, 100)), *_client_stream(chance)),
    ),
    (12, "client_comes_sending", lambda chance: (chance.choice((5, 30, 100)), joints(chance))),
    (3, "client_connects", _nothing),
    (4, "client_asks", lambda chance: (chance.random() < 0.8, chance.choice((5, 30, 100)))),
    (5, "operator_grants", lambda chance: (chance.choice((5, 30, 100)), chance.random() < 0.3)),
    (1, "operator_declines", _nothing),
    (2, "operator_takes_back", _nothing),
    (4, "operator_consents", _one(True, True, False)),
    (1, "interface_on", _one(True, False)),
    (8, "client_sends", _target),
    (4, "client_steps", _joint_step),
    (3, "client_moves_tool", lambda chance: (joints(chance), chance.choice(("move_p", "move_l")))),
    (3, "client_speed", _one(0, 5, 30, 100)),
    (12, "client_streams", _client_stream),
    (5, "client_rests", _nothing),
    (3, "client_ends_stream", _nothing),
    (4, "client_wants", _wanted_by_client),
    (2, "client_releases", _nothing),
    (1, "client_stops", _nothing),
    (2, "client_halts", _nothing),
    (4, "client_says", _said_by_client),
    (2, "client_is_silent", _nothing),
    (2, "client_dies", _nothing),
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
    # what nobody should say, and nobody says
    (12, "strange_frame", _strange),
    (4, "hush", _hush),
    # what breaks
    (30, "fail", _failing),
    (4, "exchange", _exchange),
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
