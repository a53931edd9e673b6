"""Bytes of 0x261–0x266 and 0x2A1 in, the manual's table of the joints out."""

from datetime import datetime, timedelta

import pytest

from armui.arm.joint_status import (
    Item,
    JointHistory,
    StatusVerdict,
    Word,
    Worst,
    faults,
    is_stale,
    rows,
    worst,
)
from armui.arm.limits import JOINTS
from armui.arm.state import ArmState
from armui.arm.tracker import Tracker
from armui.protocol.codec import Codec
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from tests.each import check_each

NOON = datetime(2026, 1, 2, 12, 0, 0).astimezone()
ENABLED = 0x40

BOTH = {
    Item.SUPPLY_VOLTAGE: (0, Word.NORMAL, Word.TOO_LOW),
    Item.MOTOR_TEMPERATURE: (1, Word.NORMAL, Word.TOO_HOT),
    Item.DRIVER_CURRENT: (2, Word.NORMAL, Word.OVERCURRENT),
    Item.DRIVER_TEMPERATURE: (3, Word.NORMAL, Word.TOO_HOT),
    Item.DRIVER_FAULT: (5, Word.NORMAL, Word.ERROR),
    Item.DRIVER_ENABLED: (6, Word.DISABLED, Word.ENABLED),
}
BITS = {
    Generation.ONE: {
        **BOTH,
        Item.SENSOR: (4, Word.NORMAL, Word.ABNORMAL),
        Item.HOMED: (7, Word.NOT_HOMED, Word.HOMED),
    },
    Generation.TWO: {
        **BOTH,
        Item.COLLISION_PROTECTION: (4, Word.NORMAL, Word.TRIGGERED),
        Item.STALL_PROTECTION: (7, Word.NORMAL, Word.TRIGGERED),
    },
}
CASES = [(generation, item) for generation, bits in BITS.items() for item in bits]


class Arm:
    """Six drivers and a controller, told by their bytes; the table is kept as a window keeps it."""

    def __init__(self, generation):
        self.generation = generation
        self.codec = Codec(generation)
        self.tracker = Tracker(self.codec)
        self.history = JointHistory()
        self.at = NOON
        self.state = ArmState()

    def hear(self, arbitration_id, payload, at_s=1.0):
        frame = Frame(arbitration_id, bytes.fromhex(payload))
        self.tracker.update(self.codec.decode(frame), at_s)
        self.state = self.tracker.snapshot()
        return self.history.add_state(self.state, self.generation, self.at)

    def driver(self, joint, code, at_s=1.0):
        # 24.0 V, driver 31 °C, motor 29 °C
        return self.hear(0x260 + joint, f"00F0 001F 1D {code:02X} 0000", at_s)

    def status(self, broken=0x00, at_s=1.0):
        return self.hear(0x2A1, f"01 00 01 00 00 00 00 {broken:02X}", at_s)

    def well(self):
        self.status()
        for joint in JOINTS:
            self.driver(joint, ENABLED)

    def cell(self, item, joint):
        return self.history.cell(self.state, self.generation, item, joint)

    def worst(self):
        return worst(self.state, self.generation, faults(self.state, self.generation))


@pytest.fixture
def arm(generation):
    return Arm(generation)


# The table ----------------------------------------------------------------------------------------


def test_the_rows_are_the_manuals_ten_and_two_of_them_change_with_the_generation():
    one, two = rows(Generation.ONE), rows(Generation.TWO)
    assert (len(one), len(two)) == (10, 10)
    assert [(old.name, new.name) for old, new in zip(one, two, strict=True) if old != new] == [
        ("SENSOR", "COLLISION_PROTECTION"),
        ("HOMED", "STALL_PROTECTION"),
    ]
    assert rows(None) == one


def test_nothing_heard_is_nothing_said(arm):
    for item in rows(arm.generation):
        for joint in JOINTS:
            cell = arm.cell(item, joint)
            assert (cell.word, cell.value, cell.since, cell.stale) == (None, None, None, False)
    assert arm.worst() == Worst(StatusVerdict.UNKNOWN)


@pytest.mark.parametrize(("generation", "item"), CASES)
@pytest.mark.parametrize("joint", [1, 6])
def test_each_bit_is_one_word_in_one_cell(generation, item, joint):
    arm = Arm(generation)
    bit, when_clear, when_set = BITS[generation][item]
    others = [other for other in BITS[generation] if other is not item]
    arm.driver(joint, 0x00)
    before = [arm.cell(other, joint).word for other in others]
    assert arm.cell(item, joint).word is when_clear

    arm.driver(joint, 1 << bit)
    assert arm.cell(item, joint).word is when_set
    assert [arm.cell(other, joint).word for other in others] == before
    assert arm.cell(item, 3).word is None

    arm.driver(joint, 0x00)
    assert arm.cell(item, joint).word is when_clear


def test_the_status_code_is_the_byte_of_the_bus(generation):
    def check_code(code):
        arm = Arm(generation)
        arm.driver(2, code)
        assert arm.state.drivers_slow[1].value.status_code == code
        assert arm.cell(Item.STATUS_CODE, 2).value == code

    check_each(range(256), check_code)


def test_the_generation_decides_what_bits_4_and_7_say(generation):
    arm = Arm(generation)
    arm.driver(1, 0x90)
    said = [arm.cell(item, 1).word for item in (Item.SENSOR, Item.HOMED)]
    new = [arm.cell(item, 1).word for item in (Item.COLLISION_PROTECTION, Item.STALL_PROTECTION)]
    if generation is Generation.ONE:
        assert (said, new) == ([Word.ABNORMAL, Word.HOMED], [None, None])
    else:
        assert (said, new) == ([None, None], [Word.TRIGGERED, Word.TRIGGERED])


def test_before_the_generation_is_known_those_bits_say_nothing():
    arm = Arm(Generation.TWO)  # what is spoken until the arm has answered
    arm.generation = None
    arm.status()
    for joint in JOINTS:
        arm.driver(joint, 0xC0)
    assert arm.cell(Item.HOMED, 1).word is None
    assert arm.cell(Item.STALL_PROTECTION, 1).word is None
    assert arm.worst() == Worst(StatusVerdict.UNKNOWN)


@pytest.mark.parametrize("joint", JOINTS)
def test_a_broken_connection_to_a_joint_is_in_its_column(arm, joint):
    arm.status(broken=1 << (joint - 1))
    words = [arm.cell(Item.COMMUNICATION, each).word for each in JOINTS]
    assert words == [Word.ABNORMAL if each == joint else Word.NORMAL for each in JOINTS]
    arm.status()
    assert arm.cell(Item.COMMUNICATION, joint).word is Word.NORMAL


def test_the_figures_stand_behind_the_words(arm):
    arm.driver(4, ENABLED)
    # generation 1: 10 rpm = 60 °/s, 0.1 A steps; generation 2: rad/s and mA
    arm.hear(
        0x254, "000A 0005 00000000" if arm.generation is Generation.ONE else "03E8 01F4 00000000"
    )
    assert arm.cell(Item.SUPPLY_VOLTAGE, 4).value == 24
    assert arm.cell(Item.MOTOR_TEMPERATURE, 4).value == 29
    assert arm.cell(Item.DRIVER_TEMPERATURE, 4).value == 31
    fast = arm.state.drivers_fast[3].value
    assert fast.current_a > 0
    assert arm.cell(Item.DRIVER_CURRENT, 4).value == fast.current_a
    assert arm.cell(Item.DRIVER_ENABLED, 4).value == fast.speed_deg_s > 0
    assert arm.cell(Item.COMMUNICATION, 4).value is None


def test_a_driver_that_falls_silent_goes_stale_while_the_others_do_not(arm):
    arm.well()
    arm.driver(2, ENABLED, at_s=1.6)
    assert is_stale(arm.state, Item.SUPPLY_VOLTAGE, 1)
    assert is_stale(arm.state, Item.COMMUNICATION, 2)
    assert not is_stale(arm.state, Item.SUPPLY_VOLTAGE, 2)
    assert arm.cell(Item.SUPPLY_VOLTAGE, 1).word is Word.NORMAL


# Since when ---------------------------------------------------------------------------------------


def test_a_word_began_when_it_changed_and_not_when_it_was_repeated(arm):
    arm.driver(1, ENABLED)
    arm.at = NOON + timedelta(seconds=5)
    assert not arm.driver(1, ENABLED)
    assert arm.cell(Item.SUPPLY_VOLTAGE, 1).since == NOON
    assert arm.driver(1, ENABLED | 0x01)
    assert arm.cell(Item.SUPPLY_VOLTAGE, 1).since == arm.at
    assert arm.cell(Item.MOTOR_TEMPERATURE, 1).since == NOON


def test_a_table_that_is_forgotten_begins_anew(arm):
    arm.driver(1, ENABLED)
    arm.history.add_state(ArmState(), None, NOON)
    assert arm.history.since(Item.SUPPLY_VOLTAGE, 1) is None
    arm.at = NOON + timedelta(minutes=1)
    arm.history.add_state(arm.state, arm.generation, arm.at)
    assert arm.cell(Item.SUPPLY_VOLTAGE, 1).since == arm.at


# The worst of six ---------------------------------------------------------------------------------


def test_six_enabled_joints_without_fault_are_normal(arm):
    arm.well()
    assert arm.worst() == Worst(StatusVerdict.NORMAL)


def test_a_homed_joint_is_as_normal_as_one_that_is_not():
    arm = Arm(Generation.ONE)
    arm.well()
    arm.driver(3, ENABLED | 0x80)
    assert arm.worst() == Worst(StatusVerdict.NORMAL)


def test_disabled_joints_are_named(arm):
    arm.well()
    arm.driver(2, 0x00)
    arm.driver(5, 0x00)
    assert arm.worst() == Worst(StatusVerdict.DISABLED, (2, 5))


def test_a_joint_not_heard_is_worse_than_a_disabled_one(arm):
    arm.well()
    for joint in JOINTS:
        if joint != 4:
            arm.driver(joint, 0x00, at_s=2.0)
    arm.status(at_s=2.0)
    assert arm.worst() == Worst(StatusVerdict.UNKNOWN, (4,))


def test_without_the_arms_own_status_nothing_is_known(arm):
    for joint in JOINTS:
        arm.driver(joint, ENABLED)
    assert arm.worst() == Worst(StatusVerdict.UNKNOWN)


@pytest.mark.parametrize(
    ("generation", "item"), [case for case in CASES if BITS[case[0]][case[1]][1] is Word.NORMAL]
)
def test_any_fault_is_the_worst_and_goes_with_its_bit(generation, item):
    bit, _when_clear, when_set = BITS[generation][item]
    arm = Arm(generation)
    arm.well()
    arm.driver(1, 0x00)
    arm.driver(6, ENABLED | 1 << bit)
    assert faults(arm.state, generation) == [(6, item, when_set)]
    assert arm.worst() == Worst(StatusVerdict.FAULT, (6,))
    arm.driver(6, ENABLED)
    assert arm.worst() == Worst(StatusVerdict.DISABLED, (1,))


def test_two_faults_of_a_joint_name_it_once(arm):
    arm.well()
    arm.driver(3, 0x03)
    arm.status(broken=0x05)
    assert arm.worst() == Worst(StatusVerdict.FAULT, (1, 3))


def test_a_joint_that_falls_silent_with_a_fault_still_has_it(arm):
    arm.well()
    arm.driver(3, 0x04)
    arm.status(at_s=5.0)
    assert arm.worst() == Worst(StatusVerdict.FAULT, (3,))
