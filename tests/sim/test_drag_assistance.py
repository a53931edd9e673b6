"""0x487 sets, 0x477 = 5 asks, 0x488 answers: how much each joint helps the hand (from S-V1.8-1)."""

from __future__ import annotations

import pytest

from armui.protocol.codec import Codec
from armui.protocol.firmware_version import FirmwareVersion
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from armui.sim.parameters.flash import MemoryFlash, from_text, to_text
from armui.sim.parameters.parameter_server import ParameterServer
from armui.sim.parameters.settings import ArmSettingsRecord
from tests.sim.talk import tell

TWO = Generation.TWO
ASK = "477#0500000000000000"


def test_it_is_set_confirmed_and_read_back() -> None:
    arm = Firmware(TWO)
    assert tell(arm, ASK) == ["488#0505050505050000"]
    assert tell(arm, "487#000A01FFFFFF0000") == ["476#8700000000000000"]
    assert tell(arm, ASK) == ["488#000A010505050000"]


def test_more_than_ten_is_no_level() -> None:
    arm = Firmware(TWO)
    assert tell(arm, "487#0B00000000000000") == []
    assert tell(arm, ASK) == ["488#0505050505050000"]


def test_it_outlives_a_power_cycle() -> None:
    flash = MemoryFlash()
    arm = Firmware(TWO, flash=flash)
    tell(arm, "487#0A0908070605FFFF")
    assert tell(Firmware(TWO, flash=flash), ASK) == ["488#0A09080706050000"]


def test_a_kept_text_of_before_has_the_factorys() -> None:
    text = to_text(ArmSettingsRecord(drag_assistance=(1,) * 6))
    assert from_text(text).drag_assistance == (1,) * 6
    lines = text.split('"drag_assistance": [')
    older = lines[0] + lines[1].split("],", 1)[1]
    assert from_text(older).drag_assistance == (5,) * 6


@pytest.mark.parametrize(("patch", "has"), [(0, False), (1, True)])
def test_only_from_1_8_1(patch, has) -> None:
    codec = Codec(TWO, firmware=FirmwareVersion(1, 8, patch))
    server = ParameterServer(codec, ArmSettingsRecord(), Firmware(TWO).settings_applier)
    setting = codec.encode("DragAssistanceSetting", J1=1)
    answers = server.handle("DragAssistanceSetting", codec.decode(setting).signals)
    assert bool(answers) == has
    question = codec.decode(codec.encode("ParameterCommand", Query=5)).signals
    names = [codec.decode(each).name for each in server.handle("ParameterCommand", question)]
    assert ("DragAssistanceFeedback" in names) == has
