"""Jogs at 100 % into a plane from many places: how near the simulated arm comes.

`python -m tests.safety.many_area_jogs 1000` says the least gap of all, in mm; below 0 is inside.
`... 1000 arcs` sends arcs by MOVE C instead, `... 1000 runs` runs of two points that were checked.
"""

import os
import sys

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

import numpy as np
from PySide6.QtCore import QCoreApplication

from armui.arm.refusal import Refusal
from armui.cell.area_check import AREA_IN_THE_WAY, AREA_ONLY_OUT
from armui.control.motion.jog_path import JointJog, ToolJog
from armui.control.parameters.arm_model import arm_model
from armui.kinematics.axes import JogFrame
from armui.protocol.generation import PiperModel
from armui.trajectory.planning.check import AREA_TOO_NEAR, CheckRequest
from armui.trajectory.planning.check import check as check_way
from armui.trajectory.points.program import Trajectory
from tests.arm_rig import ArmRig
from tests.cell.areas import check_of, gap_mm, put, wall
from tests.cell.test_enclosure import random_deg
from tests.control.jogger import bend, hold
from tests.control.under_way import run_of, to

_FAR_MM = 20.0
_LONGEST_S = 4.0


def jog(rig, number):
    """Jog until it ends; whether the wall ended it."""
    axis = number % 7
    jog = ToolJog(0, 1, JogFrame.BASE) if axis == 6 else JointJog(axis + 1, 1 if number % 2 else -1)
    rig.controller.jogging.start(jog)
    for _ in range(round(_LONGEST_S / 0.02)):
        yield False
        if not rig.controller.jogging.active:
            break
    reasons = [each.params.get("reason") for each in rig.events if each.code == "jog_ended"]
    yield any(isinstance(each, Refusal) and each.reason == AREA_IN_THE_WAY for each in reasons)


def arc(rig, number):
    """Send an arc; whether it was refused because of the wall."""
    rng = np.random.default_rng(number)
    x, y, z, *turn = rig.controller.cartesian.tool_pose(rig.controller.state)
    middle, end = ((*(np.array((x, y, z)) + rng.uniform(-60, 60, 3)), *turn) for _ in range(2))
    answer = rig.controller.cartesian.move_arc((x, y, z, *turn), middle, end)
    yield from until_rest(rig, answer)


def run_two(rig, number):
    """Check a run of two points and let it go if nothing speaks against it; whether it was not."""
    here = rig.controller.state.angles_deg()
    targets = np.array(here) + np.random.default_rng(number).uniform(-20, 20, (2, 6))
    points = [to(tuple(map(float, np.round(each, 2)))) for each in targets]
    content, area = Trajectory("test", points=tuple(points)), rig.controller.area_guard.check()
    outcome = check_way(CheckRequest(content, arm_model(rig.controller), here, area=area))
    refusals = [each for each in outcome.errors if each.kind == AREA_TOO_NEAR]
    answer = AREA_IN_THE_WAY() if refusals else AREA_ONLY_OUT()
    yield from until_rest(
        rig, answer if outcome.errors else rig.controller.player.start(run_of(*points))
    )


def until_rest(rig, answer):
    """Wait for a motion that may have been refused; whether the wall was the reason."""
    for tick in range(0 if isinstance(answer, Refusal) else round(2 * _LONGEST_S / 0.02)):
        yield False
        if tick > 25 and not rig.controller.operating_state.moving:
            break
    yield isinstance(answer, Refusal) and answer.reason == AREA_IN_THE_WAY


KINDS = {"jogs": jog, "arcs": arc, "runs": run_two}


def nearest_mm(place, number, kind):
    """Move from a pose towards a wall; the least gap, and whether the wall ended or forbade it."""
    rig = ArmRig(f"{kind}{number}")
    bend(rig, tuple(map(float, place)))
    zone = wall(_FAR_MM - gap_mm(place, wall(0.0)))
    put(rig.controller, zone)
    check, nearest, barred = check_of(zone), _FAR_MM, False
    for answer in KINDS[kind](rig, number):
        barred = answer
        hold(rig, 0.02)
        nearest = min(nearest, check.nearest_entries(rig.firmware.joints_deg)[0].gap_mm)
    for _ in range(15):
        hold(rig, 0.02)
        nearest = min(nearest, check.nearest_entries(rig.firmware.joints_deg)[0].gap_mm)
    rig.controller.shutdown()
    return nearest, barred


def main(count, kind="jogs"):
    """Tell the least gap of so many motions, and how many the plane has ended or forbidden."""
    application = QCoreApplication([])
    places = np.round(random_deg(PiperModel.PIPER, count, 3) * 0.8, 1)
    found, left_out = [], 0
    for number, place in enumerate(places):
        try:
            found.append(nearest_mm(place, number, kind))
        except AssertionError:  # the computer was too busy for the bus thread
            left_out += 1
    gaps = np.array([gap for gap, _ in found])
    ended = sum(by_area for _, by_area in found)
    print(f"{len(found)} {kind}, {ended} ended by the plane; least gap {gaps.min():.1f} mm")
    print(f"{left_out} left out")
    application.quit()


if __name__ == "__main__":
    main(int(sys.argv[1]), *sys.argv[2:])
