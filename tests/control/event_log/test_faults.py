"""Every fault of the simulated arm: in events with its beginning and its end, in the right row."""

from __future__ import annotations

import can
import pytest

from armui.arm import joint_status
from armui.arm.joint_status import Item, Word
from armui.arm.parameters import Batch, Group, Parameter
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.sim.faults.schedule import FAULTS, fault
from armui.telemetry.events import EventKind, Level
from armui.ui.words import event_log as words
from armui.ui.words.arm import joint_item, joint_word
from tests.accepted import accepted
from tests.family import FACTORY_LIMITS

ONE, TWO = Generation.ONE, Generation.TWO
REST_DEG = (0.0,) * 6


def status(code):
    return "arm_status", {"status": code}


def row(item, word, joint=1):
    return "joint_fault", {"joint": joint, "item": item.name, "word": word.name}


def both(*events):
    return {ONE: events, TWO: events}


HOT = row(Item.MOTOR_TEMPERATURE, Word.TOO_HOT)
SEEN = {
    "joint-communication": both(status(5), row(Item.COMMUNICATION, Word.ABNORMAL)),
    "motor-overtemperature": both(status(9), HOT),
    "driver-overtemperature": both(status(9), row(Item.DRIVER_TEMPERATURE, Word.TOO_HOT)),
    "undervoltage": both(
        status(9), *(row(Item.SUPPLY_VOLTAGE, Word.TOO_LOW, joint) for joint in range(1, 7))
    ),
    "overcurrent": both(status(9), row(Item.DRIVER_CURRENT, Word.OVERCURRENT)),
    # generation 2 has no bit for the encoder: its driver fails
    "sensor-error": {
        ONE: (status(9), row(Item.SENSOR, Word.ABNORMAL)),
        TWO: (status(9), row(Item.DRIVER_FAULT, Word.ERROR)),
    },
    "driver-error": both(status(9), row(Item.DRIVER_FAULT, Word.ERROR)),
    # generation 1 has no bits for these two: the arm's status says it alone
    "stall": {ONE: (status(9),), TWO: (status(9), row(Item.STALL_PROTECTION, Word.TRIGGERED))},
    "collision": {
        ONE: (status(7),),
        TWO: (status(7), row(Item.COLLISION_PROTECTION, Word.TRIGGERED)),
    },
    "corrupt-limits": both(("limits_unusable", {"joint": 1})),
    "feedback-stopped": both(("offline", {})),
    "bus-off": both(("offline", {})),
    "power-off": both(("offline", {})),
    "deaf-adapter": both(("offline", {})),
    "garbage": both(("invalid_frames", {"kind": "UNKNOWN_ID"})),
    "lost-frames": both(("fewer_frames", {})),
}
"""What each fault is called in the events of each generation."""

MEASURED = {"latency", "lost-reference", "stiff-joint", "hot-joint", "slip"}
"""What no frame tells: how long an answer takes; what the reference watch, the joint inspection and
the comparison at a resume conclude from angles, currents and temperatures."""
LATE_S = {"offline": 0.6, "fewer_frames": 8.1}
"""What is only known after a while: half a second of silence, three spans of two seconds after the
one in which it begins."""


def test_every_fault_is_in_the_table():
    assert set(SEEN) | MEASURED == set(FAULTS)


class Log:
    """The events of a rig since a moment."""

    def __init__(self, rig):
        self.rig = rig
        self.number = rig.controller.events.newest

    def entries(self):
        return [each for each in self.rig.controller.events.entries() if each.number > self.number]

    def find(self, event):
        """The entry of an expected event, or ``None``."""
        code, figures = event
        for entry in self.entries():
            told = {name: entry.params.get(name) for name in figures}
            if entry.code == code and told == figures:
                return entry
        return None

    def all_go_on(self, events):
        return all((found := self.find(event)) is not None and found.goes_on for event in events)

    def all_ended(self, events):
        return all((found := self.find(event)) is not None and found.ended_s for event in events)

    def rows(self):
        """The faults of the joints that go on, as the table 关节状态 has them."""
        return {
            (each.params["joint"], Item[each.params["item"]], Word[each.params["word"]])
            for each in self.entries()
            if each.code == "joint_fault" and each.goes_on
        }


def mend(rig, name):
    """Take the cause away, and do what the arm wants before it forgets the fault."""
    if "overtemperature" in name:  # cooling takes minutes
        drivers = rig.firmware.drivers
        drivers.motor_temperatures_c[0] = drivers.driver_temperatures_c[0] = 30.0
    if name in {"overcurrent", "driver-error", "sensor-error", "stall", "collision"}:
        rig.run(0.1)
        accepted(rig.controller.joint_errors.clear(1))
    if name == "corrupt-limits":  # the operator sets them anew
        limits = FACTORY_LIMITS[0]
        values = (limits.min_deg, limits.max_deg, limits.max_speed_deg_s)
        names = ("min_angle_deg", "max_angle_deg", "max_speed_deg_s")
        changes = {Parameter(each, 1): value for each, value in zip(names, values, strict=True)}
        accepted(rig.controller.settings.save(changes))


@pytest.mark.each_value(full="each fault in both generations")
@pytest.mark.parametrize("name", SEEN)
def test_it_begins_and_ends_in_the_events(any_rig, name):
    rig = any_rig
    rig.ready()
    if name == "lost-frames":
        rig.run(4.1)  # how many come when none is lost
    log, begun_s, expected = Log(rig), rig.time_s, SEEN[name][rig.firmware.generation]
    broken = fault(name)
    rig.node.faults.start(broken)
    if name == "stall":
        accepted(rig.controller.motion.send_joints((30.0, *REST_DEG[1:])))
    if name == "corrupt-limits":
        assert rig.controller.settings.read([Batch(Group.JOINT_LIMITS, 1)]) is None
    rig.run_until(lambda: log.all_go_on(expected), 8.0)
    state, generation = rig.controller.state, rig.firmware.generation
    assert log.rows() == set(joint_status.faults(state, generation))
    for event in expected:
        entry = log.find(event)
        assert begun_s <= entry.at_s <= begun_s + LATE_S.get(event[0], 0.15)
        assert entry.level in {Level.WARNING, Level.FAULT}
    rig.run(0.2)
    ended_s = rig.time_s
    rig.node.faults.end(broken)
    mend(rig, name)
    rig.run_until(lambda: log.all_ended(expected), 8.0)
    for event in expected:
        entry = log.find(event)
        late_s = LATE_S.get(event[0], 0.4)
        # of frames, the last one is the end: it came before
        assert ended_s - 0.05 <= entry.ended_s <= ended_s + late_s
        assert not entry.unheard
    assert log.rows() == set()


@pytest.mark.parametrize("language", ["en", "zh"])
def test_a_row_has_the_words_of_the_table(rig, language, translated):
    translated(language)
    rig.ready()
    log = Log(rig)
    rig.node.faults.start(fault("motor-overtemperature", 4))
    hot = row(Item.MOTOR_TEMPERATURE, Word.TOO_HOT, 4)
    rig.run_until(lambda: log.all_go_on([hot]))
    text = words.entry_text(log.find(hot))
    assert "J4" in text
    assert joint_item(Item.MOTOR_TEMPERATURE).rstrip(":") in text
    assert joint_word(Word.TOO_HOT) in text


def test_a_late_answer_is_measured(rig):
    rig.ready()
    rig.run(0.5)
    late = fault("latency", 0.15)
    rig.node.faults.start(late)
    rig.run(0.5)
    accepted(rig.controller.joint_errors.clear(1))
    (entry,) = [each for each in rig.controller.events.entries() if each.code == "clear_error_sent"]
    rig.run_until(lambda: rig.controller.events.get(entry.number).answer is not None)
    entry = rig.controller.events.get(entry.number)
    assert 0.28 <= entry.answer.at_s - entry.at_s <= 0.4


def test_a_fault_of_one_frame_is_in_the_events(rig):
    """Between two looks of the window: five milliseconds."""
    rig.ready()
    log = Log(rig)
    collision = Frame(0x2A1, bytes.fromhex("01 07 01 00 00 00 00 00"))
    rig.node._bus.send(can.Message(arbitration_id=0x2A1, data=collision.data, is_extended_id=False))
    rig.step()
    entry = log.find(status(7))
    assert entry is not None
    assert entry.ended_s is not None
    assert entry.ended_s - entry.at_s < 0.05


def test_a_fault_that_is_still_there_after_a_new_connection_is_told_again(rig):
    rig.ready()
    log = Log(rig)
    overcurrent = row(Item.DRIVER_CURRENT, Word.OVERCURRENT)
    rig.node.faults.start(fault("overcurrent"))
    rig.run_until(lambda: log.all_go_on([overcurrent]))
    rig.controller.disconnect_device()
    entry = log.find(overcurrent)
    assert entry.unheard
    assert entry.ended_s is not None
    log.number = rig.controller.events.newest
    rig.connect()
    rig.run_until(lambda: log.all_go_on([overcurrent]))


def test_an_arm_in_order_has_no_faults(any_rig):
    rig = any_rig
    rig.ready()
    accepted(rig.controller.motion.send_joints((10.0, 20.0, -20.0, 0.0, 0.0, 0.0)))
    rig.run(6.0)
    grave = [
        each.code
        for each in rig.controller.events.entries()
        if each.kind in {EventKind.FAULT, EventKind.ODDITY} or each.level is not Level.INFO
    ]
    assert set(grave) <= {"online", "enabled"}
