"""How often the joint inspection is wrong, over many arms: ``python -m tests.inspected_arms``.

Each arm is another: its friction, its noise, its load, its place, its warmth, how late its reports
come. Some swings are driven through the simulated joints and their drivers, once without dry
friction and once with 1 N·m of it in each; as both angle and current depend on it linearly, every
arm with a friction of its own follows. What it reports is judged by the program's own figures.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from functools import cache

import numpy as np
import numpy.typing as npt

from armui.arm.inspection_record import (
    InspectionEntry,
    JointFigures,
    JointFinding,
    JointSign,
    findings,
)
from armui.arm.limits import JOINTS
from armui.control.run.replayer import PERIOD_MS
from armui.protocol.firmware_version import RECOMMENDED
from armui.protocol.generation import PiperModel
from armui.sim.arm_type import ArmType
from armui.sim.mechanics.drivers import Drivers
from armui.sim.mechanics.gravity import PAYLOADS_KG, Weight
from armui.sim.mechanics.joint_dynamics import JointLosses
from armui.sim.mechanics.mechanics import Mechanics
from armui.telemetry.swing_figures import figures_of
from armui.trajectory.samples.recording import Recording, SampleCursor
from armui.trajectory.samples.swing_samples import SwingTimes, swing_recording
from armui.ways.swings import Swing

STEP_S = 0.005
"""Arms report 200 times a second."""
PLACES = ((0, 70, -60, 0, 20, 0), (30, 90, -90, 20, -30, 40), (-60, 50, -40, -40, 40, -90))
AMPLITUDES_DEG = (10.0, 20.0, 30.0)
FRICTION_SPREAD = 0.2
"""Joints of one kind differ by so much (1 σ), and half as much from day to day."""
CURRENT_NOISE_A = 0.08
ANGLE_NOISE_DEG = 0.01
AMBIENT_SPREAD_C = 3.0
LATEST_S = 0.004
"""A target is sent, and a report stamped, up to so much later than it should be."""
DRY_NM = np.array(JointLosses().dry_nm)
Array = npt.NDArray[np.float64]
Windows = tuple[tuple[SwingTimes, ...], float]
"""When each joint swings, and at which speed."""


@dataclass(frozen=True)
class Arm:
    """One arm.

    Attributes:
        number: Its own; by it all that is chance is always the same.
        stiff: The joint (1–6) that is stiff; 0: none.
        times: By how many times its dry friction it has more.
    """

    number: int
    stiff: int = 0
    times: float = 0.0


@cache
def swung(
    place: int, amplitude_deg: float
) -> tuple[Array, Array, Array, tuple[tuple[SwingTimes, ...], float]]:
    """Have a simulated arm swing.

    Returns:
        When it reported; (n, 5, 6) targets, angles, currents, temperatures of motors and drivers
        without dry friction; what each N·m of it adds; the windows of the joints.
    """
    swings = [Swing(joint, amplitude_deg, amplitude_deg) for joint in JOINTS]
    recording, windows, speed_deg_s = swing_recording("arm", PLACES[place], swings, 1.0)
    at_s = np.arange(0.0, recording.duration_s, STEP_S)
    without, with_one = (_driven(place, recording, at_s, drag_nm) for drag_nm in (0.0, 1.0))
    return at_s, without, with_one - without, (windows, speed_deg_s)


def _driven(place: int, recording: Recording, at_s: Array, drag_nm: float) -> Array:
    kind = ArmType.of(PiperModel.PIPER, str(RECOMMENDED))
    mechanics, drivers = (
        Mechanics(PLACES[place], Weight(kind.links)),
        Drivers(0, kind.nm_per_ampere),
    )
    load_kg = list(PAYLOADS_KG.values())[place]
    mechanics.weight.payload_kg = mechanics.weight.told_kg = load_kg
    mechanics.power_on(range(6))
    mechanics.drag_nm = (drag_nm,) * 6
    cursor, chance = SampleCursor(recording), np.random.default_rng(place)
    speeds = [each.max_speed_deg_s for each in kind.model.limits]
    target_deg: tuple[float, ...] = PLACES[place]
    rows, due_s = [], 0.0
    for now_s in at_s.tolist():
        if now_s >= due_s:
            target_deg = cursor.joints_deg_at(now_s)
            mechanics.move_to(target_deg, speeds, kind.model.accelerations_deg_s2)
            due_s += PERIOD_MS / 1e3 + chance.uniform(-LATEST_S, LATEST_S)
        mechanics.step(STEP_S, kind.model.limits)
        drivers.measure(mechanics)
        for index in range(6):
            drivers.warm(index, STEP_S)
        warm = tuple(drivers.motor_temperatures_c), tuple(drivers.driver_temperatures_c)
        rows.append((target_deg, mechanics.positions_deg, drivers.currents_a, *warm))
    return np.array(rows)


def inspect(arm: Arm, day: int = 0, times: float | None = None) -> InspectionEntry:
    """Have an arm swing, and return what the program measures.

    Args:
        arm: The arm.
        day: On another day its noise, its warmth and a part of its friction are others.
        times: As in :class:`Arm`, on that day.
    """
    own, today = np.random.default_rng(arm.number), np.random.default_rng((arm.number, day))
    friction = DRY_NM * np.clip(own.normal(1.0, FRICTION_SPREAD, 6), 0.3, 2.0)
    friction *= np.clip(today.normal(1.0, FRICTION_SPREAD / 2, 6), 0.5, 1.5)
    if arm.stiff:
        more = arm.times if times is None else times
        friction[arm.stiff - 1] += more * DRY_NM[arm.stiff - 1]
    place, amplitude = int(own.integers(len(PLACES))), float(own.choice(AMPLITUDES_DEG))
    at_s, without, of_each_nm, (windows, speed_deg_s) = swung(place, amplitude)
    told = without + of_each_nm * friction
    told[:, 3:] += today.normal(0.0, AMBIENT_SPREAD_C, (2, 6))
    heard_s = at_s + STEP_S + today.uniform(0.0, LATEST_S, len(at_s))
    told[:, 1] = np.round(told[:, 1] + today.normal(0.0, ANGLE_NOISE_DEG, told[:, 1].shape), 3)
    told[:, 2] = np.round(told[:, 2] + today.normal(0.0, CURRENT_NOISE_A, told[:, 2].shape), 3)
    told[:, 3:] = np.round(told[:, 3:])
    return InspectionEntry(
        "2026-11-27T12:00:00",
        speed_deg_s,
        tuple(
            _figures(at_s, heard_s, told[..., window.joint - 1], window, speed_deg_s)
            for window in windows
        ),
    )


def _figures(
    at_s: Array, heard_s: Array, told: Array, window: SwingTimes, speed_deg_s: float
) -> JointFigures | None:
    rows = (at_s >= window.begin_s) & (at_s <= window.end_s)
    sent = at_s[rows], told[rows, 0]
    names = ("angle", "current", "motor", "driver")
    heard = {name: (heard_s[rows], told[rows, column]) for column, name in enumerate(names, 1)}
    return figures_of({"target": sent, **heard}, speed_deg_s, signed=True)


def judged(arm: Arm) -> tuple[tuple[JointFinding, ...], tuple[JointFinding, ...]]:
    """Return what stands out of an arm beside its joints alone, and beside two earlier days, too.

    The stiff joint was healthy on those days.
    """
    now, earlier = inspect(arm), [inspect(arm, day, times=0.0) for day in (1, 2)]
    assert None not in now.joints
    return findings(now, ()), findings(now, earlier)


def main() -> None:
    """Tell the false alarms of healthy arms, and how many stiff joints are found."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--arms", type=int, default=200)
    asked = options.parse_args()
    healthy = [judged(Arm(number)) for number in range(asked.arms)]
    for name, place in (("the first inspection", 0), ("with two earlier ones", 1)):
        wrong = sum(bool(each[place]) for each in healthy)
        print(f"healthy arms, {name}: {wrong} false alarms in {asked.arms}")
        for sign in JointSign:
            count = sum(any(f.sign is sign for f in each[place]) for each in healthy)
            print(f"    {sign.name.lower()}: {count}")
    for times in (0.5, 1.0, 2.0, 3.0, 5.0):
        arms = [Arm(100_000 + n, 1 + n % 6, times) for n in range(asked.arms)]
        found = [(arm, judged(arm)) for arm in arms]
        shares = [
            sum(any(f.joint == arm.stiff for f in each[place]) for arm, each in found) / len(arms)
            for place in (0, 1)
        ]
        print(
            f"a joint with {times:g} times its dry friction more is found in {shares[0]:.0%} of "
            f"{asked.arms} at the first inspection, in {shares[1]:.0%} with two earlier ones"
        )


if __name__ == "__main__":
    main()
