"""The distribution `armui-ros2`: what it needs, and what is installed."""

import ast
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path

import pytest

import armui_ros2
from armui.cli import _command_parser

HERE = Path(armui_ros2.__file__).parents[1]
ROOT = Path(__file__).resolve().parents[2]
PROJECT = tomllib.loads((HERE / "pyproject.toml").read_text(encoding="utf-8"))
FILES = sorted(HERE.rglob("*.py"))
OURS = {"armui_client", "armui_ros2"}


def imported(path):
    tree = ast.parse(path.read_text(encoding="utf-8"), feature_version=(3, 10))
    found = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            found |= {each.name for each in node.names}
        elif isinstance(node, ast.ImportFrom):
            found.add(node.module or ".")
    return {each.partition(".")[0] for each in found} - {*sys.stdlib_module_names}


def test_it_needs_the_client_alone_and_ros_where_none_is():
    project = PROJECT["project"]
    assert project["name"] == "armui-ros2"
    assert project["dependencies"] == ["armui-client"]
    assert project["requires-python"] == ">=3.10"
    extra = {
        each.removeprefix("ros-").replace("-", "_")
        for each in project["optional-dependencies"]["ros"]
    }
    with_rclpy, not_there = "rcl_interfaces", {"control_msgs", "tf2_msgs"}
    asked = imported(HERE / "armui_ros2" / "node.py") - OURS
    assert asked <= {*extra, with_rclpy, *not_there}
    assert (HERE / "LICENSE").read_bytes() == (ROOT / "LICENSE").read_bytes()


def test_ros_is_known_to_the_node_alone_and_armui_to_no_example():
    package = [path for path in FILES if path.parent.name == "armui_ros2"]
    assert {path.stem for path in package if imported(path) - OURS} == {"node"}
    strangers = [path for path in FILES if path.parent.name == "examples"]
    assert [path.name for path in strangers if imported(path) & OURS] == []


def test_readme_s_commands_and_parameters_are_there():
    readme = (HERE / "README.md").read_text(encoding="utf-8")
    blocks = [block.partition("```")[0].splitlines() for block in readme.split("```sh\n")[1:]]
    lines = [line.replace('"', "").split() for block in blocks for line in block]
    assert len(lines) == 5
    options = _command_parser("sim").parse_args(lines[0][2:])
    assert (options.api_on, options.grant) == (True, True)
    named = {word.partition("[")[0] for words in lines for word in words if "resources/" in word}
    assert {each for each in named if not (ROOT / each).exists()} == set()
    node = (HERE / "armui_ros2" / "node.py").read_text(encoding="utf-8")
    calls = [each for each in ast.walk(ast.parse(node)) if isinstance(each, ast.Call)]
    parameters = {
        ast.literal_eval(call.args[1])
        for call in calls
        if isinstance(call.func, ast.Name) and call.func.id == "_parameter"
        if isinstance(call.args[1], ast.Constant)
    }
    assert len(parameters) == 4
    assert {each for each in parameters if f"| `{each}` |" not in readme} == set()


def test_the_wheel_holds_the_package_and_nothing_else(tmp_path):
    pytest.importorskip("hatchling", reason="builds the wheel without an index")
    words = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(tmp_path)]
    subprocess.run(words, cwd=HERE, check=True, capture_output=True)
    (wheel,) = tmp_path.glob("*.whl")
    assert wheel.name == f"armui_ros2-{armui_ros2.__version__}-py3-none-any.whl"
    packed = zipfile.ZipFile(wheel).namelist()
    modules = {f"armui_ros2/{path.name}" for path in (HERE / "armui_ros2").glob("*.py")}
    ours = {name for name in packed if ".dist-info/" not in name}
    assert ours == {*modules, "armui_ros2/py.typed"}
    entries = next(name for name in packed if name.endswith("entry_points.txt"))
    assert b"armui-ros2 = armui_ros2.node:main" in zipfile.ZipFile(wheel).read(entries)
