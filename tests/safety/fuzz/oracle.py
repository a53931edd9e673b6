"""What must hold after every step, judged by the simulated arm's own truth.

Excepted by name are: an arm that sinks or falls without power (no motor holds it), what the
operator's frames cannot reach or the program cannot hear (cable, supply, a fault of the line), and
what another host's frame has begun.
"""

from __future__ import annotations

import math
import time
from collections import deque
from collections.abc import Collection, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import Any, Final

from armui.control.link.link_state import LinkState
from armui.control.operating_state import StopState
from armui.sim.firmware import Firmware
from armui.sim.mechanics.powered_joints import SixValues
from armui.system.failures import Failure
from tests.safety.arm_oracle import depth_in_box_mm
from tests.safety.fuzz.asked import Asked, Kind, Violation
from tests.safety.fuzz.breakage import InjectedError
from tests.safety.fuzz.lease_oracle import LeaseOracle
from tests.safety.fuzz.traffic import Said, Sender, Started, base_id, is_motion
from tests.safety.fuzz.world import World

_STOP_S: Final = 0.2
_OLD_S: Final = 0.5
_LOOK_S: Final = 0.06
"""Three steps: what the program knows is one tick old, and what it says takes another."""
_END_S: Final = 1.3
"""A second to come to rest (S10), and what a tick and the brakes take."""
_DRIVE_NOTHING: Final = (
    "armui.bus.notifier",
    "armui.session",
    "armui.settings",
    "armui.system",
    "armui.telemetry",
    "armui.trajectory",
)
"""The rooms of these that can drive nothing."""
_TO_ITSELF_S: Final = 2.0
_PRESS_S: Final = 1.0
_SAME_DEG: Final = 0.011
_NEAR_DEG: Final = 0.75
"""What may lie between a target and the place it starts from: 0.5° and the sag of a joint."""
_JOG_AHEAD_DEG: Final = 20.0
_STREAM_AHEAD_DEG: Final = 12.0
"""Its lead is 9° at most (S30); and what a joint sags."""
_SETPOINTS_DEG: Final = 2.4
"""Two steps of the fastest stream."""
_TOOL_MM: Final = 15.0
_ASIDE_MM: Final = 1.0
_POSE_MM: Final = 1.0
_TAKEN_S: Final = 0.4
"""Until then after a target was asked for, no feedback tells that the arm never heard it."""
_PLACES: Final = 4
"""Looks ago: a moving arm's angles may be 0.05 s old, heard a step before."""


_OTHERS_WAY_S: Final = 6.0
"""So long after another host's last word its motion may still be under way."""
_NOISE_MM: Final = 1.0
_HELD_S: Final = 0.05
"""Of the thread's own time; the promise is 0.02 s on a computer that is quiet."""
_FIRST_PRESSES: Final = 3
"""They load what is needed for the first motion."""
_PRESSES: Final = frozenset(
    {"step", "tool_step", "send_joints", "go_home", "move_tool", "hold_joint", "hold_tool"}
)
_LASTING: Final = frozenset({Kind.JOG, Kind.RUN, Kind.TEACHING, Kind.STREAM})


@dataclass(frozen=True, slots=True)
class _Foreign:
    """What is known of the arm that was there before, and is not this one's."""

    left_s: float
    version: str
    limits_deg: Collection[float]


class Oracle:
    """Watches one world.

    Attributes:
        violation: The first thing that was not as it must be.
        zone: The middle and the edges of the box that is in force.
        lease: What must hold of a client with the arm.
    """

    def __init__(self, world: World, ignored: Collection[str] = ()) -> None:
        """Watches, and passes over violations with one of these texts in their keys."""
        self._world = world
        self._ignored = ignored
        self.violation: Violation | None = None
        self._asked = Asked(Kind.NOTHING, 0.0)
        self._mixed = False
        self._places_deg: deque[SixValues] = deque(maxlen=_PLACES)
        self._unconnected_s = -1e9
        self._ours_deg: SixValues | None = None
        self._other_s = -1e9
        self._taken_over = False
        self._stop_s: float | None = None
        self._stop_holds = False
        self._read = 0
        self._suspended_s = -1e9
        self._failed_s: float | None = None
        self._failed_anew_s = -1e9
        self._foreign: _Foreign | None = None
        self.zone: tuple[SixValues, SixValues] | None = None
        self._deepest_mm = 0.0
        self._led_s = -1e9
        self._presses = 0
        self._held: Violation | None = None
        self.lease = LeaseOracle(world)
        world.client.over = self.lease_over
        world.traffic.asked = lambda: replace(self._asked)
        world.failed = self.failed

    # What the operator does ----------------------------------------------------------------------

    def bases(self) -> list[SixValues]:
        """Where a step pressed now may start from: our own target, or what was measured of late."""
        bases = [*self._places_deg, self._world.firmware.reported_deg]
        if self._ours_deg is not None:
            bases.append(self._ours_deg)
        asked = self._asked
        bases += self._setpoint_under_way() if asked.kind is Kind.STREAM else []
        fresh = asked.cancelled is None and self._world.time_s - asked.at_s < _TAKEN_S
        if fresh and asked.goal_deg is not None:
            bases.append(asked.goal_deg)
        return bases

    def _setpoint_under_way(self) -> list[SixValues]:
        """The newest setpoint: it is on the bus, and the arm hears it with its next step."""
        command = self._world.controller._authority.command
        if self._ours_deg is None or command is None or command.joints_deg is None:
            return []
        near = _apart(command.joints_deg, self._ours_deg) <= _SETPOINTS_DEG
        return [command.joints_deg] if near else []

    def ask(self, asked: Asked) -> None:
        """The operator has asked for something that may move the arm."""
        before = self._asked
        asked.over_jog = before.kind is Kind.JOG and before.cancelled is None
        self._asked = asked
        if asked.lease is None:
            self.lease.began(asked.kind.value)

    def stream(self, lease: int | None) -> None:
        """A client's target is followed."""
        asked = self._asked
        if asked.kind is not Kind.STREAM or asked.lease != lease or asked.cancelled is not None:
            self.ask(Asked(Kind.STREAM, self._world.time_s, lease=lease))

    def stream_ended(self) -> None:
        """A client has ended its stream."""
        if self._asked.kind is Kind.STREAM and self._asked.cancelled is None:
            self._asked.cancelled, self._asked.ended_s = "the stream's end", self._world.time_s

    def lease_over(self, why: str) -> None:
        """A lease has ended: what was asked for by it is void."""
        if self._asked.lease is not None and self._asked.cancelled is None:
            self._asked.cancelled = why

    def release(self) -> None:
        """A held jog has ended."""
        if self._asked.kind is Kind.JOG and self._asked.cancelled is None:
            self._asked.cancelled = "release"

    def cancel(self, why: str) -> None:
        """What was asked for before is void."""
        self._asked.cancelled = why
        self._ours_deg = None
        self.lease.cut_s = self._world.time_s

    def stop_pressed(self) -> None:
        """The stop was pressed while a device was open."""
        if self._stop_s is None:
            self._stop_s = self._world.time_s
        self._stop_holds = False

    def stop_lifted(self) -> None:
        """The operator has given up the stop, or the arm's supply has."""
        self._stop_s, self._stop_holds = None, False

    def recovered(self, action: str) -> None:
        """A step of the way back to a ready arm was taken."""
        self.cancel(action)
        self.stop_lifted()

    def failed(self, failure: Failure) -> None:
        """The program has caught an exception: it ends its motion, unless it fails far from any."""
        if all(name.startswith(_DRIVE_NOTHING) for name in failure.modules):
            return
        self._failed_anew_s = self._world.time_s
        if self._asked.cancelled is None:
            self._asked.cancelled = "failure"
            self._failed_s = self._world.time_s

    def exchanged(self, first: Firmware, silent_s: float) -> None:
        """Another arm is in the place of the first: nothing that was said of that one counts."""
        other, now_s = self._world.firmware, self._world.time_s
        self._places_deg.clear()
        self._failed_s = self._foreign = None
        if silent_s <= _OLD_S + _LOOK_S:
            return  # too short to be noticed by silence
        own = {each.max_deg for each in other.settings.limits}
        theirs = {each.max_deg for each in first.settings.limits} - own
        version = first.type.version if first.type.version != other.type.version else ""
        self._foreign = _Foreign(now_s, version, theirs)

    def led(self) -> None:
        """A hand has moved the arm."""
        self._led_s = self._world.time_s

    def take_over(self) -> None:
        """The operator has taken the arm from the other host, deliberately."""
        self._taken_over = True

    def suspended(self) -> None:
        """The program or its window got no time until now."""
        self._suspended_s = self._world.time_s

    @contextmanager
    def timed(self, name: str) -> Iterator[None]:
        """Judge how long a press that may begin a motion keeps the window's thread (S2)."""
        began_s = time.thread_time()
        checked_s = self._world.checked_s
        yield
        if name not in _PRESSES:
            return
        self._presses += 1
        held_s = time.thread_time() - began_s - (self._world.checked_s - checked_s)
        if held_s > _HELD_S and self._presses > _FIRST_PRESSES:
            self._held = Violation("S2", f"{name} holds the window", f"{held_s:.3f} s")

    # What must hold ------------------------------------------------------------------------------

    def look(self) -> None:
        """Keep the first thing that is not as it must be; called after each step."""
        world = self._world
        found: list[Violation] = []
        self._follow()
        new = world.traffic.said[self._read :]
        self._read = len(world.traffic.said)
        started = {id(each.said): each for each in world.traffic.started}
        world.traffic.started.clear()
        for said in new:
            found += self._on_said(said)
        for each in started.values():
            found += self._on_started(each)
        found += self._stop()
        found += self._stale()
        found += self._motion_ends()
        found += self._first_arm()
        found += self._exceptions()
        found += self._in_zone()
        found += self.lease.look(self._asked, fails=self._fails(), apart=self._is_apart())
        found += [] if self._held is None else [self._held]
        self._held = None
        found = [each for each in found if not any(word in each.key for word in self._ignored)]
        if self.violation is None and found:
            self.violation = found[0]

    def _fails(self) -> bool:
        """Whether the program got no turn just now, or failed at it."""
        return self._world.time_s - max(self._failed_anew_s, self._suspended_s) <= _LOOK_S

    def _is_apart(self) -> bool:
        """Whether somebody else has had a part in how the arm moves now."""
        since_s = self._world.time_s - max(self._other_s, self._led_s)
        return self._fails() or self._mixed or since_s < _OTHERS_WAY_S

    def _follow(self) -> None:
        """Note what later judgements depend on."""
        self._places_deg.append(self._world.firmware.reported_deg)
        world, line = self._world, self._world.node.link
        # of a target of which a frame got lost, or nobody's frame became part, no goal is known
        self._mixed = self._mixed or bool(line.loss or line.garbage_per_s or line.off)
        if world.controller.operating_state.link not in (LinkState.ONLINE, LinkState.OFFLINE):
            self._unconnected_s = world.time_s

    def _on_said(self, said: Said) -> list[Violation]:
        now_s = said.at_s
        identifier = base_id(said.frame.arbitration_id)
        if said.sender is Sender.OTHER:
            self._on_other(said)
            return []
        found = [] if self._is_apart() else list(self.lease.on_said(said.frame, now_s))
        if found or not is_motion(said.frame):
            return found
        since_s = now_s - self._other_s
        anew = " and a new connection" if self._unconnected_s > self._other_s else ""
        if self._taken_over or not _LOOK_S < since_s < _TO_ITSELF_S:
            return []
        name = f"0x{identifier:03X}"
        return [
            Violation(
                "S13",
                f"{_FAMILY.get(identifier, name)} of ours after another host's frames{anew}",
                f"{name} of ours {since_s:.2f} s after a motion frame of another host; "
                f"the operator asked for {self._asked.kind.value}",
            )
        ]

    def _on_other(self, said: Said) -> None:
        """The other host has said something; what another arm listens to is no concern of ours."""
        frame, world = said.frame, self._world
        identifier = base_id(frame.arbitration_id)
        to_arm = said.to_arm  # the frame itself may have moved the arm to other identifiers
        if to_arm and is_motion(frame) and world.hears:
            self._other_s, self._taken_over = said.at_s, False
        if identifier in (0x470, 0x471, 0x475) or (to_arm and 0x150 <= identifier <= 0x15F):
            self._ours_deg = None
        if to_arm and identifier == 0x150 and frame.data[:1] == b"\x02":
            self.stop_lifted()  # another host's resume

    def _on_started(self, started: Started) -> list[Violation]:
        """A frame has set the arm in motion or sent it elsewhere."""
        if started.said.sender is not Sender.US:
            self._ours_deg = None
            return []
        self._ours_deg = started.goal_deg
        if started.said.after is None:  # from before anybody watched
            return []
        self.lease.led = started.said.after.lease
        if _apart(started.goal_deg, started.here_deg) <= _SAME_DEG:
            return []  # holds it where it stands, as the way out of the MIT mode does first
        why = self._why_unasked(started)
        if why is None:
            return []
        identifier = base_id(started.said.frame.arbitration_id)
        asked: Asked = started.said.after
        over = " over a held jog" if asked.over_jog else ""
        figures = (
            f"0x{identifier:03X} sent the arm from {_angles(started.here_deg)} "
            f"towards {_angles(started.goal_deg)}; last asked: {asked.kind.value}"
            + (f" (ended by {asked.cancelled})" if asked.cancelled else "")
        )
        return [Violation("S7–S11", f"{asked.kind.value}{over}: {why}", f"{why}: {figures}")]

    def _why_unasked(self, started: Started) -> str | None:
        asked: Asked = started.said.after
        at_s = started.said.at_s
        if asked.cancelled == "failure" and at_s - self._failed_anew_s < _LOOK_S:
            return None  # the failure lies in the very call that goes on to send it
        if asked.kind is Kind.NOTHING:
            return "moves although nothing was asked for"
        if asked.cancelled == "the stream's end" and at_s - asked.ended_s < _LOOK_S:
            return None  # what was on its way
        if asked.cancelled == "release" and at_s - asked.at_s < _LOOK_S:
            return None
        if asked.cancelled not in (None, "release"):
            return f"moves after {asked.cancelled}"
        if asked.kind not in _LASTING and at_s - asked.at_s > _PRESS_S:
            return "moves long after it was asked for"
        return None if self._mixed else self._why_elsewhere(asked, started)

    def _why_elsewhere(self, asked: Asked, started: Started) -> str | None:
        if asked.kind is Kind.JOG:
            away = _apart(started.goal_deg, started.here_deg)
            return "a jog's target lies far off" if away > _JOG_AHEAD_DEG else None
        if asked.kind is Kind.STREAM:
            away = _apart(started.goal_deg, started.here_deg)
            return "a stream's setpoint lies far off" if away > _STREAM_AHEAD_DEG else None
        if asked.kind is Kind.JOINTS and asked.goal_deg is not None:
            off = _apart(asked.goal_deg, started.goal_deg)
            return None if off <= _SAME_DEG else "goes elsewhere than asked"
        if asked.kind is Kind.STEP:
            return self._why_no_step(asked, started)
        if asked.kind is Kind.TOOL_STEP:
            return self._why_no_tool_step(asked, started)
        if asked.kind is Kind.POSE and asked.pose is not None:
            reached = self._world.firmware.kinematics.forward(started.goal_deg)
            off = max(abs(a - b) for a, b in zip(reached[:3], asked.pose[:3], strict=True))
            return None if off < _POSE_MM else "goes elsewhere than asked"
        return None

    def _why_no_step(self, asked: Asked, started: Started) -> str | None:
        limits = self._world.controller.operating_state.limits
        for index, goal in enumerate(started.goal_deg):
            delta = asked.delta if index + 1 == asked.joint else 0.0
            least_deg, most_deg = limits[index].min_deg, limits[index].max_deg

            def follows(
                base_deg: float, goal=goal, delta=delta, least_deg=least_deg, most_deg=most_deg
            ) -> bool:
                to_deg = base_deg + delta
                if delta and not least_deg <= base_deg <= most_deg:
                    # from outside a step leads to the limit at least, and says so
                    to_deg = min(max(to_deg, least_deg), most_deg)
                return abs(goal - to_deg) <= _NEAR_DEG

            if not any(follows(base[index]) for base in asked.bases):
                stepped = index + 1 == asked.joint
                return "steps from elsewhere" if stepped else "turns a joint that was not asked for"
        return None

    def _why_no_tool_step(self, asked: Asked, started: Started) -> str | None:
        forward = self._world.firmware.kinematics.forward
        reached = forward(started.goal_deg)
        aside = False
        # a turn about the tip swings the flange around it
        length_mm = math.hypot(*self._world.controller.cartesian.tool[:3])
        swing_mm = 2.0 * length_mm * math.sin(math.radians(abs(asked.delta)) / 2.0)
        most_mm = max(abs(asked.delta), swing_mm if asked.along is None else 0.0) + _TOOL_MM
        for base in asked.bases:
            here = forward(base)
            way = [a - b for a, b in zip(reached[:3], here[:3], strict=True)]
            if max(map(abs, way)) > most_mm:
                continue
            wanted = way if asked.along is None else [asked.delta * each for each in asked.along]
            if max(abs(a - b) for a, b in zip(way, wanted, strict=True)) <= _ASIDE_MM:
                return None
            aside = True
        return "the tool steps another way" if aside else "the tool steps from elsewhere"

    # The stop ------------------------------------------------------------------------------------

    def _stop(self) -> list[Violation]:
        world = self._world
        if self._stop_s is None:
            return []
        if world.firmware.condition.stopped or world.firmware._off:
            self._stop_holds = True
            return []
        if self._stop_holds:
            self._stop_s = None
            return [Violation("S5", "a stop ended by itself", "the arm is no longer stopped")]
        if (
            self._stop_cannot_arrive()
            or world.controller.operating_state.link is LinkState.NO_DEVICE
        ):
            self._stop_s = world.time_s
            return []
        late_s = world.time_s - max(self._stop_s, self._suspended_s)
        if late_s <= _STOP_S + _LOOK_S:
            return []
        self._stop_s = None
        return [Violation("S2–S5", "a stop does not arrive", f"no stop after {late_s:.2f} s")]

    def _stop_cannot_arrive(self) -> bool:
        """Cut cables and broken lines, by name."""
        world, line = self._world, self._world.node.link
        identifiers = {0x150, 0x160, 0x170}
        return bool(
            not world.hears
            or line.off
            or line.loss
            or line.latency_s
            or line.deaf_to & identifiers
            or any(line._lost_to_arm[each] for each in identifiers)
            or world.firmware.leads
        )

    # What fails ----------------------------------------------------------------------------------

    def _motion_ends(self) -> list[Violation]:
        """S23: what nobody expected ends every motion of ours."""
        world, failed_s = self._world, self._failed_s
        if failed_s is None:
            return []
        anew = self._asked.cancelled != "failure"
        if anew or self._ours_deg is None or not world.firmware.mechanics.moving:
            self._failed_s = None if anew or world.time_s - failed_s > _END_S else failed_s
            return []
        if (
            self._stop_cannot_arrive()
            or world.controller.operating_state.link is LinkState.NO_DEVICE
            or world.time_s - self._other_s < _TO_ITSELF_S  # an end would cut the other's motion
        ):
            self._failed_s = world.time_s
            return []
        late_s = world.time_s - max(failed_s, self._suspended_s)
        if late_s <= _END_S:
            return []
        self._failed_s = None
        name = "" if world.breakage is None else world.breakage.chosen
        text = f"still moving {late_s:.2f} s after a failure ({name})"
        return [Violation("S23", f"{self._asked.kind.value} goes on after a failure", text)]

    def _in_zone(self) -> list[Violation]:
        """S32, S36: no motion of ours leads into the box, or deeper than others brought the arm."""
        if self.zone is None:
            self._deepest_mm = 0.0
            return []
        world, firmware = self._world, self._world.firmware
        deep_mm = max(depth_in_box_mm(firmware.reported_deg, *self.zone), 0.0)
        foreign = world.time_s - max(self._other_s, self._suspended_s, self._led_s) < _OTHERS_WAY_S
        powered = all(firmware.enabled) and not firmware.condition.stopped
        if foreign or self._mixed or not powered or not firmware.mechanics.moving:
            self._deepest_mm = deep_mm
            return []
        allowed_mm = self._deepest_mm + _NOISE_MM
        self._deepest_mm = min(self._deepest_mm, deep_mm)
        if deep_mm <= allowed_mm:
            return []
        text = f"{deep_mm:.1f} mm deep, {allowed_mm:.1f} allowed"
        return [Violation("S32", f"{self._asked.kind.value} leads into a zone", text)]

    def _first_arm(self) -> list[Violation]:
        """S15: after an exchange nothing of the first arm is shown."""
        if self._foreign is None:
            return []
        first, controller = self._foreign, self._world.controller
        state, operating_state = controller.state, controller.operating_state
        if self._world.time_s - first.left_s <= _LOOK_S:
            return []
        if first.version and first.version in (state.firmware or ""):
            return [Violation("S15", "the first arm's version after an exchange", first.version)]
        for joint, each in enumerate(operating_state.limits):
            true_deg = self._world.firmware.settings.limits[joint].max_deg
            if not operating_state.limits_read[joint] or each.max_deg == true_deg:
                continue
            if each.max_deg in first.limits_deg:
                text = f"joint {joint + 1}: {each.max_deg}"
                return [Violation("S15", "the first arm's limits after an exchange", text)]
        return []

    # What is shown -------------------------------------------------------------------------------

    def _stale(self) -> list[Violation]:
        world, controller = self._world, self._world.controller
        operating_state, state, now_s = controller.operating_state, controller.state, world.time_s
        if now_s - max(self._suspended_s, self._failed_anew_s) <= _LOOK_S:
            return []  # who looks got no turn, or fails at each
        limit_s = _OLD_S + _LOOK_S
        found: list[Violation] = []
        status_s = _age(state.status, now_s)
        angles_s = max((_age(each, now_s) for each in state.joints_deg), default=1e9)
        feedback_s = now_s - (state.last_feedback_s or -1e9)
        if (
            operating_state.link is LinkState.ONLINE
            and feedback_s > limit_s
            and state.last_feedback_s
        ):
            found.append(Violation("S18", "online though silent", f"silent for {feedback_s:.2f} s"))
        if operating_state.cannot_move is None and status_s > limit_s:
            text = f"0x2A1 is {status_s:.2f} s old and the arm may be moved"
            found.append(Violation("S9", "may move by an old 0x2A1", text))
        if operating_state.cannot_move is None and angles_s > limit_s:
            text = f"angles are {angles_s:.2f} s old and the arm may be moved"
            found.append(Violation("S9", "may move by old angles", text))
        if operating_state.stop is StopState.STOPPED and status_s > limit_s:
            text = f"0x2A1 is {status_s:.2f} s old and the stop is shown as confirmed"
            found.append(Violation("S6", "stopped by an old 0x2A1", text))
        return found

    def _exceptions(self) -> list[Violation]:
        world = self._world
        found = [
            Violation("exception", each.partition(": ")[2] or each, each)
            for each in world.errors
            if InjectedError.__name__ not in each
        ]
        found += [
            Violation("exception", f"part_failed {event.params}", str(event))
            for event in world.events
            if event.code == "part_failed" and world.time_s - self._failed_anew_s > _LOOK_S
        ]
        world.errors.clear()
        world.events.clear()
        return found


_FAMILY: Final = {
    0x151: "0x151",
    **dict.fromkeys((0x155, 0x156, 0x157), "0x155–0x157"),
    **dict.fromkeys((0x152, 0x153, 0x154), "0x152–0x154"),
}


def _age(heard: Any, now_s: float) -> float:
    return now_s - heard.at_s if heard is not None else 1e9


def _apart(first: Sequence[float], second: Sequence[float]) -> float:
    return max(abs(a - b) for a, b in zip(first, second, strict=True))


def _angles(joints_deg: Sequence[float]) -> str:
    return "(" + ", ".join(f"{angle:.1f}" for angle in joints_deg) + ")"
