"""What the DBC files promise to every tool that opens them."""

from __future__ import annotations

import re

import cantools
import pytest

from armui.protocol import codes
from armui.protocol.firmware_version import MitLayout
from armui.protocol.generation import Generation
from armui.protocol.layout import database_path, load_database
from armui.system.paths import RESOURCES
from tests.protocol.rows import GENERATION_1, GENERATION_2, ROWS

MESSAGES = [
    (generation, message)
    for generation in Generation
    for message in load_database(generation).messages
]
SIGNALS = [(generation, m, signal) for generation, m in MESSAGES for signal in m.signals]
FEEDBACK = {*range(0x2A1, 0x2A9), *range(0x251, 0x257), *range(0x481, 0x487)}
SLOW = set(range(0x261, 0x267))
UNITS = {
    "", "deg", "mm", "rpm", "rpm/s", "rad/s", "rad/s^2", "m/s", "m/s^2", "A", "V", "degC", "N.m",
    "rad", "pulse", "s", "%",
}  # fmt: skip


FILES = [
    "agx_gen1.dbc",
    "agx_gen2.dbc",
    "agx_gen2_until_1.8-7.dbc",
]


def test_these_are_the_files():
    folder = RESOURCES / "protocol"
    assert sorted(path.name for path in folder.iterdir()) == FILES
    assert {database_path(g, layout).name for g in Generation for layout in MitLayout} == set(FILES)


def test_the_files_of_generation_2_differ_in_the_mit_frames_only():
    newer, older = ((RESOURCES / "protocol" / name).read_text() for name in FILES[1:])
    own = re.compile(
        r'VERSION .*|CM_ SG_ 3(4[6-9]|5[01]) (Torque|Crc4) ".*";'
        r"| SG_ (Torque : 51\|(8|12)@0\+|Crc4 : 59\|4@0\+) .* ARM"
    )
    shared = [
        [line for line in text.splitlines() if not own.fullmatch(line)] for text in (newer, older)
    ]
    assert shared[0] == shared[1]
    mit = {f"MitControl{joint}" for joint in range(1, 7)}
    for layout, bits in ((MitLayout.A, (8, 4)), (MitLayout.B, (12,))):
        for message in load_database(Generation.TWO, layout).messages:
            if message.name in mit:
                assert tuple(signal.length for signal in message.signals)[4:] == bits


@pytest.mark.parametrize("name", FILES)
def test_loads_strictly_and_is_plain_ascii(name):
    path = RESOURCES / "protocol" / name
    path.read_text(encoding="ascii")
    database = cantools.database.load_file(path, strict=True)
    assert [node.name for node in database.nodes] == ["HOST", "ARM"]


@pytest.mark.parametrize("name", FILES)
def test_survives_being_written_by_cantools(name):
    database = cantools.database.load_file(RESOURCES / "protocol" / name, strict=True)
    again = cantools.database.load_string(database.as_dbc_string(), "dbc", strict=True)
    assert {m.name: m.frame_id for m in again.messages} == {
        m.name: m.frame_id for m in database.messages
    }


def test_standard_identifiers_motorola_byte_order_and_known_units():
    for _, message in MESSAGES:
        assert not message.is_extended_frame
        assert message.senders
        for signal in message.signals:
            assert signal.byte_order == "big_endian", (message.name, signal.name)
            assert (signal.unit or "") in UNITS, (message.name, signal.name)


def test_every_message_has_a_comment():
    assert [message.name for _, message in MESSAGES if not message.comment] == []


def test_cycle_times():
    """Generation 1: 20 ms and 100 ms by the text; generation 2: 200 Hz and 40 Hz as seen."""
    periods = {Generation.ONE: (20, 100), Generation.TWO: (5, 25)}
    for generation, message in MESSAGES:
        fast_ms, slow_ms = periods[generation]
        expected = {True: fast_ms}.get(message.frame_id in FEEDBACK)
        if message.frame_id in SLOW:
            expected = slow_ms
        row = next(row for row in ROWS[generation] if row.name == message.name)
        expected = row.cycle_ms or expected
        assert (message.cycle_time or None) == expected, (generation, message.name)


def test_ranges_lie_within_the_bits_and_are_whole_for_angles_and_positions():
    for generation, message, signal in SIGNALS:
        low = -(2 ** (signal.length - 1)) if signal.is_signed else 0
        high = low + 2**signal.length - 1
        assert signal.minimum is not None
        assert signal.maximum is not None
        raw_low = round((signal.minimum - signal.offset) / signal.scale)
        raw_high = round((signal.maximum - signal.offset) / signal.scale)
        where = (generation, message.name, signal.name)
        assert low <= raw_low <= raw_high <= high, where
        assert raw_low < raw_high or signal.choices, where
        if signal.length == 32:
            assert (raw_low, raw_high) == (low, high), where


def test_flags_and_codes_have_words():
    """A unitless byte is a code with a table unless it counts something."""
    counts = re.compile(
        r"Lamp|Red|Green|Blue|Counter|TrajectoryPoint|Byte\d|J\d|Friction|Crc4|K[pd]"
    )
    for generation, message, signal in SIGNALS:
        if signal.length <= 8 and not signal.unit and not counts.fullmatch(signal.name):
            assert signal.choices, (generation, message.name, signal.name)


def test_the_generations_share_names():
    one, two = ({m.name: m.frame_id for m in load_database(g).messages} for g in Generation)
    assert one.items() < two.items()
    with_rows = {row.name for row in GENERATION_2} - {row.name for row in GENERATION_1}
    assert two.keys() - one.keys() == with_rows


def _as_member(word: str) -> str:
    camel = re.sub(r"(?<=[a-z])(?=[A-Z])", "_", word) if " " not in word else word
    return re.sub(r"\W+", "_", camel).upper()


TABLES = [
    (codes.ControlMode, "ArmStatus", "ControlMode"),
    (codes.ArmStatusCode, "ArmStatus", "Status"),
    (codes.MoveMode, "ArmStatus", "MoveMode"),
    (codes.TeachingState, "ArmStatus", "TeachingState"),
    (codes.TeachingState, "MotionCommand", "TeachingCommand"),
    (codes.MotionState, "ArmStatus", "MotionState"),
    (codes.StopCommand, "MotionCommand", "EmergencyStop"),
    (codes.TrajectoryCommand, "MotionCommand", "TrajectoryCommand"),
    (codes.MitMode, "ModeControl", "MitMode"),
    (codes.Mounting, "ModeControl", "Mounting"),
    (codes.ArcPointNumber, "ArcPoint", "Point"),
    (codes.SilenceMode, "BusSilence", "Mode"),
    (codes.LinkageRole, "LinkageSetting", "Role"),
    (codes.MotorAction, "MotorEnable", "Action"),
    (codes.LimitQuery, "LimitQuery", "Query"),
    (codes.ParameterQuery, "ParameterCommand", "Query"),
    (codes.FactoryReset, "ParameterCommand", "Reset"),
    (codes.EndLoad, "ParameterCommand", "Load"),
    (codes.GripperMeasure, "GripperCommand", "Measure"),
    (codes.GripperMeasure, "GripperFeedback", "Measure"),
    (codes.CpvAction, "CpvControl1", "Action"),
    (codes.CpvKind, "CpvControl6", "Kind"),
    (codes.LeaderZero, "LeaderZero", "Command"),
]


@pytest.mark.parametrize(("enumeration", "message", "signal"), TABLES)
def test_codes_agree_with_the_value_tables(enumeration, message, signal):
    members = {int(member): member.name for member in enumeration}
    table_2 = load_database(Generation.TWO).get_message_by_name(message).get_signal_by_name(signal)
    assert {raw: _as_member(str(word)) for raw, word in table_2.choices.items()} == members
    one = load_database(Generation.ONE)
    messages_1 = [each for each in one.messages if each.name == message]
    for signal_1 in (each for message_1 in messages_1 for each in message_1.signals):
        if signal_1.name == signal:
            words = {raw: _as_member(str(word)) for raw, word in signal_1.choices.items()}
            assert words.items() <= members.items()


def test_setting_index_is_the_low_byte_of_the_setting_it_names():
    for generation in Generation:
        database = load_database(generation)
        table = database.get_message_by_name("SettingResponse").get_signal_by_name("Index").choices
        for raw, word in table.items():
            assert database.get_message_by_name(str(word)).frame_id & 0xFF == raw
        if generation is Generation.TWO:
            words = {raw: _as_member(str(word)) for raw, word in table.items()}
            assert {int(m): m.name for m in codes.SettingIndex}.items() <= words.items()


def test_a_host_may_ask_for_every_kind_of_motion_or_for_none():
    mode = load_database(Generation.TWO).get_message_by_name("ModeControl")
    choices = mode.get_signal_by_name("MoveMode").choices
    assert choices is not None
    assert sorted(choices) == [*map(int, codes.MoveMode), codes.MOVE_UNCHANGED]


def test_a_host_may_not_ask_for_what_only_the_arm_reports():
    """Remote control and linked teaching input (5, 6) are in 0x2A1 but not in 0x151."""
    for generation in Generation:
        mode = load_database(generation).get_message_by_name("ModeControl")
        choices = mode.get_signal_by_name("ControlMode").choices
        assert choices is not None
        assert sorted(choices) == [0, 1, 2, 3, 4] + ([7] if generation is Generation.TWO else [])
