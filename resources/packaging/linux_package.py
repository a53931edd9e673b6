"""The packages for Linux: what is put where, what is asked of the system, made by nfpm."""

from __future__ import annotations

import gzip
import json
import platform
import re
import shutil
import subprocess
import tomllib
from datetime import UTC, datetime
from email.utils import format_datetime
from pathlib import Path
from typing import Final

HERE: Final = Path(__file__).resolve().parent
ROOT: Final = HERE.parents[1]
_ADAPTER_HELPER: Final = "usr/libexec/armui-adapter"
_ID: Final = "org.armui.armui"
_ARCHITECTURES: Final = {"x86_64": "amd64", "aarch64": "arm64"}
_FONTS: Final = "fonts-noto-cjk | fonts-wqy-microhei | fonts-wqy-zenhei | fonts-arphic-uming"
"""The program speaks Chinese first: without one of these its windows are empty boxes."""


def needed_libraries(folder: Path) -> dict[str, set[str]]:
    """Library names that files of a folder want and that are not in it, with who wants them."""
    files = [
        each
        for each in sorted(folder.rglob("*"))
        if each.is_file() and not each.is_symlink() and _is_elf(each)
    ]
    there = {each.name for each in folder.rglob("*.so*")}
    readelf = shutil.which("readelf")
    if readelf is None:
        raise SystemExit("readelf is missing: apt install binutils")
    wanted: dict[str, set[str]] = {}
    for each in files:
        told = subprocess.run(  # noqa: S603 - binutils
            [readelf, "-dW", each], capture_output=True, text=True, check=True
        ).stdout
        for name in re.findall(r"\(NEEDED\).*\[(.+)\]", told):
            if name not in there:
                wanted.setdefault(name, set()).add(each.relative_to(folder).as_posix())
    return wanted


def _is_elf(path: Path) -> bool:
    with path.open("rb") as file:
        return file.read(4) == b"\x7fELF"


def _libraries() -> dict[str, dict[str, str]]:
    text = (HERE / "linux" / "libraries.toml").read_text(encoding="utf-8")
    found: dict[str, dict[str, str]] = tomllib.loads(text)
    return found


def check_libraries(folder: Path) -> None:
    """Refuse a folder that wants a library nobody declares.

    Raises:
        SystemExit: It does; the message names library and file.
    """
    known = _libraries()["wanted"]
    unknown = {name: by for name, by in needed_libraries(folder).items() if name not in known}
    if unknown:
        lines = [f"{name}, wanted by {min(by)}" for name, by in sorted(unknown.items())]
        raise SystemExit(
            "declare in resources/packaging/linux/libraries.toml, or pack:\n" + "\n".join(lines)
        )


def depends(folder: Path) -> tuple[list[str], list[str]]:
    """What the package asks of the system, for .deb and for .rpm."""
    libraries = _libraries()
    wanted = sorted(needed_libraries(folder))
    debian = {libraries["wanted"][name] for name in wanted}
    debian |= set(libraries["loaded"].values()) | {_FONTS}
    rpm = {f"{name}()(64bit)" for name in (*wanted, *libraries["loaded"]) if ".so" in name}
    rpm |= {"mesa-dri-drivers", "hicolor-icon-theme", f"libc.so.6({oldest_glibc(folder)})(64bit)"}
    return sorted(debian), sorted(rpm)


def oldest_glibc(folder: Path) -> str:
    """The lowest version of the C library that all files of a folder can be loaded with."""
    readelf = shutil.which("readelf") or "readelf"
    versions = {(2, 0)}
    for each in sorted(folder.rglob("*")):
        if each.is_file() and not each.is_symlink() and _is_elf(each):
            told = subprocess.run(  # noqa: S603 - binutils
                [readelf, "-VW", each], capture_output=True, text=True, check=True
            ).stdout
            found = re.findall(r"Name: GLIBC_(\d+)\.(\d+)", told)
            versions |= {(int(major), int(minor)) for major, minor in found}
    return "GLIBC_{}.{}".format(*max(versions))


def make_packages(folder: Path, python: Path, work: Path, version: str, day: str) -> list[Path]:
    """Pack the program's folder.

    Args:
        folder: As PyInstaller makes it.
        python: Of the environment that packs.
        work: Where files are kept on the way.
        version: Of the program.
        day: Of the release, as 2026-11-23.
    """
    shutil.rmtree(work, ignore_errors=True)
    root = work / "root"
    debian, rpm = depends(folder)
    _lay_out(folder, root, version, day)
    subprocess.run(  # noqa: S603 - beside this file
        [python, HERE / "documents.py", root, day], check=True, cwd=work
    )
    _settle_rights(root)
    text = (HERE / "linux" / "nfpm.yaml").read_text(encoding="utf-8")
    filled: dict[str, str] = {
        "ARCH": _ARCHITECTURES.get(platform.machine(), platform.machine()),
        "VERSION": _packaged(version),
        "ROOT": str(root),
        "LINUX": str(HERE / "linux"),
        "DEB_DEPENDS": json.dumps(debian),
        "RPM_DEPENDS": json.dumps(rpm),
    }
    recipe = work / "nfpm.yaml"
    recipe.write_text(re.sub(r"@([A-Z_]+)@", lambda each: filled[each[1]], text), "utf-8")
    nfpm = python.with_name("nfpm")
    made = []
    for kind in ("deb", "rpm"):
        subprocess.run(  # noqa: S603 - installed beside Python
            [nfpm, "package", "-f", recipe, "-p", kind, "-t", work], check=True, cwd=work
        )
        made += sorted(work.glob(f"*.{kind}"))
    return [_pressed(each, work) if each.suffix == ".deb" else each for each in made]


def _pressed(package: Path, work: Path) -> Path:
    """Pack a .deb again by Debian's own xz: on all cores, and tighter than nfpm's."""
    unpacked = work / "unpacked"
    for words in (
        ("dpkg-deb", "--raw-extract", str(package), str(unpacked)),
        ("dpkg-deb", "--root-owner-group", "-Zxz", "--build", str(unpacked), str(package)),
    ):
        subprocess.run(words, check=True, stdout=subprocess.DEVNULL)  # noqa: S603 - Debian's own
    shutil.rmtree(unpacked)
    return package


def _lay_out(folder: Path, root: Path, version: str, day: str) -> None:
    share, linux = root / "usr/share", HERE / "linux"
    program = root / "usr/lib/armui"
    shutil.copytree(folder, program, symlinks=True)
    documents = share / "doc/armui"
    documents.mkdir(parents=True)
    (program / "licences").rename(documents / "licences")
    (root / "usr/bin").mkdir()
    (root / "usr/bin/armui").symlink_to("../lib/armui/armui")
    for name, place in (
        (f"{_ID}.desktop", share / "applications"),
        ("armui.svg", share / "icons/hicolor/scalable/apps"),
        (f"{_ID}.xml", share / "mime/packages"),
    ):
        place.mkdir(parents=True)
        shutil.copyfile(linux / name, place / name)
    for name, place in (
        ("adapter_helper.py", root / _ADAPTER_HELPER),
        ("org.armui.adapter.policy", share / "polkit-1/actions/org.armui.adapter.policy"),
    ):
        place.parent.mkdir(parents=True)
        shutil.copyfile(linux / name, place)
    metainfo = (linux / f"{_ID}.metainfo.xml").read_text(encoding="utf-8")
    told = metainfo.replace("@VERSION@", version).replace("@DATE@", day)
    (share / "metainfo").mkdir()
    (share / f"metainfo/{_ID}.metainfo.xml").write_text(told, encoding="utf-8")
    shutil.copyfile(linux / "copyright", documents / "copyright")
    _write_gzip(documents / "changelog.gz", (ROOT / "CHANGELOG.md").read_bytes())
    _write_gzip(documents / "changelog.Debian.gz", _debian_changes(version, day).encode())
    overrides = share / "lintian/overrides"
    overrides.mkdir(parents=True)
    shutil.copyfile(linux / "lintian-overrides", overrides / "armui")


def _packaged(version: str) -> str:
    """The version as dpkg and rpm sort it: one of development before its release."""
    return version.replace(".dev", "~dev")


def _debian_changes(version: str, day: str) -> str:
    at = datetime.strptime(day, "%Y-%m-%d").replace(tzinfo=UTC)
    return (
        f"armui ({_packaged(version)}-1) unstable; urgency=medium\n\n"
        "  * What has changed stands in changelog.gz.\n\n"
        f" -- The armui authors <armui@localhost>  {format_datetime(at)}\n"
    )


def _write_gzip(path: Path, data: bytes) -> None:
    path.write_bytes(gzip.compress(data, 9, mtime=0))


def _settle_rights(root: Path) -> None:
    """Whoever makes the package may have other habits than a system."""
    for each in root.rglob("*"):
        if each.is_symlink():
            continue
        runs = each.is_dir() or each in {root / "usr/lib/armui/armui", root / _ADAPTER_HELPER}
        each.chmod(0o755 if runs else 0o644)
