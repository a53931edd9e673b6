"""What the arm still knows after the power was off."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from armui.protocol.addressing import Addressing
from armui.protocol.codes import ArmStatusCode, ControlMode, EndLoad, LinkageRole
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from armui.sim.parameters.flash import FileFlash, MemoryFlash, SettingsTextError, from_text, to_text
from armui.sim.parameters.settings import ArmSettingsRecord, HandleSettings, LinkageSettings
from tests.moments import now
from tests.sim.talk import BOTH, STOP, heard, mode, ready, target, tell

TWO = Generation.TWO
SET_EVERYTHING = (
    "474#010384FE3E009600",  # joint 1: 90°, −45°, 1.5 rad/s
    "475#0200AE00FA000000",  # joint 2: 2.5 rad/s²
    "479#0001000200030004",
    "47A#0001020304080000",
    "477#000000AE01000000",  # half load
    "47D#96640A0000000000",
    "475#03AE000000000000",  # joint 3: zero here
)
ASK_EVERYTHING = (
    "472#0101000000000000",
    "472#0202000000000000",
    "477#0100000000000000",
    "477#0200000000000000",
    "477#0400000000000000",
)
ANSWERS = [
    "473#010384FE3E009600",
    "47C#0200FA0000000000",
    "478#0001000200030004",
    "47B#0001020304080000",
    "47E#96640A0000000000",
]


def test_settings_survive_a_restart_in_a_file(tmp_path: Path) -> None:
    path = tmp_path / "arm.json"
    first = Firmware(TWO, joints_deg=(0, 90, -90, 0, 0, 0), flash=FileFlash(path))
    tell(first, *SET_EVERYTHING)
    flash = FileFlash(path)
    second = Firmware(TWO, joints_deg=(0, 90, -90, 0, 0, 0), flash=flash)
    assert tell(second, *ASK_EVERYTHING) == ANSWERS
    assert second.settings.load is EndLoad.HALF
    assert now(second.joints_deg) == (0, 90, 0, 0, 0, 0)
    assert flash.problem == ""
    assert [each.name for each in tmp_path.iterdir()] == ["arm.json"]


@pytest.mark.parametrize("generation", BOTH)
def test_a_power_cycle_forgets_the_moment_and_keeps_the_settings(generation: Generation) -> None:
    arm = ready(generation, (0, 110.0, -60.0, 0, 0, 0))
    tell(arm, "47A#0001020304080000", "477#0000010000000000", "121#0101051122330009")
    tell(arm, mode(50), *target(20.0, 110.0, -60.0, 0, 0, 0), "422#0100000000000000")
    arm.step(0.2)
    arm.power_cycle()
    assert arm.enabled == (False,) * 6
    assert (arm.condition.control_mode, arm.condition.speed_percent) == (ControlMode.STANDBY, 0)
    assert tell(arm, "477#0200000000000000") == ["47B#0001020304080000"]
    assert arm.settings.lights == {}
    before = arm.joints_deg
    said = arm.step(0.5)
    assert heard(said, 0x2A1)
    assert not heard(said, 0x481)
    assert arm.joints_deg[1] > before[1] + 1.0  # it drops
    assert arm.joints_deg[0] == before[0]  # and pursues nothing


def test_a_power_cycle_ends_an_emergency_stop() -> None:
    arm = ready()
    tell(arm, STOP)
    arm.power_cycle()
    assert arm.condition.status is ArmStatusCode.NORMAL
    assert not arm.condition.stopped


def test_offsets_take_effect_after_a_power_cycle() -> None:
    arm = Firmware(TWO)
    tell(arm, mode(50), "470#FC10200000000000")
    assert arm.addressing == Addressing()
    arm.power_cycle()
    assert arm.addressing == Addressing(feedback_offset=0x10, control_offset=0x20)
    assert Firmware(TWO, flash=arm.flash).addressing == arm.addressing


def test_a_host_that_repeats_itself_wears_no_flash() -> None:
    flash = MemoryFlash()
    arm = Firmware(TWO, flash=flash)
    tell(arm, *["47A#0001020304080000"] * 200, *ASK_EVERYTHING)
    assert flash.writes == 1


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (b"", "not JSON"),
        (b"\xff" * 64, "can't decode byte"),
        (b"[" * 100_000, "not JSON"),
        (b"{}", "not a settings file of format 1"),
        (b'{"format": 1}', "teaching is missing"),
    ],
)
def test_a_broken_file_is_kept_aside(tmp_path: Path, content: bytes, reason: str) -> None:
    path = tmp_path / "arm.json"
    path.write_bytes(content)
    flash = FileFlash(path)
    arm = Firmware(TWO, flash=flash)
    assert arm.settings == ArmSettingsRecord()
    assert flash.problem.startswith(f"{path} is broken, factory values in use: ")
    assert reason in flash.problem
    assert flash.problem.endswith("; kept as arm.json.broken")
    assert (tmp_path / "arm.json.broken").read_bytes() == content
    tell(arm, "47A#0001020304080000")
    assert FileFlash(path).load().collision_levels == (0, 1, 2, 3, 4, 8)
    assert flash.problem == ""


def test_a_truncated_file_is_broken(tmp_path: Path) -> None:
    path = tmp_path / "arm.json"
    text = to_text(ArmSettingsRecord())
    for length in range(0, len(text) - 1, 97):
        path.write_text(text[:length], encoding="utf-8")
        flash = FileFlash(path)
        assert flash.load() == ArmSettingsRecord()
        assert flash.problem


def test_a_folder_that_is_not_there_is_told_and_the_arm_goes_on(tmp_path: Path) -> None:
    flash = FileFlash(tmp_path / "nowhere" / "arm.json")
    arm = Firmware(TWO, flash=flash)
    assert tell(arm, "47A#0001020304080000") == ["476#7A00000000000000"]
    assert flash.problem == f"cannot write {flash.path}: No such file or directory"
    assert tell(arm, "477#0200000000000000") == ["47B#0001020304080000"]


def test_a_folder_in_place_of_the_file_is_told(tmp_path: Path) -> None:
    flash = FileFlash(tmp_path)
    assert flash.load() == ArmSettingsRecord()
    assert flash.problem.startswith(f"cannot read {tmp_path}, factory values in use: ")


def test_a_failed_write_leaves_the_old_file_and_no_other(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "arm.json"
    flash = FileFlash(path)
    flash.save(ArmSettingsRecord())
    before = path.read_bytes()

    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr("os.fsync", full)
        flash.save(ArmSettingsRecord(load=EndLoad.FULL))
    assert flash.problem == f"cannot write {path}: No space left on device"
    assert path.read_bytes() == before
    assert list(tmp_path.iterdir()) == [path]
    flash.save(ArmSettingsRecord(load=EndLoad.FULL))
    assert flash.problem == ""
    assert FileFlash(path).load().load is EndLoad.FULL


def test_corrupt_limits_survive_as_they_are() -> None:
    arm = Firmware(TWO)
    arm.corrupt_limits(4)
    again = Firmware(TWO, flash=arm.flash)
    assert tell(again, "472#0401000000000000") == ["473#04FFFFFFFFFFFF00"]


def test_text_and_back() -> None:
    settings = ArmSettingsRecord(
        collision_levels=(0, 8, 1, 2, 3, 4),
        load=EndLoad.HALF,
        teaching=HandleSettings(150, 100, 10),
        linkage=LinkageSettings(LinkageRole.TEACHING_INPUT, 0x10, 0x20, 0x10),
        zeros_deg=[0.1, -2.5, 3.0, 0.0, 0.0, 1e-9],
    )
    assert from_text(to_text(settings)) == settings


@pytest.mark.parametrize(
    ("part", "value", "reason"),
    [
        ("collision_levels", [1, 1, 1, 1, 1, 9], "collision_levels.6. holds 9"),
        ("collision_levels", [1, 1, 1, 1, 1, True], "collision_levels.6. holds True"),
        ("load", 3, "load holds 3"),
        ("load", None, "load holds None"),
        ("zeros_deg", [0, 0, 0, 0, 0, "1"], "zeros_deg holds .*'1'"),
        ("zeros_deg", [0, 0, 0, 0, 0, float("nan")], "zeros_deg holds .*nan"),
        ("end_limits", [1, 1, 1], "end_limits holds .* where .4 "),
        ("limits", [1] * 6, "limits.1. holds 1 where"),
        ("limits", [{"min_deg": 1, "max_deg": 2}] * 6, "limits.1..max_speed_deg_s is missing"),
        ("teaching", {"range_percent": 99}, "range_percent holds 99"),
        ("linkage", {"role": 0xFC, "feedback_offset": 5}, "feedback_offset holds 5"),
        ("linkage", None, "linkage holds None"),
        ("format", 2, "not a settings file"),
    ],
)
def test_text_that_says_something_else_is_refused(part: str, value: object, reason: str) -> None:
    record = json.loads(to_text(ArmSettingsRecord()))
    record[part] = value
    with pytest.raises(SettingsTextError, match=reason):
        from_text(json.dumps(record))


def test_a_value_of_the_teaching_handle_that_is_not_there_is_the_factory_s() -> None:
    record = json.loads(to_text(ArmSettingsRecord(teaching=HandleSettings(150, 100, 10))))
    del record["teaching"]["friction"]
    assert from_text(json.dumps(record)).teaching == HandleSettings(150, 100, 1)


@pytest.mark.parametrize("figures", [{"friction": 11}, {"stroke_limit_mm": 50}, {"friction": None}])
def test_a_value_of_the_teaching_handle_out_of_its_range_is_named(
    figures: dict[str, int | None],
) -> None:
    record = json.loads(to_text(ArmSettingsRecord()))
    record["teaching"] |= figures
    with pytest.raises(SettingsTextError, match=next(iter(figures))):
        from_text(json.dumps(record))
