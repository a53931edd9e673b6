"""What belongs into a package of the program, and what its libraries bring along needlessly.

Used by the recipe ``armui.spec`` while PyInstaller runs it, in the environment that is packed.
"""

from __future__ import annotations

import ast
import os
import re
import subprocess
import sys
from collections.abc import Callable, Collection, Iterable, Iterator
from importlib import metadata
from pathlib import Path, PurePath
from typing import Final

EXTRAS: Final = (
    *(() if sys.platform == "linux" else ("libusb_package",)),
    "gs_usb",
    "hid",
    "msgpack",
    "pyarrow.parquet",
    "sdl2",
    "sdl2dll",
    "serial",
    "serial.tools.list_ports",
    "usb.backend.libusb1",
)
"""Imported by what is looked up at run time: the extras adapters, gamepad and parquet."""

NOT_HERE: Final = {
    "linux": ("libusb_package",),
    "win32": ("hidraw", "jeepney", "jeepney.io.blocking", "jeepney.wrappers"),
}
"""Named in imports, but not for every system."""

NOT_PACKED: Final = ("armui_mcp.server", "foxglove")
"""Named in imports, but in no package: the program says how Python gets them."""

UNUSED: Final = [
    "IPython",
    "PIL.ImageQt",
    "PIL.ImageTk",
    "PIL._avif",
    "PIL._imagingcms",
    "PIL._imagingtk",
    "PIL._webp",
    "PySide6.QtDBus",
    "PySide6.QtNetwork",
    "PySide6.QtQml",
    "PySide6.QtQuick",
    "PySide6.QtTest",
    "_pytest",
    "arrow",
    "certifi",
    "cffi",
    "chardet",
    "contourpy",
    "cryptography",
    "curses",
    "cyclopts",
    "docutils",
    "embreex",
    "fontTools",
    "gi",
    "h11",
    "httpcore",
    "httpx",
    "idna",
    "ipywidgets",
    "jsonschema",
    "jsonschema_specifications",
    "keyring",
    "kiwisolver",
    "lark",
    "lxml.html",
    "lxml.objectify",
    "lxml.sax",
    "manifold3d",
    "mapbox_earcut",
    "matplotlib",
    "mpl_toolkits",
    "mypy",
    "numpy._core._multiarray_tests",
    "pandas",
    "pip",
    "pkg_resources",
    "polars",
    "psutil",
    "pyarrow._azurefs",
    "pyarrow._csv",
    "pyarrow._feather",
    "pyarrow._flight",
    "pyarrow._gcsfs",
    "pyarrow._hdfs",
    "pyarrow._json",
    "pyarrow._orc",
    "pyarrow._s3fs",
    "pyarrow._substrait",
    "pyarrow.cffi",
    "pyarrow.tests",
    "pycparser",
    "pydoc_data",
    "pygments",
    "pyqtgraph.examples",
    "pyqtgraph.jupyter",
    "pyqtgraph.opengl",
    "pytest",
    "readline",
    "referencing",
    "requests",
    "rich",
    "rpds",
    "rtree",
    "scipy.cluster",
    "scipy.datasets",
    "scipy.differentiate",
    "scipy.fftpack",
    "scipy.integrate",
    "scipy.io",
    "scipy.odr",
    "scipy.signal",
    "scipy.stats",
    "setuptools",
    "shapely",
    "tkinter",
    "trame",
    "urllib3",
    "uvloop",
    "vhacdx",
    "vtkmodules.gtk",
    "vtkmodules.qt",
    "vtkmodules.test",
    "vtkmodules.tk",
    "vtkmodules.web",
    "vtkmodules.wx",
    "zstandard._cffi",
    "zstandard.backend_cffi",
]
"""Plots on paper, another toolkit, rays through meshes, clouds, statistics: nothing the program
loads needs them. The build has the packed program import all that it names itself.
"""

HOOKS: Final = frozenset({"pyi_rth_pkgres", "pyi_rth_pyqtgraph_multiprocess", "pyi_rth_usb"})
"""Of PyInstaller, run at every start, for what this program does not do; half of a start's time.

pyi_rth_usb has pyusb look for libusb in the folder alone, where it is asked of the system instead.
"""

_PICTURE: Final = """
import importlib, pkgutil, sys
import armui.viewport.process as room
for each in pkgutil.iter_modules(room.__path__):
    importlib.import_module(f"{room.__name__}.{each.name}")
print(*(name for name in sys.modules if name.startswith("vtkmodules")))
"""

SYSTEM: Final = re.compile(
    r"lib(X11|X11-xcb|xcb|xcb-[a-z0-9-]+|xkbcommon|xkbcommon-x11|Xau|Xdmcp|Xext|Xrender|Xcursor|Xfixes|Xi"
    r"|GL|GLX|EGL|OpenGL|GLdispatch|gbm|drm|wayland-[a-z]+|fontconfig|freetype|dbus-1|glib-2\.0|gthread-2\.0"
    r"|stdc\+\+|gcc_s|gomp|z|ssl|crypto|systemd|udev|usb-1\.0|uuid|expat|bsd|md|cap|lz4|zstd|lzma|gcrypt"
    r"|gpg-error|pcre2-8|png16|brotlicommon|brotlidec|ffi|com_err|gssapi_krb5|k5crypto|krb5|krb5support"
    r"|keyutils|resolv|tirpc|nsl|asound|pulse.*|jack|sndfile)\.so(\.\d+)*$"
)
"""Libraries of the system that a package declares rather than brings: their mends come with it.

Each of them has the same soname in Debian 12 and 13, and with other distributions; libbz2, which
only Debian calls ``libbz2.so.1.0``, is packed.
"""


def picture_modules() -> list[str]:
    """The modules of VTK that the picture's process loads; the others are half of a package."""
    loaded = subprocess.run(  # noqa: S603 - the Python that packs
        [sys.executable, "-c", _PICTURE], stdout=subprocess.PIPE, text=True, check=True
    ).stdout.split()
    return sorted(loaded)


def imported_by(package: Path) -> set[str]:
    """The modules of others that a package names in its imports, wherever in its files.

    What only types are read from is left out, with what another system has.
    """
    found: set[str] = set()
    for file in sorted(package.rglob("*.py")):
        found |= set(_imports(ast.parse(file.read_text(encoding="utf-8"))))
    return {each for each in found if each.split(".")[0] not in _OF_PYTHON | {package.name}}


_OF_PYTHON: Final = sys.stdlib_module_names | {"_typeshed"}


def _imports(node: ast.AST) -> Iterator[str]:
    if isinstance(node, ast.Import):
        yield from (each.name for each in node.names)
    elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
        yield node.module
    if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING":
        children: Iterable[ast.AST] = node.orelse
    else:
        children = ast.iter_child_nodes(node)
    for each in children:
        yield from _imports(each)


def metadata_of(name: str, seen: set[str] | None = None) -> set[str]:
    """The distributions that a program is made of, with its extras for operators."""
    seen = set() if seen is None else seen
    try:
        found = metadata.distribution(name)
    except metadata.PackageNotFoundError:
        return seen
    if name not in seen:
        seen.add(name)
        wanted = {"adapters", "gamepad", "parquet"} if name == "armui" else set()
        for line in found.requires or ():
            extra = re.search(r"extra\s*==\s*['\"]([^'\"]+)['\"]", line)
            if extra is None or extra[1] in wanted:
                metadata_of(re.split(r"[^A-Za-z0-9._-]", line.strip())[0], seen)
    return seen


def keeps_module(name: str, vtk: Collection[str]) -> bool:
    """Whether a module of Python is packed.

    Args:
        name: Of the module.
        vtk: The modules of VTK that are packed.
    """
    if name.startswith("vtkmodules.vtk"):
        return name in vtk
    return not re.match(r"(pyvista\.(examples|ext|trame)|(numpy|scipy)\..*\.tests)\b", name)


def keeps_data(name: str) -> bool:
    """Whether a file is packed."""
    place = PurePath(name).as_posix()
    if place.startswith("PySide6/Qt/translations/"):
        return re.search(r"qt(base)?_(zh_CN|en)\.qm$", place) is not None
    if ".dist-info/" in place:
        return place.endswith(("/METADATA", "/entry_points.txt"))  # licences: see licences.py
    if place.endswith((".pyx", ".pxi", ".pxd", ".pyi", ".h", ".hpp", ".ts")):
        return place.startswith("armui/")  # the doctor reads the program's own .ts
    return not re.match(
        r"(armui/resources/licences|pyvista/examples|pyarrow/(include|src|tests)|share/icons|jsonschema/benchmarks"
        r"|pyqtgraph/icons/peegee|trimesh/resources/(javascript|templates))",
        place,
    )


Entry = tuple[str, str, str]
"""Of PyInstaller: place in the folder, where it comes from (a link: leads to), kind."""


def kept_binaries(
    found: Iterable[Entry], vtk: Collection[str], imports: Callable[[str], Iterable[str]]
) -> list[Entry]:
    """The libraries that are packed: without the system's, and those that only others wanted.

    Args:
        found: What PyInstaller has found.
        vtk: The modules of VTK that are packed.
        imports: Names the libraries that a library wants.
    """
    files = [entry for entry in found if entry[2] != "SYMLINK" and _is_wanted(*entry[:2], vtk)]
    shared = {PurePath(entry[0]).name: entry for entry in files if _is_shared(*entry[:2])}
    kept = [entry for entry in files if shared.get(PurePath(entry[0]).name) != entry]
    open_ends = list(kept)
    while open_ends:
        for name in imports(open_ends.pop()[1]):
            entry = shared.pop(PurePath(name).name, None)
            if entry is not None:
                kept.append(entry)
                open_ends.append(entry)
    return kept


def is_sdl(source: str) -> bool:
    """Whether a library of the wheel of SDL is SDL itself; the others read pictures and music."""
    return re.match(r"(lib)?SDL2(-2\.0)?\.", PurePath(source).name) is not None


def kept_links(found: Iterable[Entry], kept: Iterable[Entry]) -> list[Entry]:
    """What is no link, and the links to files that are packed."""
    places = {PurePath(entry[0]).as_posix() for entry in kept}
    return [each for each in found if each[2] != "SYMLINK" or _target(*each[:2]) in places]


def _target(name: str, leads_to: str) -> str:
    return PurePath(os.path.normpath(PurePath(name).parent / leads_to)).as_posix()


def _is_wanted(name: str, source: str, vtk: Collection[str]) -> bool:
    place = PurePath(name)
    module = place.name.split(".")[0]
    if place.parts[0] == "vtkmodules" and re.search(r"\.(cpython|cp\d|abi3|pyd)", place.name):
        return f"vtkmodules.{module}" in vtk
    if source.startswith(("/usr/lib/", "/lib/")) and SYSTEM.match(place.name):
        return False
    if re.search(r"Qt/plugins/(networkinformation|generic)/", place.as_posix()):
        return False  # keyboards without a window system; whether the internet is there
    # desktops and devices without a window system, GTK, kinds of pictures that none of ours is
    unused = (
        r"(lib)?q(gtk3|eglfs|linuxfb|minimalegl|vnc|vkkhr|tuio|pdf|webp|tiff|icns|tga|wbmp|gif)"
    )
    return not re.match(unused, place.name)


def _is_shared(name: str, source: str) -> bool:
    """Whether a library is there only because another one wants it."""
    place = PurePath(name)
    if re.search(r"\.(cpython|cp\d|abi3|pyd)", place.name) or place.name.startswith("libpython"):
        return False
    if source.startswith(("/usr/lib/", "/lib/")) and "lib-dynload" not in source:
        return True
    return place.parts[0] in {"vtkmodules", "pyarrow"} or place.parts[:3] == (
        "PySide6",
        "Qt",
        "lib",
    )
