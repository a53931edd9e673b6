"""Telling the generation of an arm from its traffic."""

from __future__ import annotations

import pytest

from armui.protocol.detect import GenerationDetector
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation

STATUS = "01 00 01 00 00 32 00 00"


def detect(*traffic: tuple[float, int, str]) -> GenerationDetector:
    detector = GenerationDetector()
    for time_s, arbitration_id, payload in traffic:
        detector.feed(Frame(arbitration_id, bytes.fromhex(payload)), time_s)
    return detector


def test_the_version_text_decides_even_in_pieces():
    # "H-V1.0 S", "-V1.6-3 ": the text lies across two frames
    detector = detect(
        (0.0, 0x4AF, "01 00 00 00 00 00 00 00"),
        (0.1, 0x4AF, "48 2D 56 31 2E 30 20 53"),
        (0.2, 0x4AF, "2D 56 31 2E 36 2D 33 20"),
    )
    assert detector.certain
    assert detector.verdict() == (Generation.TWO, "the arm named its firmware S-V1.6-3")


def test_the_question_for_the_version_proves_nothing():
    detector = detect(*[(t * 0.02, 0x2A1, STATUS) for t in range(20)])
    detector.feed(Frame(0x4AF, bytes.fromhex("01 00 00 00 00 00 00 00")), 1.0)
    assert detector.verdict().generation is Generation.ONE


@pytest.mark.parametrize(
    ("arbitration_id", "payload"),
    [
        (0x15A, "00 00 00 00 00 00 00 00"),
        (0x47D, "64 46 01 00 00 00 00 00"),
        (0x47E, "64 46 01 00 00 00 00 00"),
        (0x2A1, "01 00 01 00 00 00 20 00"),  # a joint beyond its limit: reserved in generation 1
        (0x2A1, "01 0E 01 00 00 00 00 00"),  # main controller hot
        (0x2A1, "01 00 04 00 00 00 00 00"),  # MOVE M
        (0x2A1, "01 00 01 00 00 65 00 00"),  # point 101, or 101 %
        (0x2A8, "00 00 00 00 00 00 40 00"),  # enabled is bit 6
        (0x151, "01 01 32 AD 00 00 00 00"),  # high-follow
        (0x158, "01 00 00 00 00 00 00 00"),  # padded
        (0x477, "04 00 00 00 00 00 00 00"),
    ],
)
def test_one_frame_that_only_generation_2_sends(arbitration_id, payload):
    verdict = detect((0.0, arbitration_id, payload)).verdict()
    assert verdict.generation is Generation.TWO
    assert verdict.reason == "frames that fit only this generation: 1, only the other: 0"


@pytest.mark.parametrize(("arbitration_id", "payload"), [(0x158, "01"), (0x470, "FC 00 00 00")])
def test_short_frames_speak_for_generation_1(arbitration_id, payload):
    assert detect((0.0, arbitration_id, payload)).verdict().generation is Generation.ONE


@pytest.mark.parametrize(
    ("period_s", "generation"), [(0.005, Generation.TWO), (0.020, Generation.ONE)]
)
def test_the_period_decides_when_nothing_else_does(period_s, generation):
    verdict = detect(*[(t * period_s, 0x2A1, STATUS) for t in range(50)]).verdict()
    assert verdict.generation is generation
    assert f"every {period_s * 1000:.1f} ms" in verdict.reason


def test_evidence_outweighs_the_period():
    frames = [(t * 0.02, 0x2A8, "00 00 00 00 00 00 40 00") for t in range(20)]
    detector = detect(*frames)
    assert detector.certain
    assert detector.verdict().generation is Generation.TWO


def test_one_damaged_frame_does_not_outweigh_many():
    frames = [(0.0, 0x158, "01")] + [(1.0, 0x15A, "00 00 00 00 00 00 00 00")] * 2
    assert detect(*frames).verdict().generation is Generation.TWO


def test_an_empty_log_is_read_as_generation_2_and_says_why():
    verdict = GenerationDetector().verdict()
    assert verdict == (Generation.TWO, "nothing tells, and arms in use today speak it")
