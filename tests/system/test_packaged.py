"""A packaged program sends nobody to pip, which cannot add anything to it."""

import sys

import pytest

from armui.arm.device import Device
from armui.bus.adapters import explain
from armui.session.recording.kinds import no_mf4
from armui.system.command_process import is_packaged


@pytest.mark.parametrize("packaged", [False, True])
def test_what_is_missing_is_told_as_fits_the_installation(monkeypatch, packaged):
    if packaged:
        monkeypatch.setattr(sys, "frozen", True, raising=False)
    assert is_packaged() is packaged
    codes = [explain(Device("slcan", "x"), ImportError("serial")).code, no_mf4().code]
    usual = ["bus_backend_missing", "session_no_mf4"]
    assert codes == (["bus_backend_not_packed", "session_mf4_not_packed"] if packaged else usual)
    sentences = [explain(Device("slcan", "x"), ImportError("serial")).reason.source]
    sentences.append(no_mf4().reason.source)
    assert all(("pip install" in each) is not packaged for each in sentences)
