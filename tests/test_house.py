"""The shape of the house that no other tool checks: names, sizes, and what calls itself pure."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
import tomllib
from collections import defaultdict
from collections.abc import Iterator
from graphlib import TopologicalSorter
from pathlib import Path

import grimp

ROOT = Path(__file__).resolve().parents[1]
LONGEST_FILE = 800


def modules() -> Iterator[tuple[str, Path]]:
    for path in sorted((ROOT / "armui").rglob("*.py")):
        name = ".".join(path.relative_to(ROOT).with_suffix("").parts)
        yield name.removesuffix(".__init__"), path


def tree(path: Path) -> ast.Module:
    return ast.parse(path.read_text(encoding="utf-8"))


def test_no_two_public_classes_share_a_name():
    places: dict[str, list[str]] = defaultdict(list)
    for name, path in modules():
        for node in tree(path).body:
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                places[node.name].append(name)

    assert {name: where for name, where in places.items() if len(where) > 1} == {}


def test_no_files_know_each_other_in_a_circle():
    """Imports for types alone count as well: who reads one file of a circle has to read all."""
    graph = grimp.build_graph("armui")
    knows = {each: graph.find_modules_directly_imported_by(each) for each in graph.modules}

    TopologicalSorter(knows).prepare()  # raises CycleError with the circle


def test_files_stay_short():
    lengths = {
        str(path.relative_to(ROOT)): len(path.read_text(encoding="utf-8").splitlines())
        for folder in ("armui", "tests")
        for path in (ROOT / folder).rglob("*.py")
    }

    assert {path: lines for path, lines in lengths.items() if lines > LONGEST_FILE} == {}


def test_what_calls_itself_pure_is_held_to_it():
    house = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    contracts = house["tool"]["importlinter"]["contracts"]
    held = {
        module
        for contract in contracts
        if contract["name"].startswith("What calls itself pure")
        for module in contract["source_modules"]
    }
    pure = {
        name
        for name, path in modules()
        if re.search(r"\bpure\b", ast.get_docstring(tree(path)) or "", re.IGNORECASE)
    }

    # of a room that is held it is said once
    assert {name for name in pure if name.rpartition(".")[0] not in held} == held


FIGURES = ("arm", "bus", "decode", "doctor", "kinematics", "protocol", "session", "sim",
           "telemetry", "trajectory")  # fmt: skip
"""The rooms that frames, samples and figures pass by the thousands."""


def test_a_value_is_a_dataclass_where_nothing_passes_by_the_thousands():
    found = {
        f"{name}: {node.name}"
        for name, path in modules()
        if name.split(".")[1:2] and name.split(".")[1] not in FIGURES
        for node in ast.walk(tree(path))
        if isinstance(node, ast.ClassDef)
        and any(ast.unparse(base).endswith("NamedTuple") for base in node.bases)
    }

    assert found == set()


LATE = ("can", "cantools", "pyqtgraph", "scipy", "trimesh", "vtkmodules", "yourdfpy")


def test_the_window_starts_without_what_only_its_pages_need():
    asked = f"import sys, armui.app; print(*(name for name in {LATE} if name in sys.modules))"
    done = subprocess.run([sys.executable, "-c", asked], capture_output=True, text=True, check=True)

    assert done.stdout.split() == []


OPENERS = (
    r"open|io\.(open\w*|FileIO)|os\.(open|fdopen|mkfifo)|codecs\.open|(gzip|bz2|lzma|tarfile)\.open"
    r"|gzip\.GzipFile|zipfile\.ZipFile|sqlite3\.connect|filelock\.\w*Lock"
    r"|numpy\.(load|save|savez\w*|savetxt|fromfile|memmap|loadtxt|genfromtxt)"
    r"|shutil\.(copy\w*|move)|tempfile\.(NamedTemporaryFile|TemporaryFile|mkstemp)"
    r"|logging\.(handlers\.\w+|FileHandler)|can\.(io\.)?\w*(Reader|Writer|Logger)"
    r"|trimesh\.(load\w*|exchange\.\w+)|yourdfpy\.URDF(\.load)?|pyvista\.(read\w*|get_reader)"
    r"|pyarrow\.(parquet\.\w+|OSFile|memory_map)|mcap\.\w+\.\w+"
    r"|PySide6\.\w+\.(QFile|QSaveFile|QTemporaryFile|QSettings|QPixmap|QImage|QIcon|QImageReader"
    r"|QMovie|QTranslator|QSvgRenderer|QLockFile)"
)
"""What opens a file by its path, by the name it is imported from."""
OPENING_METHODS = frozenset(
    {"read_text", "read_bytes", "write_text", "write_bytes", "touch", "tofile", "load_from_file"}
)
"""What opens a file whatever it is called on; and `open`, where something is made of its answer."""

OPENED_ELSEWHERE = {
    "armui.system.files: open": "the one place",
    "armui.system.files: os.open": "as above",
    "armui.system.atomic: os.open": "a folder, to have its names written to the disk",
    "armui.system.command_line: os.open": "the system's null device, for a command without output",
    "armui.system.presence: filelock.FileLock": "a lock of a name of its own in a private folder",
    "armui.ui.trajectory.library.library_presence: PySide6.QtCore.QLockFile": "looked at before",
    "armui.system.alone: filelock.FileLock": "a lock in a private folder, opened to read and write",
    "armui.system.scratch: filelock.FileLock": "in a folder closed to others, made by this program",
    "armui.system.log_file: filelock.FileLock": "opened to read and write, which waits for no pipe",
    "armui.system.log_file: logging.handlers.RotatingFileHandler": "its _open is ours",
    "armui.system.helper_process: tempfile.NamedTemporaryFile": "made anew in a folder made anew",
    "armui.trajectory.library.bin: shutil.copy2": "checked in the line before",
    "armui.session.database_logs: can.SqliteReader": "opened by LogSource before",
    # these are given opened files, or bytes and lines in memory
    "armui.session.blf_logs: can.BLFReader": "a stream",
    "armui.session.recording.formats: can.ASCWriter": "a stream in memory",
    "armui.session.exports.parquet_table: pyarrow.parquet.ParquetWriter": "a WholeFile's stream",
    "armui.session.exports.lerobot.dataset: pyarrow.parquet.ParquetWriter": "an opened file",
    "armui.session.exports.lerobot.dataset: pyarrow.parquet.write_table": "an opened file",
    "armui.session.exports.ros.mcap_file: mcap.writer.Writer": "a WholeFile's stream",
    "armui.session.foreign.indexed: numpy.memmap": "an opened file",
    "armui.session.foreign.indexing: numpy.fromfile": "an opened file",
    "armui.session.foreign.indexing: .tofile": "an opened file",
    "armui.trajectory.files.text: numpy.loadtxt": "lines",
    "armui.trajectory.files.npz_file: numpy.savez": "a stream in memory",
    "armui.doctor.problem_report: zipfile.ZipFile": "a WholeFile's stream",
    "armui.trajectory.files.npz_file: zipfile.ZipFile": "an opened file, or bytes",
    "armui.viewport.process.urdf_file: yourdfpy.URDF.load": "bytes",
    "armui.viewport.process.urdf_file: trimesh.load": "an opened file; others are checked",
}
"""The others, and why they may."""


def imported_names(module: ast.Module) -> dict[str, str]:
    known: dict[str, str] = {}
    for node in ast.walk(module):
        if isinstance(node, ast.Import):
            for each in node.names:
                first = each.name.split(".")[0]
                known[each.asname or first] = each.name if each.asname else first
        elif isinstance(node, ast.ImportFrom):
            known |= {each.asname or each.name: f"{node.module}.{each.name}" for each in node.names}
    return known


def opened_files(module: ast.Module) -> Iterator[str]:
    """The calls in a module that may open a file, by the name of what is called."""
    known = imported_names(module)
    unused = {id(node.value) for node in ast.walk(module) if isinstance(node, ast.Expr)}
    for node in ast.walk(module):
        if isinstance(node, ast.ClassDef):
            yield from filter(is_opener, (full_name(base, known) for base in node.bases))
        if not isinstance(node, ast.Call):
            continue
        name = full_name(node.func, known)
        if is_opener(name):
            # what Qt and gzip are given is a size or a stream, if it is no text
            in_memory = re.match(r"PySide6|gzip\.GzipFile", name) and not any(
                map(is_text, node.args)
            )
            if (node.args or node.keywords) and not in_memory:
                yield name
        elif isinstance(node.func, ast.Attribute) and not name.startswith("armui."):
            method = node.func.attr
            mode = any(map(is_text, node.args))
            if method in OPENING_METHODS or (method == "open" and (mode or id(node) not in unused)):
                yield f".{method}"


def is_text(node: ast.expr) -> bool:
    if isinstance(node, ast.Call):
        return isinstance(node.func, ast.Name) and node.func.id == "str"
    return isinstance(node, ast.Constant) and isinstance(node.value, str)


def is_opener(name: str) -> bool:
    return re.fullmatch(OPENERS, name) is not None


def full_name(node: ast.expr, known: dict[str, str]) -> str:
    """The name of what is called, as imported; with a dot in front where that is not known."""
    parts = []
    while isinstance(node, ast.Attribute):
        parts.append(node.attr)
        node = node.value
    if not isinstance(node, ast.Name):
        return "." + ".".join(reversed(parts))
    first = known.get(node.id, node.id if not parts else f".{node.id}")
    return ".".join([first, *reversed(parts)])


def test_no_module_has_qt_watch_files():
    """It looks at each path, in the thread that asks; on a network disk it then tells nothing."""
    found = {
        name
        for name, path in modules()
        if "PySide6.QtCore.QFileSystemWatcher" in imported_names(tree(path)).values()
    }

    assert found == set()


def test_the_search_for_opened_files_sees_them():
    text = """
import numpy as np
from os import open as o
from pathlib import Path
from armui.trajectory import files
def f(p, dialog, data):
    open(p); o(p, 0); np.load(p); p.read_bytes(); Path(p).open("ab"); dialog.open()
    files.read_text(data)
    with p.open() as file:
        pass
"""
    found = sorted(opened_files(ast.parse(text)))
    assert found == [".open", ".open", ".read_bytes", "numpy.load", "open", "os.open"]


def test_nothing_opens_a_file_but_the_one_place():
    found = {f"{name}: {call}" for name, path in modules() for call in opened_files(tree(path))}

    assert found == set(OPENED_ELSEWHERE)
