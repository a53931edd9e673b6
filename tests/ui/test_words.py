"""Every code becomes words in both languages, and every figure finds its place in them."""

from __future__ import annotations

import re
import string
from collections.abc import Callable, Mapping
from dataclasses import replace
from datetime import datetime
from pathlib import Path

import pytest
from PySide6.QtWidgets import QApplication

from armui.arm.device import Device
from armui.arm.figures import PERCENT, check_figure
from armui.arm.limits import JOINT_NOT_A_NUMBER, JOINT_OUT_OF_LIMITS
from armui.arm.refusal import Reason, Refusal
from armui.bus.adapters import BUS_BACKEND_MISSING, BUS_DOWN
from armui.control.context import REFUSED
from armui.control.devices.motors import DISABLE_SENT, RESUME_SENT
from armui.control.events import Event, Level, Notice
from armui.control.link.connection import DISCONNECTED, LINK_LOST_NOTICE
from armui.control.motion.cartesian import POSE_UNKNOWN
from armui.control.motion.joint_motion import SENT_JOINTS
from armui.control.operating_state import BUSY
from armui.control.parameters.arm_settings import SETTINGS_SAVED
from armui.control.requests.reports import GENERATION
from armui.control.safety.interlocks import ARM_FAULT, JOINTS_UNKNOWN, NOT_ENABLED, OTHER_CONTROL
from armui.control.safety.recovery_steps import Step, StepKind
from armui.control.safety.stopping import STOP_NOT_SENT, STOP_SENT, STOP_UNCONFIRMED
from armui.protocol.codes import MoveMode
from armui.setting_fields import check
from armui.settings import SettingsStore
from armui.trajectory import columns, files
from armui.trajectory.files.text import NUMBER_BAD
from armui.trajectory.points.program import GripperOpening, Waypoint, check_point
from armui.ui import words
from armui.ui.translation import LANGUAGES, Language, Translator
from armui.ui.words.events import notice_text
from armui.ui.words.text import joined, sentence
from tests.each import check_each
from tests.translations import Constant, constants

pytestmark = pytest.mark.usefixtures("trees_end_with_the_module")

AT = datetime(2026, 1, 2, 3, 4, 5).astimezone()


@pytest.fixture
def chinese(translator: Translator) -> None:
    translator.set_language("zh")


def event(notice: Notice, **params: object) -> str:
    return words.event(Event(AT, notice, params))


def has_chinese(text: str) -> bool:
    return any("\u4e00" <= character <= "\u9fff" for character in text)


# Every code ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_sentence_of_the_code_reads_as_words(
    translator: Translator, language: Language
) -> None:
    translator.set_language(language)

    def check_words(each: Constant) -> None:
        for source in (each.source, *each.more):
            text = sentence(each.context, source, {})
            only_figures = not re.sub(r"J?\{\w+\}|[: ]", "", source)
            assert has_chinese(text) or language == "en" or only_figures
            assert "{" not in text

    check_each(constants(), check_words)


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_refusal_reads_as_sentences(translator: Translator, language: Language) -> None:
    translator.set_language(language)
    said = [each for each in constants() if each.context == Reason.context]
    reasons = {each.id: Reason(each.id, each.source) for each in said}

    def check_refusal(code: str) -> None:
        text = words.refusal(reasons[code]())

        assert has_chinese(text) is (language == "zh")
        assert code not in text
        assert "{" not in text
        assert text.endswith(("。", ".", "can_raw", "1000000", "pip install —", "libusb-1.0-0"))
        assert words.refusal(Refusal(Reason(code))) == text  # as a file names it

    check_each(sorted(reasons), check_refusal)


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_notice_reads_as_words(translator: Translator, language: Language) -> None:
    translator.set_language(language)

    def check_notice(code: str) -> None:
        text = event(Notice(code))  # as a file names it

        assert not text.startswith(("Event:", "事件"))
        assert "{" not in text
        assert has_chinese(text) is (language == "zh")

    check_each([each.id for each in constants() if each.context == Notice.context], check_notice)


def test_a_pose_that_is_not_known_is_no_matter_of_arcs(qapp: QApplication) -> None:
    said = "The arm reports no pose now. Wait until all six values are shown, none muted."
    assert words.refusal(POSE_UNKNOWN()) == said


def test_what_nobody_foresaw_is_still_said(qapp: QApplication) -> None:
    odd = Refusal(Reason("odd"), {"a": 1})
    assert words.refusal(odd) == "Not possible now: odd(a=1)."
    assert event(Notice("odd")) == "Event: odd"


# Files -------------------------------------------------------------------------------------------


PLACED = NUMBER_BAD(value="o")


@pytest.mark.parametrize(
    ("error", "expected"),
    [
        (files.TrajectoryFileError(PLACED, 4, 7, "a.log"), "a.log, line 4, column 7: "),
        (files.TrajectoryFileError(PLACED, 4, 0, "a.log"), "a.log, line 4: "),
        (files.TrajectoryFileError(PLACED, 0, 0, "a.log"), "a.log: "),
        (files.TrajectoryFileError(PLACED, 4, 7), "Line 4, column 7: "),
        (files.TrajectoryFileError(PLACED, 4), "Line 4: "),
        (files.TrajectoryFileError(PLACED), ""),
    ],
)
def test_what_is_wrong_with_a_file_names_its_place(
    qapp: QApplication, error: files.TrajectoryFileError, expected: str
) -> None:
    assert words.file_error(error) == f"{expected}“o” is not a number."


def test_a_figure_of_a_point_is_named_with_its_unit_and_limits(qapp: QApplication) -> None:
    point = Waypoint(MoveMode.MOVE_J, (0.0,) * 6, speed_percent=0)
    assert words.refusal(check_point(point) or PLACED) == (
        "Speed: 0% is out of range. Enter a value from 1% to 100%."
    )
    far = replace(point, speed_percent=1, gripper=GripperOpening(500.0))
    assert words.refusal(check_point(far) or PLACED) == (
        "Gripper opening: 500 mm is out of range. Enter a value from 0 mm to 200 mm."
    )
    missing = columns.check_mapping(columns.ColumnMapping(()))
    assert words.refusal(missing or PLACED) == (
        "Still missing: Time, J1, J2, J3, J4, J5, J6. Say which columns hold them."
    )


# Figures ------------------------------------------------------------------------------------------


def test_an_angle_out_of_limits_names_joint_value_and_limits(chinese: None) -> None:
    limits = {"joint": 2, "value": 181.0, "minimum": 0.0, "maximum": 180.0}

    assert words.refusal(JOINT_OUT_OF_LIMITS(**limits)) == (
        "关节 2：181° 超出限位 0° 至 180°。请输入限位以内的角度。"
    )


@pytest.mark.parametrize(
    ("refusal", "expected"),
    [
        (NOT_ENABLED(joints="1, 3"), "1、3"),
        (check_figure("percent", 101, PERCENT), "101 %"),
        (JOINT_NOT_A_NUMBER(joint=4, value="abc"), "“abc”"),
        (OTHER_CONTROL(mode=2), "示教模式"),
        (OTHER_CONTROL(mode=0x2F), "未知 (0x2F)"),
        (ARM_FAULT(status=7), "机械臂发生碰撞"),
        (BUSY(what="enabling"), "使能电机"),
        (BUS_DOWN(device="can0"), "ip link set can0 up"),
        (
            BUS_BACKEND_MISSING(device="a", package="gs_usb"),
            "install gs_usb",
        ),
    ],
)
def test_a_refusal_names_what_it_is_about(chinese: None, refusal: Refusal, expected: str) -> None:
    assert expected in words.refusal(refusal)


def test_a_notice_holds_the_reason_in_the_same_language(chinese: None) -> None:
    assert event(REFUSED, reason=JOINTS_UNKNOWN()) == (
        "未发送。现在没有收到全部关节角度。请等待 6 个关节的角度都显示出来且不变灰。"
    )


def test_a_notice_without_its_reason_ends_cleanly(qapp: QApplication) -> None:
    text = event(LINK_LOST_NOTICE, device="can0", reason=None)

    assert text == (
        "Connection to can0 lost: the arm is not heard, and it may be moving. The program keeps "
        "trying to reconnect."
    )


def test_six_angles_sent(chinese: None) -> None:
    angles = {f"j{n}": float(n) for n in range(1, 7)}

    assert event(SENT_JOINTS, **angles) == ("已发送 J1 1°  J2 2°  J3 3°  J4 4°  J5 5°  J6 6°")


def test_generation_1_has_no_firmware_text(qapp: QApplication) -> None:
    assert event(GENERATION, generation=1, firmware="").endswith("Firmware: —")


def test_a_simulated_arm_has_a_name_in_the_operators_language(chinese: None) -> None:
    device = Device("virtual", "x", None, simulated=True, generation=1)

    assert event(DISCONNECTED, device=device) == "已断开 仿真机械臂（第 1 代）"
    assert words.device_name(Device("socketcan", "can0")) == "socketcan can0"


@pytest.mark.parametrize(
    ("notice", "danger"),
    [
        (DISABLE_SENT, "机械臂会下落，请扶住机械臂"),
        (RESUME_SENT, "机械臂会下落，请扶住机械臂"),
        (STOP_SENT, "请扶住机械臂"),
        (STOP_UNCONFIRMED, "请切断其电源"),
        (STOP_NOT_SENT, "请切断其电源"),
    ],
)
def test_physical_danger_is_said_in_plain_words(chinese: None, notice: Notice, danger: str) -> None:
    assert danger in event(notice)


# What the settings say ----------------------------------------------------------------------------


def test_every_reason_the_settings_give_fills_its_sentence(
    translator: Translator, tmp_path: Path
) -> None:
    broken = tmp_path / "settings.json"
    broken.write_text("{")
    reasons = [
        *SettingsStore(broken).problems,
        check("jog_step_deg", 31.0),
        check("jog_step_deg", None),
        check("theme", "pink"),
    ]
    for language in LANGUAGES:
        translator.set_language(language)
        for reason in reasons:
            assert reason is not None
            assert "—" not in words.refusal(reason)


def test_a_setting_that_is_not_possible_is_named(chinese: None) -> None:
    refused = check("theme", "pink")
    assert refused is not None
    assert words.refusal(refused) == "设置项“主题”：“pink”无效，已使用默认值。"


# 0x2A1 --------------------------------------------------------------------------------------------

CONTROL_MODES = {
    0x00: "待机模式",
    0x01: "CAN 指令控制模式",
    0x02: "示教模式",
    0x03: "以太网控制模式",
    0x04: "wifi 控制模式",
    0x05: "遥控器控制模式",
    0x06: "联动示教输入模式",
    0x07: "离线轨迹模式",
}
ARM_STATUSES = {
    0x00: "正常",
    0x01: "急停",
    0x02: "无解",
    0x03: "奇异点",
    0x04: "目标角度超过限",
    0x05: "关节通信异常",
    0x06: "关节抱闸未打开",
    0x07: "机械臂发生碰撞",
    0x08: "拖动示教时超速",
    0x09: "关节状态异常",
    0x0A: "其它异常",
    0x0B: "示教记录",
    0x0C: "示教执行",
    0x0D: "示教暂停",
    0x0E: "主控过温",
    0x0F: "释放电阻过温",
}
MOVE_MODES = {
    0x00: "点位模式",
    0x01: "关节模式",
    0x02: "直线模式",
    0x03: "圆弧模式",
    0x04: "MIT 模式",
    0x05: "CPV 模式",
}
TEACHING = {
    0x00: "关闭",
    0x01: "开始示教记录（进入拖动示教模式）",
    0x02: "结束示教记录（退出拖动示教模式）",
    0x03: "执行示教轨迹（拖动示教轨迹复现）",
    0x04: "暂停执行",
    0x05: "继续执行（轨迹复现继续）",
    0x06: "终止执行",
    0x07: "运动到轨迹起点",
}
Word = Callable[[int], str]
TABLES: dict[Word, dict[int, str]] = {
    words.control_mode: CONTROL_MODES,
    words.arm_status: ARM_STATUSES,
    words.move_mode: MOVE_MODES,
    words.teaching: TEACHING,
}


@pytest.mark.parametrize("word", TABLES, ids=lambda word: word.__name__)
def test_the_codes_of_the_status_in_the_protocols_words(chinese: None, word: Word) -> None:
    table: Mapping[int, str] = TABLES[word]

    assert {code: word(code) for code in table} == table


@pytest.mark.parametrize("word", [*TABLES, words.control_mode_short])
def test_no_two_codes_share_a_word_in_english(qapp: QApplication, word: Word) -> None:
    table = TABLES.get(word, CONTROL_MODES)
    spoken = {word(code) for code in table}

    assert len(spoken) == len(table)
    assert not any(has_chinese(text) for text in spoken)


@pytest.mark.parametrize("word", [*TABLES, words.control_mode_short])
def test_codes_of_no_table_are_shown_as_numbers(translator: Translator, word: Word) -> None:
    assert word(0x2F) == "unknown (0x2F)"
    translator.set_language("zh")
    assert word(0x2F) == "未知 (0x2F)"
    assert word(0xFF) == "未知 (0xFF)"


def test_the_manuals_status_bar(chinese: None) -> None:
    assert (
        f"控制: {words.control_mode_short(0)} 状态: {words.arm_status(0)} "
        f"{words.move_mode(0)} {words.reached(True)}"
    ) == "控制: 待机 状态: 正常 点位模式 已达指定点"
    assert words.reached(False) == "未达指定点"


def test_sentences_use_only_plain_placeholders() -> None:
    said = [source for each in constants() for source in (each.source, *each.more)]
    for source in said:
        for _text, name, spec, conversion in string.Formatter().parse(str(source)):
            assert name is None or name.isidentifier()
            assert not spec
            assert conversion is None


def test_a_list_is_parted_as_the_language_does_it(chinese: None) -> None:
    assert sentence("Nowhere", "{it}", {"it": "0x151, 0x155"}) == "0x151、0x155"
    assert sentence("Nowhere", "{it}", {"it": "1, 2, 6"}) == "1、2、6"
    # a name is left as somebody wrote it
    assert sentence("Nowhere", "{it}", {"it": "pick, place"}) == "pick, place"


def test_several_joints_are_joints(qapp: QApplication) -> None:
    off = Step(StepKind.MOTORS_MIXED, Level.WARNING, joints=(1, 3, 4))
    for joints, told in (("3", "Without power: joint 3."), ("1, 3, 4", "power: joints 1, 3, 4.")):
        assert told in words.step(replace(off, params={"joints": joints}))


def test_saved_settings_are_named() -> None:
    def said(**figures: object) -> str:
        return notice_text(SETTINGS_SAVED, figures)

    one = said(count=1, settings="max_speed_deg_s.3")
    assert one == "Settings saved and read back: J3 Max. speed"
    level = " ".join(f"collision_level.{joint}" for joint in range(1, 7))
    assert said(count=6, settings=level).endswith("J4 Collision level, +2")
    assert said(count=6).endswith(": 6")  # a file of an older version


def test_after_a_wide_full_stop_there_is_no_space():
    assert joined("故障仍在。", "", "请检查。") == "故障仍在。请检查。"
    assert joined("It is there still.", "Check it.") == "It is there still. Check it."
