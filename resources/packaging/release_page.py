"""The page of a release: its version, what has changed, its files with their checksums."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Final

_WHAT: Final = (
    (".deb", "Debian 12 and 13, where it was tried, or later"),
    (".rpm", "other distributions with RPM; untried"),
    ("-setup.exe", "Windows 10 and later, installer for one user; untried"),
    (".zip", "Windows, unpacked anywhere; untried"),
    (".whl", "Python 3.11 to 3.13: `pipx install`"),
    (".tar.gz", "the sources"),
    (".cdx.json", "bill of materials, CycloneDX"),
    ("-licences.zip", "the licences of all that is in the packages"),
)


def changes_of(changelog: str, version: str) -> str:
    """The section of one version in the change log, without its heading.

    Raises:
        ValueError: It has none.
    """
    heading = rf"^## {re.escape(version)} – \d{{4}}-\d\d-\d\d\n"
    found = re.search(rf"{heading}(.*?)(?=^## |\Z)", changelog, re.MULTILINE | re.DOTALL)
    if found is None:
        raise ValueError(f"CHANGELOG.md has no section «## {version} – date»: write it first")
    return found[1].strip()


def check_release(changelog: str, version: str, tag: str) -> None:
    """Refuse to make a release that is not cut, or not wholly.

    Args:
        changelog: The text of CHANGELOG.md.
        version: Of the program.
        tag: Of the commit that is made, or empty where it has none.

    Raises:
        ValueError: The version is one of development, changes stand under Unreleased, or the tag
            is another version's; the message says what to do.
    """
    if ".dev" in version:
        raise ValueError(
            f"{version} is a version of development: give __version__ in armui/__init__.py the "
            f"number of the release, and its section in CHANGELOG.md"
        )
    unreleased = re.search(r"^## Unreleased\n(.*?)(?=^## |\Z)", changelog, re.MULTILINE | re.DOTALL)
    if unreleased is not None and unreleased[1].strip():
        raise ValueError(
            f"CHANGELOG.md has changes under «Unreleased» that the page of {version} would omit: "
            f"move them to its section"
        )
    if tag and tag != f"v{version}":
        raise ValueError(f"the commit's tag is {tag}, the version {version}: v{version} was meant")


def page(version: str, day: str, changes: str, files: Iterable[tuple[str, int, str]]) -> str:
    """The page in Markdown.

    Args:
        version: Of the program.
        day: Of the release, as 2026-11-23.
        changes: The section of the change log.
        files: Name, bytes and SHA-256 of each.
    """
    rows = [
        f"| {name} | {1e-6 * size:.1f} MB | {_what(name)} | `{digest}` |"
        for name, size, digest in files
    ]
    return "\n".join(
        [
            f"# armui {version} – {day}",
            "",
            "**armui is no safety device: keep a hand at the power switch.**",
            "",
            "| file | size | for | SHA-256 |",
            "| --- | --- | --- | --- |",
            *rows,
            "",
            (
                "Check what was downloaded: `sha256sum -c SHA256SUMS --ignore-missing`. Install: "
                f"double click, or `sudo apt install ./armui_{version}-1_amd64.deb`."
            ),
            "",
            (
                "Qt is used under the LGPL 3: its libraries stand beside the program as files of "
                "their own (`PySide6/Qt/lib`) and may be replaced; the text is among the licences."
            ),
            "",
            "## What has changed",
            "",
            changes,
            "",
        ]
    )


def _what(name: str) -> str:
    endings = sorted(_WHAT, key=lambda each: -len(each[0]))
    return next((text for ending, text in endings if name.endswith(ending)), "")
