"""Jogs at 100 % into a plane from many places: how near the simulated arm comes.

`python -m tests.safety.many_area_jogs 1000` says the least gap of all, in mm; below 0 is inside.
"""

import os
import sys

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

import numpy as np
from PySide6.QtCore import QCoreApplication

from armui.arm.refusal import Refusal
from armui.cell.area_check import AREA_IN_THE_WAY
from armui.control.motion.jog_path import JointJog, ToolJog
from armui.kinematics.axes import JogFrame
from armui.protocol.generation import PiperModel
from tests.arm_rig import ArmRig
from tests.cell.areas import check_of, gap_mm, put, wall
from tests.cell.test_enclosure import random_deg
from tests.control.jogger import bend, hold

_FAR_MM = 20.0
_LONGEST_S = 4.0


def nearest_mm(place, number):
    """Jog from a pose towards a wall; the least gap, and whether the wall ended the jog."""
    rig = ArmRig(f"jogs{number}")
    bend(rig, tuple(map(float, place)))
    zone = wall(_FAR_MM - gap_mm(place, wall(0.0)))
    put(rig.controller, zone)
    check, axis = check_of(zone), number % 7
    jog = ToolJog(0, 1, JogFrame.BASE) if axis == 6 else JointJog(axis + 1, 1 if number % 2 else -1)
    rig.controller.jogging.start(jog)
    nearest = _FAR_MM
    for _ in range(round(_LONGEST_S / 0.02)):
        hold(rig, 0.02)
        nearest = min(nearest, check.look(rig.firmware.joints_deg)[0].gap_mm)
        if not rig.controller.jogging.active:
            break
    for _ in range(15):
        hold(rig, 0.02)
        nearest = min(nearest, check.look(rig.firmware.joints_deg)[0].gap_mm)
    reasons = [each.params.get("reason") for each in rig.events if each.code == "jog_ended"]
    rig.controller.shutdown()
    barred = [isinstance(each, Refusal) and each.reason == AREA_IN_THE_WAY for each in reasons]
    return nearest, any(barred)


def main(count):
    """Tell the least gap of so many jogs, and how many the plane has ended."""
    application = QCoreApplication([])
    places = np.round(random_deg(PiperModel.PIPER, count, 3) * 0.8, 1)
    found, left_out = [], 0
    for number, place in enumerate(places):
        try:
            found.append(nearest_mm(place, number))
        except AssertionError:  # the computer was too busy for the bus thread
            left_out += 1
    gaps = np.array([gap for gap, _ in found])
    ended = sum(by_area for _, by_area in found)
    print(f"{len(found)} jogs, {ended} ended by the plane; least gap {gaps.min():.1f} mm")
    print(f"{left_out} left out")
    application.quit()


if __name__ == "__main__":
    main(int(sys.argv[1]))
