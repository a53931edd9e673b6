"""What the recipes of the packages say fits the program."""

import importlib.util
import os
import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
import trimesh

from armui import __version__
from armui.sim.faults.bugs import NAMES as BUG_NAMES
from armui.sim.faults.schedule import FAULTS
from armui.viewport.process.urdf_file import _MESH_KINDS

ROOT = Path(__file__).resolve().parents[2]
RECIPES = ROOT / "resources" / "packaging"


def recipe(name):
    """A module of the recipes, which are no package."""
    spec = importlib.util.spec_from_file_location(f"recipe_{name}", RECIPES / f"{name}.py")
    assert spec is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def documents():
    return recipe("documents")


def test_man_page_and_completion_name_every_option_of_every_command(documents):
    page, bash, fish = (
        documents.man_page("2026-11-23"),
        documents.bash_completion(),
        documents.fish_completion(),
    )
    assert f'.TH ARMUI 1 "2026-11-23" "armui {__version__}"' in page
    found = documents.parsers()
    assert {"", "decode", "doctor", "export", "record", "replay", "sim"} <= set(found)
    for name, parser in found.items():
        assert f'.SH "armui {name}"' in page or not name
        for action in documents.options_of(parser):
            for option in action.option_strings:
                assert option.replace("-", r"\-") in page
                assert option in bash
                assert f"-l {option[2:]} " in fish or f"-s {option[1:]} " in fish
    assert "--try" not in bash


@pytest.mark.skipif(shutil.which("bash") is None, reason="no bash here")
def test_man_page_names_every_fault_of_the_simulated_arm(documents):
    page = documents.man_page("2026-11-23")
    for name in (*FAULTS, *BUG_NAMES):
        assert name.replace("-", "\\-") in page, name


def test_bash_takes_the_completion(documents, tmp_path):
    script = tmp_path / "armui"
    script.write_text(
        documents.bash_completion()
        + 'COMP_WORDS=(armui replay --lang z); COMP_CWORD=3; _armui; echo "${COMPREPLY[@]}"\n'
    )
    told = subprocess.run(["bash", script], capture_output=True, text=True, check=True).stdout
    assert told == "zh\n"


def test_the_page_of_a_release_has_its_own_changes_only():
    pages = recipe("release_page")
    log = "# Changes\n\n## 2.0.0 – 2026-01-02\n\n- new\n\n## 1.0.0 – 2025-01-01\n\n- old\n"
    assert pages.changes_of(log, "2.0.0") == "- new"
    assert pages.changes_of(log, "1.0.0") == "- old"
    with pytest.raises(ValueError, match=r"no section «## 3\.0\.0 – date»"):
        pages.changes_of(log, "3.0.0")
    text = pages.page("2.0.0", "2026-01-02", "- new", [("armui_2.deb", 12_300_000, "ab" * 32)])
    assert "| armui_2.deb | 12.3 MB | Debian 12 and 13, where it was tried, or later |" in text
    assert "ab" * 32 in text


CUT = "# Changes\n\n## Unreleased\n\n## 2.0.0 – 2026-01-02\n\n- new\n"


@pytest.mark.parametrize(
    ("log", "version", "tag", "why"),
    [
        (CUT, "2.1.0.dev0", "", "2.1.0.dev0 is a version of development"),
        (
            CUT.replace("Unreleased\n", "Unreleased\n\n- more\n"),
            "2.0.0",
            "",
            "the page of 2.0.0 would omit",
        ),
        (CUT, "2.0.0", "v1.9.0", "tag is v1.9.0, the version 2.0.0"),
    ],
)
def test_what_is_not_wholly_cut_is_not_released(log, version, tag, why):
    check = recipe("release_page").check_release
    check(CUT, "2.0.0", "v2.0.0")
    check(CUT, "2.0.0", "")
    with pytest.raises(ValueError, match=re.escape(why)):
        check(log, version, tag)


def test_this_version_is_cut_or_one_of_development():
    """With changes under «Unreleased» the program must not call itself the released version."""
    changes = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    pages = recipe("release_page")
    if ".dev" in __version__:
        number = __version__.partition(".dev")[0]
        with pytest.raises(ValueError, match="no section"):
            pages.changes_of(changes, number)
    else:
        pages.check_release(changes, __version__, "")
        assert pages.changes_of(changes, __version__)


def test_a_version_of_development_sorts_before_its_release():
    linux = recipe("linux_package")
    assert linux._packaged("0.3.0.dev0") == "0.3.0~dev0"
    assert "armui (0.3.0~dev0-1)" in linux._debian_changes("0.3.0.dev0", "2026-11-27")
    assert linux._packaged("0.3.0") == "0.3.0"


@pytest.mark.skipif(shutil.which("readelf") is None, reason="not installed: readelf")
@pytest.mark.skipif(sys.platform != "linux", reason="asks files of Linux")
def test_a_package_asks_for_the_c_library_that_its_files_want(tmp_path, monkeypatch):
    """For .rpm by the version; no library that only Debian has is asked for."""
    linux = recipe("linux_package")
    shutil.copy(Path(sys.executable).resolve(), tmp_path / "python")
    told = subprocess.run(
        ["readelf", "-VW", tmp_path / "python"], capture_output=True, text=True, check=True
    ).stdout
    wanted = re.findall(r"GLIBC_2\.(\d+)", told)
    assert linux.oldest_glibc(tmp_path) == f"GLIBC_2.{max(map(int, wanted))}"
    monkeypatch.setattr(linux, "needed_libraries", lambda _folder: {"libc.so.6": {"python"}})
    rpm = linux.depends(tmp_path)[1]
    assert f"libc.so.6({linux.oldest_glibc(tmp_path)})(64bit)" in rpm
    known = linux._libraries()
    assert not any(name.startswith("libbz2") for name in (*known["wanted"], *known["loaded"]))


def test_the_source_archive_has_all_that_the_checks_read():
    """What is kept in the repository at its top, but for what editors and git leave."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    packed = project["tool"]["hatch"]["build"]["targets"]["sdist"]["include"]
    tops = {"/.ci", "/.github", "/.gitignore", "/armui", "/resources", "/tests", "/urdf"}
    tops |= {"/CHANGELOG.md", "/README.md", "/README.zh.md", "/LICENSE"}
    assert set(packed) == tops
    assert all((ROOT / each[1:]).exists() for each in packed)


def test_an_index_shows_readme_without_what_stands_beside_it():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    hook = project["tool"]["hatch"]["metadata"]["hooks"]["fancy-pypi-readme"]
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    assert re.search(r"\]\(resources/", text), "there is something to take out"
    for each in hook["substitutions"]:
        text = re.sub(each["pattern"], each["replacement"], text)
    assert re.findall(r"\]\((?!https?:)[^)]*\)", text) == []
    assert "- [Design" not in text


def test_every_wanted_package_has_its_version_kept():
    """A new dependency without `build.py lock` would be taken as the index has it that day."""
    kept = (RECIPES / "constraints.txt").read_text(encoding="utf-8")
    names = {re.split(r"==", line)[0] for line in kept.splitlines() if "==" in line}
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    wanted = [*project["dependencies"]]
    for each in project["optional-dependencies"].values():
        wanted += each
    asked = {re.split(r"[^A-Za-z0-9._-]", line)[0].lower() for line in wanted}
    assert asked - names == set()


def test_of_shared_libraries_only_the_wanted_are_packed():
    contents = recipe("contents")
    wants = {
        "/w/vtkmodules/vtkA.cpython-311-x86_64-linux-gnu.so": ["libvtkA.so"],
        "/w/vtkmodules/libvtkA.so": ["libvtkB.so", "libX11.so.6"],
    }
    found = [
        ("vtkmodules/vtkA.cpython-311-x86_64-linux-gnu.so", next(iter(wants)), "EXTENSION"),
        ("vtkmodules/vtkC.cpython-311-x86_64-linux-gnu.so", "/w/vtkmodules/vtkC.so", "EXTENSION"),
        ("vtkmodules/libvtkA.so", "/w/vtkmodules/libvtkA.so", "BINARY"),
        ("vtkmodules/libvtkB.so", "/w/vtkmodules/libvtkB.so", "BINARY"),
        ("vtkmodules/libvtkC.so", "/w/vtkmodules/libvtkC.so", "BINARY"),
        ("libX11.so.6", "/usr/lib/x86_64-linux-gnu/libX11.so.6", "BINARY"),
        ("libvtkB.so", "vtkmodules/libvtkB.so", "SYMLINK"),
        ("libvtkC.so", "vtkmodules/libvtkC.so", "SYMLINK"),
    ]
    kept = contents.kept_binaries(found, ["vtkmodules.vtkA"], lambda path: wants.get(path, ()))
    assert sorted(entry[0] for entry in kept) == [
        "vtkmodules/libvtkA.so",
        "vtkmodules/libvtkB.so",
        "vtkmodules/vtkA.cpython-311-x86_64-linux-gnu.so",
    ]
    links = contents.kept_links([each for each in found if each[2] == "SYMLINK"], kept)
    assert [entry[0] for entry in links] == ["libvtkB.so"]


def test_a_library_that_strip_has_moved_off_its_page_is_left_as_it_was(monkeypatch):
    monkeypatch.setattr(sys, "path", [str(RECIPES), *sys.path])
    build = recipe("build")
    whole = "  LOAD  0x001000 0x0000000000401000 0x0000000000401000 0x00100 0x00100 R E 0x1000\n"
    moved = "  LOAD  0x001010 0x0000000000401000 0x0000000000401000 0x00100 0x00100 R E 0x1000\n"
    assert build._is_aligned(whole)
    assert not build._is_aligned(whole + moved)
    assert build.version() == __version__


def test_a_licence_is_asked_for_what_is_packed_not_for_what_was_found(tmp_path):
    lists = tmp_path / "armui"
    lists.mkdir()
    (lists / "Analysis-00.toc").write_text("[('a', '/site/found_only/a.py', 'PYMODULE')]")
    (lists / "PYZ-00.toc").write_text("[('b', '/site/packed/b.py', 'PYMODULE')]")
    (lists / "COLLECT-00.toc").write_text("[('c', '/site/asked-1.dist-info/METADATA', 'DATA')]")
    assert list(recipe("licences")._sources(tmp_path)) == ["/site/packed/b.py"]


def test_nothing_that_the_program_names_is_left_out():
    contents = recipe("contents")
    named = contents.imported_by(ROOT / "armui") | set(contents.EXTRAS)
    assert {"numpy", "pyvista", "can", "hidraw", "sdl2"} <= named
    left_out = [
        each for each in named for one in contents.UNUSED if f"{each}.".startswith(f"{one}.")
    ]
    assert left_out == []
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    asked = " ".join((*project["dependencies"], *project["optional-dependencies"]["parquet"]))
    for each in contents.NOT_PACKED:
        assert each in named
        assert each.partition(".")[0] not in asked


_READ = """
import io, sys
path, *hidden = sys.argv[1:]

class Packed:
    def __init__(self, finder):
        self._finder = finder

    def find_spec(self, name, path=None, target=None):
        left_out = any(f"{name}.".startswith(f"{each}.") for each in hidden)
        return None if left_out else self._finder.find_spec(name, path, target)

sys.meta_path[:] = map(Packed, sys.meta_path)
import trimesh
trimesh.load(path)
"""


@pytest.mark.parametrize("kind", sorted(_MESH_KINDS))
def test_every_kind_of_mesh_is_read_without_what_is_left_out(kind, tmp_path):
    """trimesh imports what reads a kind when it meets one; the program names nothing of it."""
    path = tmp_path / f"box{kind}"
    more = {"embed_buffers": True} if kind == ".gltf" else {}
    made = trimesh.creation.box().export(file_type=kind[1:], **more)
    made = made["model.gltf"] if isinstance(made, dict) else made
    path.write_bytes(made if isinstance(made, bytes) else made.encode())
    asked = [sys.executable, "-c", _READ, str(path), *recipe("contents").UNUSED]
    subprocess.run(asked, check=True)


def test_of_the_program_only_what_is_run_counts_as_imported(tmp_path):
    (tmp_path / "a.py").write_text(
        "import os, wanted.inside\n"
        "if TYPE_CHECKING:\n    import only_for_types\nelse:\n    import otherwise\n"
        "def later():\n    from late import x\n    from . import own\n"
    )
    found = recipe("contents").imported_by(tmp_path)
    assert found == {"wanted.inside", "otherwise", "late"}


def test_of_the_wheel_of_sdl_only_sdl_is_packed():
    is_sdl = recipe("contents").is_sdl
    assert is_sdl("/w/libSDL2-2.0.so")
    assert is_sdl("C:/w/SDL2.dll")
    assert not is_sdl("/w/libSDL2_image-2.0.so")
    assert not is_sdl("/w/libavif.so.16")


@pytest.mark.skipif(
    shutil.which("gio") is None or shutil.which("update-mime-database") is None,
    reason="not installed: gio, update-mime-database (Debian: libglib2.0-bin, shared-mime-info)",
)
def test_a_desktop_opens_trajectories_and_no_other_logs(tmp_path):
    kinds = tmp_path / "mime/packages"
    kinds.mkdir(parents=True)
    shutil.copy(RECIPES / "linux/org.armui.armui.xml", kinds)
    subprocess.run(["update-mime-database", tmp_path / "mime"], check=True, capture_output=True)
    (tmp_path / "a.armui").write_text("armui trajectory 1\nname: a\n")
    (tmp_path / "a.log").write_text("(1.0) can0 1#00\n")
    kind = {}
    for name in ("a.armui", "a.log"):
        words = ["gio", "info", "-a", "standard::content-type", tmp_path / name]
        environment = {**os.environ, "XDG_DATA_HOME": str(tmp_path)}
        told = subprocess.run(words, env=environment, capture_output=True, text=True, check=True)
        kind[name] = told.stdout.rpartition("content-type: ")[2].strip()
    ours = "text/x-armui-trajectory"
    assert kind["a.armui"] == ours
    assert kind["a.log"] != ours
    desktop = (RECIPES / "linux/org.armui.armui.desktop").read_text()
    assert f"MimeType={ours};\n" in desktop
    assert "Exec=armui %f\n" in desktop


def test_the_programs_own_texts_are_packed_and_no_others():
    contents = recipe("contents")
    assert contents.keeps_data("armui/resources/i18n/armui_zh.ts")
    assert not contents.keeps_data("PySide6/translations/qt_de.ts")
    assert not contents.keeps_data("numpy/core/setup.h")
