"""Which arm an export takes a recording's for: as asked, as the log says, by the pose."""

from contextlib import closing
from types import SimpleNamespace
from typing import Any, cast

import pytest

from armui.arm.models import model_data
from armui.protocol.generation import Generation, PiperModel
from armui.session.exports.export import FileSource, SessionSource, open_source
from armui.session.exports.exported_arm import look_at
from armui.session.exports.request import ArmOptions
from armui.session.reader import LogFile
from armui.sim.firmware import Firmware
from tests.session.exports.logs import candump

LEANING_DEG = (10.0, 60.0, -60.0, 5.0, 30.0, 0.0)
POSES = {0x2A2, 0x2A3, 0x2A4}
H, L, X = PiperModel.PIPER_H, PiperModel.PIPER_L, PiperModel.PIPER_X


def log_of(tmp_path, model, *, version="S-V1.8-9", poses=True):
    arm = Firmware(Generation.TWO, joints_deg=LEANING_DEG, model=model, version=version)
    frames = [(n * 0.01, frame) for n in range(20) for frame in arm.step(0.01)]
    kept = [each for each in frames if poses or each[1].arbitration_id not in POSES]
    return candump(tmp_path / "a.log", kept)


def taken_for(path, lines=(), **wishes):
    with closing(LogFile(path)) as log:
        arm, _batches = look_at(log.batches(), ArmOptions(Generation.TWO, **wishes), lines)
    return arm


def sidecar(model, firmware=None):
    return [{"kind": "session"}, {"kind": "arm", "model": model, "firmware": firmware}]


def test_what_the_recording_says_counts_where_no_pose_is_heard(tmp_path):
    log = log_of(tmp_path, L, poses=False)
    assert taken_for(log).model.model is PiperModel.PIPER
    assert taken_for(log).why_model == "nothing in the log tells"

    arm = taken_for(log, sidecar("piper_l", "S-V1.5-2"))

    assert (arm.model.model, arm.why_model, arm.pose_fits) == (L, "as the log says", "")
    assert arm.firmware == "S-V1.5-2"
    assert arm.geometry == model_data(L).older_geometry


def test_what_the_pose_says_otherwise_is_told(tmp_path):
    """As the replay does: what was chosen then goes first, and the arm's own word is said."""
    arm = taken_for(log_of(tmp_path, X), sidecar("piper_h"))
    assert (arm.model.model, arm.pose_fits) == (H, "PiPER X")
    assert arm.why_model == "as the log says; but its end pose fits a PiPER X"


def test_whoever_exports_has_the_last_word(tmp_path):
    arm = taken_for(log_of(tmp_path, L), sidecar("piper_h"), model=L)
    assert (arm.model.model, arm.why_model, arm.pose_fits) == (L, "as asked for", "")
    assert taken_for(log_of(tmp_path, L), model=X).pose_fits == "PiPER L"


@pytest.mark.parametrize("version", ["S-V1.8-9", "S-V1.5-2"])
def test_the_zeros_are_found_by_the_pose_for_the_model_that_was_said(tmp_path, version):
    arm = taken_for(log_of(tmp_path, H, version=version), sidecar("piper_h"))
    assert arm.geometry == model_data(H).geometry_of(version)


def test_a_recording_hands_its_lines_over_and_another_log_has_none(tmp_path):
    session = SimpleNamespace(start_s=0.0, end_s=0.0, lines=sidecar("piper_h"))
    assert SessionSource(cast(Any, session)).lines == session.lines
    source = open_source(log_of(tmp_path, H))
    assert isinstance(source, FileSource)
    assert not source.lines
    source.close()
