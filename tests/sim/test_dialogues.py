"""Bytes in, bytes out: every answer of the simulated arm, worked out from the protocol text.

A dialogue is a list of lines; `>` is what the host says, `<` what the arm answers at once. Every
answer must stand there, and none more.
"""

from __future__ import annotations

import pytest

from armui.protocol.addressing import Addressing
from armui.protocol.codec import InvalidFrameKind
from armui.protocol.codes import EndLoad
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from armui.sim.parameters.settings import Light
from tests.sim.talk import BOTH, FRAMES_A_SECOND, frame, heard, tell, text

ONE, TWO = Generation.ONE, Generation.TWO

# fmt: off
DIALOGUES = {
    "enable all": (BOTH, """
        > 471#0702000000000000
        < 476#7100000000000000
    """),
    "enable and disable joint 3": (BOTH, """
        > 471#0302000000000000
        < 476#7100000000000000
        > 471#0301000000000000
        < 476#7100000000000000
    """),
    # 150.0° = 1500 = 0x05DC, −150.0° = 0xFA24, 3 rad/s = 28.6 RPM → 29 = 0x001D
    "limits of joint 1, RPM": ((ONE,), """
        > 472#0101000000000000
        < 473#0105DCFA24001D00
    """),
    # 180.0° = 0x0708, 3.00 rad/s = 300 = 0x012C
    "limits of joint 2, rad/s": ((TWO,), """
        > 472#0201000000000000
        < 473#0207080000012C00
    """),
    # −170.0° = −1700 = 0xF95C
    "limits of joint 3": ((TWO,), """
        > 472#0301000000000000
        < 473#030000F95C012C00
    """),
    # 5 rad/s² = 47.7 RPM/s → 48 = 0x0030
    "acceleration of joint 6, RPM/s": ((ONE,), """
        > 472#0602000000000000
        < 47C#0600300000000000
    """),
    # 5.00 rad/s² = 500 = 0x01F4
    "acceleration of joint 6, rad/s²": ((TWO,), """
        > 472#0602000000000000
        < 47C#0601F40000000000
    """),
    # factory: 1000 = 0x03E8 in each field
    "end limits": (BOTH, """
        > 477#0100000000000000
        < 478#03E803E803E803E8
    """),
    "collision levels": (BOTH, """
        > 477#0200000000000000
        < 47B#0101010101010000
    """),
    "collision levels set and read back": (BOTH, """
        > 47A#0001020304080000
        < 476#7A00000000000000
        > 477#0200000000000000
        < 47B#0001020304080000
    """),
    "a collision level of 9 is not in the table": (BOTH, """
        > 47A#0900000000000000
        > 477#0200000000000000
        < 47B#0101010101010000
    """),
    # 90.0° = 900 = 0x0384, −45.0° = −450 = 0xFE3E, 10 RPM = 0x000A
    "limits set and read back, RPM": ((ONE,), """
        > 474#010384FE3E000A00
        < 476#7400000000000000
        > 472#0101000000000000
        < 473#010384FE3E000A00
    """),
    # what is read back may be written again, though 29 RPM are more than 3 rad/s
    "factory limits written back, RPM": ((ONE,), """
        > 474#0105DCFA24001D00
        < 476#7400000000000000
        > 472#0101000000000000
        < 473#0105DCFA24001D00
    """),
    # 1.50 rad/s = 150 = 0x0096; 0x7FFF leaves the angles
    "only the speed set": ((TWO,), """
        > 474#017FFF7FFF009600
        < 476#7400000000000000
        > 472#0101000000000000
        < 473#0105DCFA24009600
    """),
    "only the smallest angle set": ((TWO,), """
        > 474#017FFFFE3E7FFF00
        < 476#7400000000000000
        > 472#0101000000000000
        < 473#0105DCFE3E012C00
    """),
    # 3.10 rad/s = 310 = 0x0136: answered, not stored
    "a speed the motors cannot do": ((TWO,), """
        > 474#017FFF7FFF013600
        < 476#7400000000000000
        > 472#0101000000000000
        < 473#0105DCFA24012C00
    """),
    "a range without extent": ((TWO,), """
        > 474#01000000007FFF00
        < 476#7400000000000000
        > 472#0101000000000000
        < 473#0105DCFA24012C00
    """),
    # 2.50 rad/s² = 250 = 0x00FA, byte 2 = 0xAE makes it valid
    "acceleration of joint 2 set": ((TWO,), """
        > 475#0200AE00FA000000
        < 476#7500000000000000
        > 472#0202000000000000
        < 47C#0200FA0000000000
        > 472#0102000000000000
        < 47C#0101F40000000000
    """),
    "acceleration of all joints set": ((ONE,), """
        > 475#0700AE0014000000
        < 476#7500000000000000
        > 472#0102000000000000
        < 47C#0100140000000000
        > 472#0602000000000000
        < 47C#0600140000000000
    """),
    "acceleration not marked valid": ((TWO,), """
        > 475#02000000FA000000
        < 476#7500000000000000
        > 472#0202000000000000
        < 47C#0201F40000000000
    """),
    "acceleration 0 and 5.1 rad/s² are not stored, 0x7FFF leaves it": ((TWO,), """
        > 475#0200AE0000000000
        < 476#7500000000000000
        > 475#0200AE01FF000000
        < 476#7500000000000000
        > 475#0200AE7FFF000000
        < 476#7500000000000000
        > 472#0202000000000000
        < 47C#0201F40000000000
    """),
    "joint limits back to factory": ((TWO,), """
        > 474#010384FE3E009600
        < 476#7400000000000000
        > 475#0100AE00FA000000
        < 476#7500000000000000
        > 477#0002000000000000
        < 476#7700000000000000
        > 472#0101000000000000
        < 473#0105DCFA24012C00
        > 472#0102000000000000
        < 47C#0101F40000000000
    """),
    "end limits set, then back to factory": (BOTH, """
        > 479#0001000200030004
        < 476#7900000000000000
        > 477#0100000000000000
        < 478#0001000200030004
        > 477#0001000000000000
        < 476#7700000000000000
        > 477#0100000000000000
        < 478#03E803E803E803E8
    """),
    "two end limits left unchanged": ((TWO,), """
        > 479#7FFF00027FFF0004
        < 476#7900000000000000
        > 477#0100000000000000
        < 478#03E8000203E80004
    """),
    # in generation 1, 0x7FFF is a value like any other
    "an end limit of 0x7FFF": ((ONE,), """
        > 479#7FFF000200030004
        < 476#7900000000000000
        > 477#0100000000000000
        < 478#7FFF000200030004
    """),
    "query and reset in one frame": (BOTH, """
        > 479#0001000200030004
        < 476#7900000000000000
        > 477#0101000000000000
        < 478#03E803E803E803E8
        < 476#7700000000000000
    """),
    # range 100 % = 0x64, stroke 70 mm = 0x46, friction 1; then 150 %, 100 mm, 10
    "teaching handle": ((TWO,), """
        > 477#0400000000000000
        < 47E#6446010000000000
        > 47D#96640A0000000000
        < 476#7D00000000000000
        > 477#0400000000000000
        < 47E#96640A0000000000
    """),
    # H-V1.2-1 at 0, batch 10 at 16, ARM_MC at 32, S-V1.8-9 at 60, 250925 at 68, node 15 at 76
    "firmware version": ((TWO,), """
        > 4AF#0100000000000000
        < 4AF#482D56312E322D31
        < 4AF#0000000000000000
        < 4AF#3130000000000000
        < 4AF#0000000000000000
        < 4AF#41524D5F4D430000
        < 4AF#0000000000000000
        < 4AF#0000000000000000
        < 4AF#00000000532D5631
        < 4AF#2E382D3932353039
        < 4AF#3235000031350000
        < 4AF#0000000000000000
    """),
    "firmware version, asked with one byte": ((TWO,), """
        > 4AF#01
        < 4AF#482D56312E322D31
        < 4AF#0000000000000000
        < 4AF#3130000000000000
        < 4AF#0000000000000000
        < 4AF#41524D5F4D430000
        < 4AF#0000000000000000
        < 4AF#0000000000000000
        < 4AF#00000000532D5631
        < 4AF#2E382D3932353039
        < 4AF#3235000031350000
        < 4AF#0000000000000000
    """),
    "another arm's version is no question": ((TWO,), """
        > 4AF#506950455220532D
    """),
    "generation 1 is silent about its version": ((ONE,), """
        > 4AF#0100000000000000
    """),
    "what has no answer": (BOTH, """
        > 150#0000000000000000
        > 151#0101320000000000
        > 155#0000000000000000
        > 156#0000000000000000
        > 157#0000000000000000
        > 121#0101FFFF00000007
        > 422#00
        > 158#0100000000000000
        > 159#0000000000000000
    """),
    "identifier offsets": (BOTH, """
        > 470#FC102000
        < 476#7000000000000000
    """),
    "silence, also about questions": (BOTH, """
        > 422#01
        > 472#0101000000000000
        > 471#0702000000000000
        > 422#00
        > 477#0200000000000000
        < 47B#0101010101010000
    """),
    "a joint number that does not exist": (BOTH, """
        > 471#0802000000000000
        > 472#0701000000000000
        > 472#0001000000000000
    """),
}
# fmt: on


@pytest.mark.parametrize(
    ("name", "generation"),
    [
        (name, generation)
        for name, (generations, _) in DIALOGUES.items()
        for generation in generations
    ],
)
def test_dialogue(name: str, generation: Generation) -> None:
    lines = [line.strip() for line in DIALOGUES[name][1].strip().splitlines()]
    arm = Firmware(generation)
    spoken: list[str] = []
    for line in lines:
        if line.startswith("> "):
            spoken.append(line)
            spoken += [f"< {text(answer)}" for answer in arm.on_frame(frame(line[2:]))]
    assert spoken == lines


@pytest.mark.parametrize(
    ("line", "kind"),
    [
        ("7AB#00", InvalidFrameKind.UNKNOWN_ID),
        ("471#0702", InvalidFrameKind.WRONG_LENGTH),
        ("151#0101650000000000", InvalidFrameKind.VALUE_OUTSIDE_TABLE),  # 101 %
        ("150#0300000000000000", InvalidFrameKind.VALUE_OUTSIDE_TABLE),
        ("160#0100000000000000", InvalidFrameKind.UNKNOWN_ID),  # another arm's stop
    ],
)
def test_what_is_not_understood_is_counted_and_changes_nothing(
    line: str, kind: InvalidFrameKind
) -> None:
    arm, other = Firmware(TWO), Firmware(TWO)
    assert tell(arm, line) == []
    assert arm.ignored == {kind: 1}
    assert arm.step(0.05) == other.step(0.05)


def test_the_feedback_of_another_arm_is_nothing_to_the_arm() -> None:
    arm = Firmware(TWO)
    assert tell(arm, "2A1#0101010000000000", "476#7100000000000000") == []
    assert not arm.ignored
    assert arm.condition.status == 0


def test_offsets_move_feedback_and_commands_at_once_in_standby() -> None:
    arm = Firmware(TWO)
    tell(arm, "470#FC10200000000000")
    assert arm.addressing == Addressing(feedback_offset=0x10, control_offset=0x20)
    identifiers = {each.arbitration_id for each in arm.step(0.025)}
    assert {0x2B1, 0x2B5, 0x2B8, 0x251, 0x266} <= identifiers
    assert not identifiers & set(range(0x2A1, 0x2A9))
    tell(arm, "150#0100000000000000")
    assert not arm.condition.stopped
    tell(arm, "170#0100000000000000")
    assert arm.condition.stopped


def test_offsets_wait_for_standby() -> None:
    arm = Firmware(TWO)
    tell(arm, "151#0101320000000000", "470#FC10100000000000")
    assert heard(arm.step(0.005), 0x2A1)
    tell(arm, "151#0000000000000000")
    assert heard(arm.step(0.005), 0x2B1)


def test_silence_stops_the_feedback_but_not_the_time() -> None:
    arm = Firmware(TWO)
    tell(arm, "422#0100000000000000")
    assert arm.step(1.0) == []
    assert arm.time_s == 1.0
    tell(arm, "422#0000000000000000")
    assert len(arm.step(1.0)) == FRAMES_A_SECOND


def test_light_and_load_are_kept() -> None:
    arm = Firmware(ONE)
    # joint 2, all lamps, R 16, G 32, B 48; then one not marked valid
    tell(arm, "121#0102FF1020300001", "121#0002FFFFFFFF0002")
    assert arm.settings.lights == {2: Light(lamp=255, red=16, green=32, blue=48, counter=1)}
    assert tell(arm, "477#000000AE02000000") == ["476#7700000000000000"]
    assert arm.settings.load is EndLoad.FULL
    tell(arm, "477#0000000001000000")
    assert arm.settings.load is EndLoad.FULL
