"""Every event has its sentence in both languages, whatever its figures are."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator
from datetime import UTC, datetime
from itertools import product
from typing import Any

import pytest
from PySide6.QtWidgets import QApplication

from armui.arm.joint_status import FAULTS, Item
from armui.arm.state import GripperFault
from armui.control.authority_watch import MOTION_CUT
from armui.control.event_log.collector import NOT_KEPT, PROBLEM, RUN_POINT
from armui.control.event_log.log_events import (
    LOGGED_DISCARDED,
    LOGGED_EPISODE,
    LOGGED_GRIPPER_JUMP,
    LOGGED_TARGETS,
    UNKNOWN_MARK,
)
from armui.control.event_log.observed import Observed
from armui.control.event_log.observer import (
    ARM_STATUS,
    BEYOND_LIMIT,
    CONTROL_MODE,
    FEWER_FRAMES,
    GRIPPER_FAULT,
    INVALID_FRAMES,
    JOINT_FAULT,
    LIMITS_UNUSABLE,
    MOTORS_OFF,
    MOTORS_ON,
    MOVE_MODE,
    OTHER_FRAMES,
    TEACHING,
)
from armui.control.events import Notice
from armui.control.link.link_state import LINK_LOST
from armui.control.motion.motion_command import End
from armui.control.operations.started import ANSWERED
from armui.protocol.codec import InvalidFrameKind
from armui.setting_checks import Language
from armui.system.sentence import Sentence
from armui.telemetry.event_json import from_record
from armui.telemetry.events import Asker, EventEntry, EventKind, EventOutcome, Level
from armui.ui.translation import Translator
from armui.ui.words import event_log as words
from armui.ui.words.text import NOT_KNOWN
from tests.each import check_each
from tests.translations import constants

pytestmark = pytest.mark.usefixtures("trees_end_with_the_module")

InBoth = Callable[[Iterable[Any], Callable[[Any], str]], list[tuple[Any, str, str]]]
"""Of each entry its text in English and in Chinese."""

FIGURES: dict[Observed, dict[str, object]] = {
    CONTROL_MODE: {"mode": 1, "before": 0},
    MOVE_MODE: {"mode": 2, "before": 1},
    ARM_STATUS: {"status": 7},
    TEACHING: {"state": 1, "before": 0},
    MOTORS_ON: {"joints": (1, 2)},
    MOTORS_OFF: {"joints": (3,)},
    JOINT_FAULT: {"joint": 3, "item": "DRIVER_CURRENT", "word": "OVERCURRENT"},
    BEYOND_LIMIT: {"joint": 2},
    GRIPPER_FAULT: {"fault": "Overcurrent"},
    LIMITS_UNUSABLE: {"joint": 2},
    OTHER_FRAMES: {"id": "0x155"},
    INVALID_FRAMES: {"kind": "UNKNOWN_ID", "id": "0x4F0"},
    FEWER_FRAMES: {"share": 12},
    RUN_POINT: {"row": 7},
    MOTION_CUT: {"end": "STOPPED"},
    ANSWERED: {"index": "0x71"},
    PROBLEM: {"reason": LINK_LOST()},
    NOT_KEPT: {"text": "No space left on device"},
    LOGGED_TARGETS: {"message": "MitControl1"},
    LOGGED_EPISODE: {"number": 3, "task": "stack the cubes"},
    LOGGED_DISCARDED: {"number": 3, "task": "stack the cubes"},
    LOGGED_GRIPPER_JUMP: {"before": 95.8, "after": 0.1, "unit": "deg", "within_ms": 5.0},
    UNKNOWN_MARK: {"code": "another_planet"},
}


def ids_of(kind: type[Sentence]) -> list[str]:
    return [each.id for each in constants() if each.context == kind.context]


@pytest.fixture
def translated(qapp: QApplication) -> Iterator[Callable[[Language], None]]:
    translator = Translator(qapp)
    yield translator.set_language
    translator.set_language("en")


def entry(what: Sentence | str, params: dict[str, object] | None = None) -> EventEntry:
    return EventEntry(
        *(1, 0.0, datetime(2026, 1, 15, tzinfo=UTC), Level.INFO, EventKind.STATUS, Asker.ARM),
        code=str(what),
        params=params or {},
    )


@pytest.fixture
def in_both(translated: Callable[[Language], None]) -> InBoth:
    """Reads every entry of a table in English, then in Chinese."""

    def read(entries: Iterable[Any], text: Callable[[Any], str]) -> list[tuple[Any, str, str]]:
        entries = list(entries)
        translated("en")
        english = [text(each) for each in entries]
        translated("zh")
        chinese = [text(each) for each in entries]
        return list(zip(entries, english, chinese, strict=True))

    return read


def test_what_was_observed(in_both):
    def check_words(case):
        code, english, chinese = case
        assert english
        assert any("\u4e00" <= letter <= "\u9fff" for letter in chinese)
        assert english != chinese
        for text in (english, chinese):
            assert NOT_KNOWN not in text
            assert "{" not in text
            assert f": {code}" not in text

    def text(what):
        return words.entry_text(entry(what, FIGURES.get(what, {})))

    check_each(in_both(map(Observed, ids_of(Observed)), text), check_words)


def test_what_was_noticed(in_both):
    def check_words(case):
        _code, english, chinese = case
        assert english != chinese
        assert "{" not in english + chinese

    check_each(in_both(ids_of(Notice), lambda code: words.entry_text(entry(code))), check_words)


def test_what_ends_a_motion(in_both):
    def cut(end):
        return EventOutcome(MOTION_CUT.id, 0.0, Level.INFO, {"end": end})

    def check_words(case):
        end, english, chinese = case
        assert english != chinese
        assert end not in english + chinese.upper()

    ends = [*(each.name for each in End), "short"]
    check_each(in_both(ends, lambda end: words.outcome_text(cut(end))), check_words)


def test_what_is_odd_about_a_frame(in_both):
    def odd(kind):
        return entry(INVALID_FRAMES, {"kind": kind.name, "id": "0x4F0"})

    def check_words(case):
        kind, english, chinese = case
        assert kind.value.split()[0] in english
        assert kind.value.split()[0] not in chinese

    check_each(in_both(InvalidFrameKind, lambda kind: words.entry_text(odd(kind))), check_words)


def test_the_gripper(in_both):
    def trouble(fault):
        return entry(GRIPPER_FAULT, {"fault": fault.value})

    def check_words(case):
        _fault, english, chinese = case
        assert english != chinese

    check_each(in_both(GripperFault, lambda each: words.entry_text(trouble(each))), check_words)


def test_every_row_and_word_of_the_joints():
    def check_words(case):
        item, word = case
        text = words.entry_text(
            entry(JOINT_FAULT, {"joint": 5, "item": item.name, "word": word.name})
        )
        assert text.startswith("J5 ")
        assert NOT_KNOWN not in text

    check_each(product(Item, FAULTS), check_words)


def test_columns_and_filters(in_both):
    def check_words(case):
        _code, english, chinese = case
        assert english != chinese

    check_each(in_both(Asker, words.asker), check_words)
    check_each(in_both(EventKind, words.event_kind), check_words)
    check_each(in_both(Level, words.event_level), check_words)


def test_settings_are_named_with_their_values():
    sent = entry(
        "settings_sent",
        {"count": 2, "values": (("max_angle_deg", 2, 100.0), ("max_linear_speed_m_s", 0, 0.3))},
    )
    text = words.entry_text(sent)
    assert "J2" in text
    assert "100" in text
    assert "0.3" in text


@pytest.mark.parametrize(
    ("code", "figures"),
    [
        ("joint_fault", {"joint": 1, "item": "NO_SUCH", "word": "NEITHER"}),
        ("gripper_fault", {"fault": 7}),
        ("control_mode", {"mode": "x", "before": []}),
        ("teaching_sent", {"command": 99}),
        ("settings_sent", {"values": (("no_such", 1, 2.0),)}),
        ("settings_sent", {"values": (1, 2)}),
        ("motors_on", {"joints": "1, 2"}),
        ("of a newer program", {"x": 1}),
    ],
)
def test_figures_of_another_program_are_shown_as_they_are(code, figures):
    assert words.entry_text(entry(code, figures))


OLD_LINE = (
    '{"number":7,"wall":"2026-05-02T10:00:00.000+08:00","at_s":12.5,"level":"warning",'
    '"kind":"program","who":"program","code":"problem","params":{"reason":{"refusal":"jog_at_limit",'
    '"params":{"joint":3,"limit":-12.5}}}}'
)
"""As older versions wrote it, which kept the reason's id and figures only."""


def test_an_event_of_an_older_file_reads_as_a_sentence(translated):
    read = from_record(json.loads(OLD_LINE))
    translated("en")
    assert words.entry_text(read) == "J3 is at its limit of -12.5°. Jog the other way."
    translated("zh")
    assert words.entry_text(read) == "J3 已到限位 -12.5°，请向反方向点动。"


def test_a_reason_of_a_newer_program_is_named(translated):
    read = from_record(json.loads(OLD_LINE.replace("jog_at_limit", "jog_on_the_moon")))
    translated("en")
    said = "Not possible now: jog_on_the_moon(joint=3, limit=-12.5)."
    assert words.entry_text(read) == said
