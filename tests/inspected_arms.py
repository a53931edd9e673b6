"""How often the joint inspection is wrong, over many arms: ``python -m tests.inspected_arms``.

Each arm is another: its friction, its noise, its load, its place, its warmth, how late its reports
come. It is asked to swing as the program asks it, and judged by the program's own figures.
"""

from __future__ import annotations

import argparse
import os
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass

import numpy as np

from armui.arm.inspection_record import Finding, InspectionEntry, JointFigures, Sign, findings
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
from armui.trajectory.samples.recording import SampleCursor
from armui.trajectory.samples.swing_samples import swing_recording
from armui.ways.swings import Swing

STEP_S = 0.005
"""Arms report 200 times a second."""
PLACES = ((0, 70, -60, 0, 20, 0), (30, 90, -90, 20, -30, 40), (-60, 50, -40, -40, 40, -90))
FRICTION_SPREAD = 0.2
"""Joints of one kind differ by so much (1 σ), and half as much from day to day."""
CURRENT_NOISE_A = 0.08
ANGLE_NOISE_DEG = 0.01
AMBIENT_SPREAD_C = 3.0
LATEST_S = 0.004
"""A report is stamped up to so much later than it was true."""
DRY_NM = np.array(JointLosses().dry_nm)


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
    place = PLACES[int(own.integers(len(PLACES)))]
    amplitude = float(own.uniform(10.0, 30.0))
    kind = ArmType.of(PiperModel.PIPER, str(RECOMMENDED))
    mechanics = Mechanics(place, Weight(kind.links))
    weight = float(own.choice(list(PAYLOADS_KG.values())))
    mechanics.weight.payload_kg = mechanics.weight.told_kg = weight
    drivers = Drivers(arm.number, kind.nm_per_ampere)
    for index in range(6):
        drivers.motor_temperatures_c[index] += today.normal(0.0, AMBIENT_SPREAD_C)
        drivers.driver_temperatures_c[index] += today.normal(0.0, AMBIENT_SPREAD_C)
    mechanics.power_on(range(6))
    mechanics.drag_nm = tuple(friction.tolist())
    swings = [Swing(joint, amplitude, amplitude) for joint in JOINTS]
    recording, windows, speed_deg_s = swing_recording("arm", place, swings, 1.0)
    cursor = SampleCursor(recording)
    limits = kind.model.limits
    speeds = [each.max_speed_deg_s for each in limits]
    at_s = np.arange(0.0, recording.duration_s, STEP_S)
    target_deg: tuple[float, ...] = place
    rows, due_s = [], 0.0
    for now_s in at_s:
        if now_s >= due_s:
            target_deg = cursor.joints_deg_at(float(now_s))
            mechanics.move_to(target_deg, speeds, kind.model.accelerations_deg_s2)
            due_s += PERIOD_MS / 1e3 + today.uniform(-LATEST_S, LATEST_S)
        mechanics.step(STEP_S, limits)
        drivers.measure(mechanics)
        for index in range(6):
            drivers.warm(index, STEP_S)
        measured = mechanics.positions_deg, drivers.currents_a, drivers.motor_temperatures_c
        rows.append((target_deg, *map(tuple, measured), tuple(drivers.driver_temperatures_c)))
    told = np.array(rows)
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


def _figures(at_s, heard_s, told, window, speed_deg_s) -> JointFigures | None:
    rows = (at_s >= window.begin_s) & (at_s <= window.end_s)
    sent = at_s[rows], told[rows, 0]
    names = ("angle", "current", "motor", "driver")
    heard = {name: (heard_s[rows], told[rows, column]) for column, name in enumerate(names, 1)}
    return figures_of({"target": sent, **heard}, speed_deg_s, signed=True)


def judged(arm: Arm) -> tuple[tuple[Finding, ...], tuple[Finding, ...]]:
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
    options.add_argument("--processes", type=int, default=max(1, (os.cpu_count() or 1) - 1))
    asked = options.parse_args()
    with ProcessPoolExecutor(asked.processes) as pool:
        healthy = list(pool.map(judged, map(Arm, range(asked.arms))))
        for name, place in (("the first inspection", 0), ("with two earlier ones", 1)):
            wrong = sum(bool(each[place]) for each in healthy)
            print(f"healthy arms, {name}: {wrong} false alarms in {asked.arms}")
            for sign in Sign:
                count = sum(any(f.sign is sign for f in each[place]) for each in healthy)
                print(f"    {sign.name.lower()}: {count}")
        few = max(6, asked.arms // 10)
        for times in (0.5, 1.0, 2.0, 3.0, 5.0):
            arms = [Arm(1000 + n, 1 + n % 6, times) for n in range(few)]
            found = list(zip(arms, pool.map(judged, arms), strict=True))
            shares = [
                sum(any(f.joint == arm.stiff for f in each[place]) for arm, each in found)
                for place in (0, 1)
            ]
            print(
                f"a joint with {times:g} times its dry friction more: found in {shares[0]} of "
                f"{few} at the first inspection, in {shares[1]} with two earlier ones"
            )


if __name__ == "__main__":
    main()
