"""A packaged program sends nobody to pip, which cannot add anything to it."""

import sys

import pytest

from armui.arm.device import Device
from armui.bus.adapters import explain
from armui.system.command_process import is_packaged


@pytest.mark.parametrize("packaged", [False, True])
def test_what_is_missing_is_told_as_fits_the_installation(monkeypatch, packaged):
    if packaged:
        monkeypatch.setattr(sys, "frozen", True, raising=False)
    assert is_packaged() is packaged
    refusal = explain(Device("slcan", "x"), ImportError("serial"))
    assert refusal.code == ("bus_backend_not_packed" if packaged else "bus_backend_missing")
    assert ("pip install" in refusal.reason.source) is not packaged
