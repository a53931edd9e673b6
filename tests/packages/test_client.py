"""The distribution `armui-client`: what it needs, and what is installed."""

import ast
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path

import pytest

import armui_client
from armui.cli import _command_parser

HERE = Path(armui_client.__file__).parents[1]
PROJECT = tomllib.loads((HERE / "pyproject.toml").read_text(encoding="utf-8"))
FILES = sorted(HERE.rglob("*.py"))


def names(path):
    return str(path.relative_to(HERE))


def test_it_needs_nothing_and_says_so():
    project = PROJECT["project"]
    assert project["name"] == "armui-client"
    assert project["dependencies"] == []
    assert project["requires-python"] == ">=3.10"
    assert (HERE / "armui_client" / "py.typed").exists()
    root = Path(__file__).resolve().parents[2]
    assert (HERE / "LICENSE").read_bytes() == (root / "LICENSE").read_bytes()


@pytest.mark.parametrize("path", FILES, ids=names)
def test_each_file_is_of_python_3_10_and_of_the_standard_library(path):
    tree = ast.parse(path.read_text(encoding="utf-8"), feature_version=(3, 10))
    imported = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            imported |= {each.name for each in node.names}
        elif isinstance(node, ast.ImportFrom):
            imported.add(node.module or ".")
    assert {each.partition(".")[0] for each in imported} <= {
        *sys.stdlib_module_names,
        "armui_client",
    }


def test_what_it_offers_is_named():
    public = {name for name in vars(armui_client) if not name.startswith("_")}
    modules = {path.stem for path in (HERE / "armui_client").glob("*.py")}
    assert public - modules == set(armui_client.__all__)


def test_readme_s_commands_are_there():
    readme = (HERE / "README.md").read_text(encoding="utf-8")
    blocks = [block.partition("```")[0].splitlines() for block in readme.split("```sh\n")[1:]]
    lines = [line.split() for block in blocks for line in block]
    for words in lines:
        if words[:2] == ["armui", "sim"]:
            options = _command_parser("sim").parse_args(words[2:])
            assert options.api_on
            assert options.grant
        else:
            assert (HERE.parents[2] / words[-1]).exists()
    assert len(lines) == 4
    examples = {path.name for path in (HERE / "examples").glob("*.py")}
    assert {name for name in examples if f"`{name}`" not in readme} == set()


def test_the_wheel_holds_the_package_and_nothing_else(tmp_path):
    pytest.importorskip("hatchling", reason="builds the wheel without an index")
    words = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(tmp_path)]
    subprocess.run(words, cwd=HERE, check=True, capture_output=True)
    (wheel,) = tmp_path.glob("*.whl")
    assert wheel.name == f"armui_client-{armui_client.__version__}-py3-none-any.whl"
    packed = zipfile.ZipFile(wheel).namelist()
    modules = {f"armui_client/{path.name}" for path in (HERE / "armui_client").glob("*.py")}
    ours = {name for name in packed if ".dist-info/" not in name}
    assert ours == {*modules, "armui_client/py.typed"}
