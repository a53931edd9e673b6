"""From facts to findings. Pure: nothing here looks at anything, nor imports what may be missing."""

from __future__ import annotations

from typing import Final

from armui.doctor.facts import Facts, PackageFacts, ProgramFacts, ScreenFacts
from armui.doctor.finding import Finding, Section, Severity
from armui.doctor.judge_arm import judge_heard
from armui.doctor.judge_can import judge_can

_APT: Final = {
    "libEGL.so.1": "libegl1",
    "libGL.so.1": "libgl1",
    "libOpenGL.so.0": "libopengl0",
    "libGLX.so.0": "libglx0",
    "libX11.so.6": "libx11-6",
    "libX11-xcb.so.1": "libx11-xcb1",
    "libdbus-1.so.3": "libdbus-1-3",
    "libfontconfig.so.1": "libfontconfig1",
    "libfreetype.so.6": "libfreetype6",
    "libglib-2.0.so.0": "libglib2.0-0",
    "libgthread-2.0.so.0": "libglib2.0-0",
    "libwayland-client.so.0": "libwayland-client0",
    "libwayland-cursor.so.0": "libwayland-cursor0",
    "libwayland-egl.so.1": "libwayland-egl1",
    "libxcb-cursor.so.0": "libxcb-cursor0",
    "libxcb-icccm.so.4": "libxcb-icccm4",
    "libxcb-image.so.0": "libxcb-image0",
    "libxcb-keysyms.so.1": "libxcb-keysyms1",
    "libxcb-randr.so.0": "libxcb-randr0",
    "libxcb-render-util.so.0": "libxcb-render-util0",
    "libxcb-shape.so.0": "libxcb-shape0",
    "libxcb-shm.so.0": "libxcb-shm0",
    "libxcb-sync.so.1": "libxcb-sync1",
    "libxcb-util.so.1": "libxcb-util1",
    "libxcb-xfixes.so.0": "libxcb-xfixes0",
    "libxcb-xinerama.so.0": "libxcb-xinerama0",
    "libxcb-xkb.so.1": "libxcb-xkb1",
    "libxcb.so.1": "libxcb1",
    "libxkbcommon-x11.so.0": "libxkbcommon-x11-0",
    "libxkbcommon.so.0": "libxkbcommon0",
    "libXrender.so.1": "libxrender1",
}
"""The Debian package of each library that Qt's Linux wheels leave to the system."""

_SOFTWARE_RENDERERS: Final = ("llvmpipe", "softpipe", "swrast", "software", "gdi generic")


def judge(facts: Facts) -> list[Finding]:
    """Every finding, in the order of sections."""
    findings: list[Finding] = []
    if facts.program is not None:
        findings += judge_program(facts.program)
    if facts.screen is not None:
        findings += judge_screen(facts.screen, facts.program)
    if facts.can is not None:
        findings += judge_can(facts.can)
    for heard in facts.heard:
        findings += judge_heard(heard)
    if facts.can is not None and not facts.heard:
        findings.append(Finding(Section.ARM, "no_device_to_listen", Severity.WARNING))
    return findings


def an_arm_answers(facts: Facts) -> bool:
    """Whether an arm's own feedback was heard; and answers, where questions were sent."""
    return any(
        heard.arm is not None and (heard.answered or not heard.asked) for heard in facts.heard
    )


def judge_program(facts: ProgramFacts) -> list[Finding]:
    """Python and packages."""
    params = {"armui": facts.armui, "version": facts.python, "system": facts.system}
    if facts.python_suffices:
        findings = [Finding(Section.PROGRAM, "python", Severity.OK, params)]
    else:
        findings = [Finding(Section.PROGRAM, "python_old", Severity.FAULT, params)]
    wrong = [each for each in facts.packages if not each.satisfied]
    findings += [_package(each, facts.executable) for each in wrong]
    needed = [each for each in facts.packages if not each.extra]
    if needed and not any(each in wrong for each in needed):
        count = {"count": str(len(needed))}
        findings.append(Finding(Section.PROGRAM, "packages", Severity.OK, count))
    return findings


def _package(facts: PackageFacts, executable: str) -> Finding:
    params = {
        "package": facts.name,
        "wanted": facts.wanted or "*",
        "installed": facts.installed or "",
        "extra": facts.extra,
    }
    command = f'{_quoted(executable)} -m pip install "{facts.name}{facts.wanted}"'
    if facts.installed is not None:
        return Finding(Section.PROGRAM, "package_other", Severity.FAULT, params, (command,))
    if facts.extra:
        return Finding(Section.PROGRAM, "package_optional", Severity.NOTE, params, (command,))
    return Finding(Section.PROGRAM, "package_missing", Severity.FAULT, params, (command,))


def judge_screen(facts: ScreenFacts, program: ProgramFacts | None) -> list[Finding]:
    """Windows and the 3D picture."""
    families = () if program is None else program.families
    findings: list[Finding] = []
    if facts.missing_libraries:
        findings.append(
            Finding(
                Section.SCREEN,
                "libraries_missing",
                Severity.FAULT,
                {"libraries": ", ".join(facts.missing_libraries)},
                _install(facts.missing_libraries, families),
            )
        )
    if facts.qt is None:
        text = {"text": facts.qt_error}
        findings.append(Finding(Section.SCREEN, "qt_not_loaded", Severity.FAULT, text))
    elif not facts.has_display:
        findings.append(
            Finding(
                Section.SCREEN,
                "no_display",
                Severity.FAULT,
                {"qt": facts.qt},
                ("export DISPLAY=:0",),
            )
        )
    elif facts.platform is None:
        params = {"qt": facts.qt, "text": facts.qt_error}
        findings.append(Finding(Section.SCREEN, "qt_platform_failed", Severity.FAULT, params))
    else:
        params = {"qt": facts.qt, "platform": facts.platform}
        findings.append(Finding(Section.SCREEN, "qt", Severity.OK, params))
    findings.append(_opengl(facts, families))
    return findings


def _opengl(facts: ScreenFacts, families: tuple[str, ...]) -> Finding:
    if facts.opengl is None:
        params = {"text": facts.opengl_error}
        commands = _install(("libEGL.so.1", "libGL.so.1", "libXrender.so.1"), families)
        return Finding(Section.SCREEN, "opengl_failed", Severity.WARNING, params, commands)
    params = {"renderer": facts.opengl}
    if any(word in facts.opengl.lower() for word in _SOFTWARE_RENDERERS):
        return Finding(Section.SCREEN, "opengl_software", Severity.NOTE, params)
    return Finding(Section.SCREEN, "opengl", Severity.OK, params)


def _install(libraries: tuple[str, ...], families: tuple[str, ...]) -> tuple[str, ...]:
    """How this distribution installs libraries that are known by their files."""
    if {"debian", "ubuntu"} & set(families):
        packages = dict.fromkeys(_APT[each] for each in libraries if each in _APT)
        return (f"sudo apt install {' '.join(packages)}",) if packages else ()
    if {"fedora", "rhel", "suse", "opensuse"} & set(families):
        tool = "dnf" if {"fedora", "rhel"} & set(families) else "zypper"
        return (f"sudo {tool} install " + " ".join(f"'{each}()(64bit)'" for each in libraries),)
    return ()


def _quoted(path: str) -> str:
    return f'"{path}"' if " " in path else path
