"""S32, S1, S15: whatever else is on the bus during a jog, the arm stays out of a zone."""

import pytest

from armui.protocol.frame import Frame
from tests.accepted import accepted
from tests.cell.areas import gap_mm, put
from tests.control.jogger import BENT_DEG, bend, hold
from tests.safety.test_s32_work_area import OUTWARDS, drive, wall_before

STOP = Frame(0x150, bytes.fromhex("01 00 00 00 00 00 00 00"))


def angles(deg, offset=0):
    """The six angles as the arm reports them, or another arm with other identifiers."""
    for place in range(3):
        pair = [round(1000.0 * each) & 0xFFFFFFFF for each in deg[2 * place : 2 * place + 2]]
        yield f"{0x2A5 + place + offset:03X}#" + "".join(f"{each:08X}" for each in pair)


def turned(by_deg):
    return tuple(angle + by_deg for angle in BENT_DEG)


SAID = {
    "impossible angles": list(angles((2e6,) * 6)),
    "angles of an arm with another offset": list(angles(turned(-30.0), 0x10)),
    "angles that lag behind": list(angles(turned(-10.0))),
    "angles that run ahead": list(angles(turned(10.0))),
    "cut angles": ["2A5#0000", "2A6#", "2A7#000000000000"],
    "a status that no table knows": ["2A1#FFFFFFFFFFFFFFFF"],
    "a status of another offset": ["2B1#0100010001000000"],
    "limits without end": [f"473#0{joint}2EE0D1207FFF00" for joint in range(1, 7)],
    "accelerations without end": [f"47C#0{joint}FFFF0000000000" for joint in range(1, 7)],
    "another version": ["4AF#532D56312E382D31", "4AF#3235303932350031"],
    "unknown identifiers": [f"{each:03X}#0011223344556677" for each in range(0x600, 0x632)],
    "all of the highest priority": ["000#"] * 50,
}


@pytest.fixture
def arm_repeats():
    return False


@pytest.mark.each_value(full="each sort of frame during both jogs")
@pytest.mark.parametrize("lines", SAID.values(), ids=SAID)
@pytest.mark.parametrize("jog", ["tool", "joint"])
def test_a_jog_towards_a_wall_never_enters(rig, other_host, lines, jog):
    """Said 100 times a second from the first moment on; after that a stop is heard as ever."""
    bend(rig)
    rig.zones = (wall_before(BENT_DEG, 40.0),)
    put(rig.controller, *rig.zones)
    hold(rig, 0.2)
    accepted(rig.controller.jogging.start(OUTWARDS[jog]))
    stream = other_host.stream(lambda _t: lines, rate_hz=100.0)
    nearest = drive(rig, OUTWARDS[jog], 3.0)
    if rig.controller.jogging.active:
        rig.controller.jogging.stop()
        hold(rig, 0.3)
    assert min(nearest, gap_mm(rig.firmware.joints_deg, *rig.zones)) >= 9.0
    rig.heard()
    rig.controller.emergency_stop()
    assert STOP in rig.heard()
    stream.end()
    rig.run_until(lambda: rig.firmware.condition.stopped)
