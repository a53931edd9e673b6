"""Makes what is released, by one command: ``python resources/packaging/build.py release``.

Each part can be made alone: the wheel and the source archive, the folder of the program, the
packages for Linux, the zip and the installer for Windows. Everything lands in ``dist/``; what is
needed on the way, in ``build/packaging/``. Wants binutils on Linux, and a package index.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import platform
import re
import shutil
import subprocess
import sys
import tomllib
import venv
import zipfile
from collections.abc import Callable, Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import Final

HERE: Final = Path(__file__).resolve().parent
ROOT: Final = HERE.parents[1]
sys.path.insert(0, str(HERE))

from contents import EXTRAS, NOT_HERE, NOT_PACKED, imported_by  # noqa: E402 - beside this file
from linux_package import check_libraries, make_packages  # noqa: E402 - beside this file
from release_page import changes_of, check_release, page  # noqa: E402 - as above

_CONSTRAINTS: Final = HERE / "constraints.txt"
_LARGE_BYTES: Final = 5_000_000
_MOST_BYTES: Final = 600_000_000


def version() -> str:
    """The program's version, from the one place where it stands."""
    text = (ROOT / "armui" / "__init__.py").read_text(encoding="utf-8")
    found = re.search(r'^__version__ = "([^"]+)"$', text, re.MULTILINE)
    if found is None:
        raise SystemExit('armui/__init__.py names no __version__ = "…"')
    return found[1]


class Build:
    """One making of everything, with an environment of its own.

    Args:
        work: Where files are kept on the way.
        out: Where what is made lands.
        environment: An environment with the tools that is used as it is; by default one is made.
    """

    def __init__(self, work: Path, out: Path, environment: Path | None = None) -> None:
        self.work, self.out = work.resolve(), out.resolve()
        self.work.mkdir(parents=True, exist_ok=True)
        self.out.mkdir(parents=True, exist_ok=True)
        self.version = version()
        self._environment = environment and environment.absolute()
        self._wheel: list[Path] = []
        self._folder: Path | None = None

    @property
    def python(self) -> Path:
        """The Python that packs; its environment is made when it is first asked for."""
        place = self._environment or self.work / "environment"
        scripts = "Scripts/python.exe" if os.name == "nt" else "bin/python"
        python = place / scripts
        if not python.exists():
            venv.create(place, with_pip=True)
            self._install(*_packaging_tools(), python=python)
        return python

    def _call(self, *words: str | Path) -> None:
        # not among the sources: Python would find them before the wheel that is to be packed
        words_ = [str(each) for each in words]
        subprocess.run(words_, check=True, cwd=self.work)  # noqa: S603 - the tools named here

    def _install(self, *wanted: str, python: Path | None = None) -> None:
        """Have pip install packages in the versions that are kept."""
        pip = (python or self.python, "-m", "pip", "install", "-q", "-c", _CONSTRAINTS)
        self._call(*pip, *wanted)

    def lock(self) -> Path:
        """The versions that packages and checks take, anew: those that the index has today."""
        self._call(
            self.python.with_name("uv"), "pip", "compile", "-q", ROOT / "pyproject.toml",
            "--all-extras", "--universal", "--upgrade", "--python-version", "3.11",
            "--no-emit-index-url", "--no-header", "--no-annotate", "-o", _CONSTRAINTS,
        )  # fmt: skip
        versions = _CONSTRAINTS.read_text(encoding="utf-8")
        _CONSTRAINTS.write_text(f"# Made by `build.py lock`.\n{versions}", encoding="utf-8")
        return _CONSTRAINTS

    def wheel(self) -> list[Path]:
        """The wheel and the source archive, checked for an index."""
        if self._wheel:
            return self._wheel
        place = self.work / "wheel"
        shutil.rmtree(place, ignore_errors=True)
        self._call(self.python, "-m", "build", "-q", "--outdir", place, ROOT)
        made = sorted(place.iterdir())
        self._call(self.python, "-m", "twine", "check", "--strict", *made)
        self._wheel = [self._to_out(each) for each in made]
        return self._wheel

    def folder(self) -> Path:
        """The program with its Python and its libraries, in one folder that needs neither."""
        if self._folder is not None:
            return self._folder
        (wheel,) = [each for each in self.wheel() if each.suffix == ".whl"]
        self._install(f"{wheel}[adapters,gamepad,parquet]")
        self._install("--force-reinstall", "--no-deps", str(wheel))
        if os.name == "nt":
            self._call(self.python, HERE / "windows" / "make_icon.py", self.work / "armui.ico")
        place = self.work / "folder"
        shutil.rmtree(place, ignore_errors=True)
        self._call(
            self.python, "-m", "PyInstaller", "--noconfirm", "--log-level", "WARN",
            "--distpath", place, "--workpath", self.work / "pyinstaller", HERE / "armui.spec",
        )  # fmt: skip
        made = place / "armui"
        texts = made / "_internal/armui/resources/i18n/armui_zh.ts"
        if not texts.is_file():
            raise SystemExit(f"{texts} is missing: the wheel was not what was packed")
        if sys.platform == "linux":
            _strip(made)
            check_libraries(made)
        self._import_all(made)
        self._call(
            self.python, HERE / "licences.py", self.work / "pyinstaller", made / "licences", ROOT
        )
        self._tell_sizes(made)
        self._folder = made
        return made

    def _import_all(self, folder: Path) -> None:
        """Have the packed program import all that it names, and take out what does so."""
        (program,) = folder.glob("armui-imports*")
        absent = {*NOT_HERE.get(sys.platform, ()), *NOT_PACKED}
        names = sorted(imported_by(ROOT / "armui") - absent)
        self._call(program, *names, *EXTRAS)
        program.unlink()

    def _tell_sizes(self, folder: Path) -> None:
        files = [each for each in folder.rglob("*") if each.is_file() and not each.is_symlink()]
        whole = sum(each.stat().st_size for each in files)
        large = sorted(((each.stat().st_size, each) for each in files), reverse=True)
        lines = [f"{1e-6 * whole:.0f} MB in {len(files)} files; each above 5 MB:"]
        lines += [
            f"{1e-6 * size:6.1f} MB  {path.relative_to(folder).as_posix()}"
            for size, path in large
            if size > _LARGE_BYTES
        ]
        text = "\n".join(lines) + "\n"
        (self.out / f"armui-{self.version}-sizes.txt").write_text(text, encoding="utf-8")
        sys.stdout.write(text)
        if whole > _MOST_BYTES:
            raise SystemExit(f"the folder has {1e-6 * whole:.0f} MB; 600 MB are the most")

    def linux(self) -> list[Path]:
        """The packages .deb and .rpm."""
        made = make_packages(
            self.folder(), self.python, self.work / "package", self.version, _day()
        )
        return [self._to_out(each) for each in made]

    def portable(self) -> list[Path]:
        """A zip that is unpacked anywhere and started."""
        folder = self.folder()
        name = f"armui-{self.version}-{sys.platform}-{platform.machine().lower()}"
        path = self.out / f"{name}.zip"
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
            for each in sorted(folder.rglob("*")):
                if each.is_file():
                    archive.write(each, f"{name}/{each.relative_to(folder).as_posix()}")
        return [path]

    def windows(self) -> list[Path]:
        """The zip, and the installer for one user by Inno Setup."""
        script = HERE / "windows" / "armui.iss"
        self._call(
            "iscc", "/Qp", f"/DVersion={self.version}", f"/DFolder={self.folder()}",
            f"/O{self.out}", script,
        )  # fmt: skip
        return [*self.portable(), self.out / f"armui-{self.version}-setup.exe"]

    def bill(self) -> Path:
        """The bill of materials (CycloneDX) of what the folder holds."""
        path = self.work / "environment.cdx.json"
        self._call(
            self.python, "-m", "cyclonedx_py", "environment", "--output-reproducible",
            "--of", "JSON", "-o", path, self.python,
        )  # fmt: skip
        names = (self.folder() / "licences" / "names.txt").read_text(encoding="utf-8").split()
        bill = _only(json.loads(path.read_text(encoding="utf-8")), set(names), self.version)
        bill = _with_system(bill, self.folder() / "licences" / "system.json")
        made = self.out / f"armui-{self.version}.cdx.json"
        made.write_text(json.dumps(bill, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
        return made

    def licences(self) -> Path:
        """The licences of all that the folder holds, in one zip."""
        folder = self.folder() / "licences"
        path = self.out / f"armui-{self.version}-licences.zip"
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
            for each in sorted(folder.rglob("*")):
                if each.is_file():
                    archive.write(each, each.relative_to(folder).as_posix())
        return path

    def release(self) -> list[Path]:
        """All of it, and the page that says what it is."""
        changelog = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
        check_release(changelog, self.version, _tag())
        changes = changes_of(changelog, self.version)
        packages = {"linux": self.linux, "win32": self.windows}.get(sys.platform, self.portable)
        made = [*self.wheel(), *packages(), self.bill(), self.licences()]
        files = [(each.name, each.stat().st_size, _sha256(each)) for each in made]
        sums = self.out / "SHA256SUMS"
        sums.write_text("".join(f"{digest}  {name}\n" for name, _, digest in files), "utf-8")
        text = page(self.version, _day(), changes, files)
        written = self.out / f"armui-{self.version}.md"
        written.write_text(text, encoding="utf-8")
        return [*made, sums, written]

    def _to_out(self, path: Path) -> Path:
        return Path(shutil.copy2(path, self.out / path.name))


def _packaging_tools() -> list[str]:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    tools: list[str] = project["optional-dependencies"]["packaging"]
    return tools


def _tag() -> str:
    """The tag of the commit that is made, or an empty text."""
    git = shutil.which("git")
    if git is None or not (ROOT / ".git").exists():
        return ""
    words = [git, "-C", str(ROOT), "describe", "--tags", "--exact-match"]
    return subprocess.run(  # noqa: S603 - git itself
        words, check=False, capture_output=True, text=True
    ).stdout.strip()


def _day() -> str:
    seconds = os.environ.get("SOURCE_DATE_EPOCH")
    now = datetime.now(UTC)
    at = datetime.fromtimestamp(int(seconds), UTC) if seconds else now
    return f"{at:%Y-%m-%d}"


def _sha256(path: Path) -> str:
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def _strip(folder: Path) -> None:
    """Take the names of functions out of the libraries: a sixth of the folder, read by nobody.

    Libraries that a wheel's maker has patched lose their alignment by it, and are loaded no more:
    those stay as they are.
    """
    strip, readelf = shutil.which("strip"), shutil.which("readelf")
    if strip is None or readelf is None:
        raise SystemExit("strip or readelf is missing: apt install binutils")
    for each in sorted(folder.rglob("*.so*")):
        if each.is_symlink() or each.read_bytes()[:4] != b"\x7fELF":
            continue
        less = each.with_name(f"{each.name}.stripped")
        subprocess.run([strip, "--strip-unneeded", "-o", less, each], check=True)  # noqa: S603
        told = subprocess.run(  # noqa: S603 - binutils
            [readelf, "-lW", less], capture_output=True, text=True, check=True
        ).stdout
        if _is_aligned(told):
            less.replace(each)
        else:
            less.unlink()


def _is_aligned(told: str) -> bool:
    """Whether the system loads a library, by what readelf tells of its segments."""
    for line in told.splitlines():
        words = line.split()
        if words and words[0] == "LOAD":
            offset, address, align = int(words[1], 16), int(words[2], 16), int(words[-1], 16)
            if (offset - address) % align or (offset - address) % 4096:
                return False
    return True


def _only(bill: dict[str, object], names: set[str], number: str) -> dict[str, object]:
    """Leave in a bill what is packed: the tools that pack are in the same environment."""

    def key(component: dict[str, object]) -> str:
        return re.sub(r"[-_.]+", "-", str(component["name"])).lower()

    found = bill.get("components")
    components = [each for each in found if key(each) in names] if isinstance(found, list) else []
    references = {each.get("bom-ref") for each in components}
    linked = bill.get("dependencies")
    dependencies = [
        {**each, "dependsOn": [to for to in each.get("dependsOn", []) if to in references]}
        for each in (linked if isinstance(linked, list) else [])
        if each.get("ref") in references
    ]
    about = {"component": {"type": "application", "name": "armui", "version": number}}
    metadata = bill.get("metadata")
    merged = {**(metadata if isinstance(metadata, dict) else {}), **about}
    return {**bill, "metadata": merged, "components": components, "dependencies": dependencies}


def _with_system(bill: dict[str, object], told: Path) -> dict[str, object]:
    """Add to a bill what no distribution of Python names: CPython, libraries of the system."""
    components = bill["components"]
    if not isinstance(components, list):
        raise SystemExit(f"the bill of materials has no list of components but {components!r}")
    added = [
        {"type": "library", "bom-ref": each["purl"], **each}
        for each in json.loads(told.read_text(encoding="utf-8"))
    ]
    return {**bill, "components": [*components, *added]}


def main(arguments: Sequence[str] | None = None) -> int:
    """Make what is asked for, and tell where it is."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    steps = (
        "lock",
        "wheel",
        "folder",
        "linux",
        "portable",
        "windows",
        "bill",
        "licences",
        "release",
    )
    parser.add_argument("step", choices=steps)
    parser.add_argument("--out", type=Path, default=ROOT / "dist", help="(dist)")
    parser.add_argument("--work", type=Path, default=ROOT / "build" / "packaging")
    parser.add_argument("--environment", type=Path, help="one with the tools, used as it is")
    options = parser.parse_args(arguments)
    build = Build(options.work, options.out, options.environment)
    step: Callable[[], Path | list[Path]] = getattr(build, options.step)
    made = step()
    for each in made if isinstance(made, list) else [made]:
        sys.stdout.write(f"{each}\n")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
