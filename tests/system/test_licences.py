"""The licences of all that is shipped can be read, Qt's LGPL among them."""

import sys

from armui.system import licences as room
from armui.system.licences import licences


def test_from_the_source_those_of_the_packages_it_wants():
    found = licences()
    assert [each.of for each in found[:1]] == ["armui"]
    assert "MIT" in found[0].path.read_text(encoding="utf-8")
    texts = {each.path.name: each.path for each in found if each.of == "PySide6-Essentials"}
    assert "GNU LESSER GENERAL PUBLIC LICENSE" in texts["LGPL-3.0.txt"].read_text(encoding="utf-8")
    assert {"numpy", "scipy"} <= {each.of for each in found}
    assert all(each.path.is_file() for each in found)


def test_in_a_package_those_that_were_made_with_it(monkeypatch, tmp_path):
    folder = tmp_path / "licences"
    for name in ("armui.txt", "names.txt", "pyside6-essentials/LGPL-3.0.txt", "system/libz.txt"):
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.touch()
    monkeypatch.setattr(sys, "frozen", True, raising=False)
    monkeypatch.setattr(sys, "executable", str(tmp_path / "armui"))
    assert [each.of for each in licences()] == ["armui", "pyside6-essentials", "libz"]
    assert room.licences()[1].path.name == "LGPL-3.0.txt"
