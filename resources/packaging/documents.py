"""The man page and the completion of shells, made from the program's own options.

``python documents.py ROOT DAY``, in an environment where armui is installed.
"""

from __future__ import annotations

import argparse
import gzip
import importlib
import sys
from pathlib import Path
from typing import Final

from armui import __version__, cli

_FILES: Final = (
    ("~/.config/armui/", "settings"),
    ("~/.local/share/armui/", "trajectories and recordings"),
    ("~/.local/state/armui/log/", "logs"),
)


def parsers() -> dict[str, argparse.ArgumentParser]:
    """The parser of each command; that of the window by the name ""."""
    window, replay = cli._parser(), cli._replay_parser()  # noqa: SLF001 - the only ones
    found: dict[str, argparse.ArgumentParser] = {"": window, "replay": replay}
    for name, (module_name, purpose) in cli._COMMANDS.items():  # noqa: SLF001 - as above
        parser = argparse.ArgumentParser(prog=f"armui {name}", description=purpose)
        importlib.import_module(module_name).add_arguments(parser)
        found[name] = parser
    return found


def options_of(parser: argparse.ArgumentParser) -> list[argparse.Action]:
    """The options that are shown."""
    return [
        each
        for each in parser._actions  # noqa: SLF001 - argparse tells them nowhere else
        if each.option_strings and each.help != argparse.SUPPRESS
    ]


def man_page(day: str) -> str:
    """The page for ``man armui``."""
    lines = [
        f'.TH ARMUI 1 "{day}" "armui {__version__}" "User Commands"',
        ".SH NAME",
        r"armui \- host program for the AgileX PiPER robot arm",
        ".SH SYNOPSIS",
        ".B armui",
        "[\\fIOPTION\\fR]...",
        ".br",
        ".B armui",
        r"\fICOMMAND\fR [\fIOPTION\fR]...",
        ".SH DESCRIPTION",
        (
            "armui connects to an AgileX PiPER arm on a CAN bus and moves, programs and watches "
            "it. Without a command it opens its window."
        ),
        ".PP",
        (
            "A real arm can hurt people and break things: keep a hand at the power switch. armui "
            "is no safety device."
        ),
        ".SH OPTIONS",
    ]
    for name, parser in parsers().items():
        if name:
            lines += [f'.SH "armui {name}"', _roff(parser.description or "")]
        for each in _places(parser):
            lines += [".TP", f"\\fI{_roff(each.metavar or each.dest)}\\fR", _help(each)]
        for each in options_of(parser):
            value = "" if each.nargs == 0 else f" \\fI{_roff(_value(each))}\\fR"
            shown = ", ".join(f"\\fB{_roff(text)}\\fR" for text in each.option_strings)
            lines += [".TP", shown + value, _help(each)]
        if parser.epilog:
            lines += [".PP", ".nf", *map(_roff, parser.epilog.splitlines()), ".fi"]
    lines += [".SH FILES"]
    for place, what in _FILES:
        lines += [".TP", f"\\fI{_roff(place)}\\fR", what]
    return "\n".join(lines) + "\n"


def _places(parser: argparse.ArgumentParser) -> list[argparse.Action]:
    return [each for each in parser._actions if not each.option_strings]  # noqa: SLF001 - as above


def _value(each: argparse.Action) -> str:
    if each.choices is not None:
        return "|".join(map(str, each.choices))
    return str(each.metavar or each.dest.upper())


def _help(each: argparse.Action) -> str:
    text = (each.help or "").replace("%(default)s", str(each.default)).replace("%%", "%")
    return _roff(text) or r"\&"


def _roff(text: object) -> str:
    escaped = str(text).replace("\\", r"\e").replace("-", r"\-").replace("…", "...")
    plain = escaped.encode("ascii", "replace").decode()
    return rf"\&{plain}" if plain.startswith((".", "'")) else plain


def bash_completion() -> str:
    """For bash: commands, options, their choices, and files."""
    found = parsers()
    words = {name: " ".join(_words(parser)) for name, parser in found.items()}
    choices = sorted(
        {
            (text, " ".join(map(str, each.choices)))
            for parser in found.values()
            for each in options_of(parser)
            if each.choices is not None
            for text in each.option_strings
        }
    )
    commands = " ".join(sorted(name for name in found if name))
    lines = [
        "# completion of armui for bash",
        "_armui() {",
        '    local now="${COMP_WORDS[COMP_CWORD]}" before="${COMP_WORDS[COMP_CWORD-1]}"',
        '    case "$before" in',
        *(
            f'        {text}) COMPREPLY=($(compgen -W "{values}" -- "$now")); return ;;'
            for text, values in choices
        ),
        "    esac",
        '    case "${COMP_WORDS[1]}" in',
        *(
            f'        {name}) COMPREPLY=($(compgen -f -W "{words[name]}" -- "$now")) ;;'
            for name in sorted(found)
            if name
        ),
        f'        *) COMPREPLY=($(compgen -W "{commands} {words[""]}" -- "$now")) ;;',
        "    esac",
        "}",
        "complete -o filenames -F _armui armui",
    ]
    return "\n".join(lines) + "\n"


def _words(parser: argparse.ArgumentParser) -> list[str]:
    return [text for each in options_of(parser) for text in each.option_strings]


def zsh_completion() -> str:
    """For zsh: by way of that for bash."""
    return (
        "#compdef armui\n"
        "autoload -U +X bashcompinit && bashcompinit\n"
        "source /usr/share/bash-completion/completions/armui\n"
    )


def fish_completion() -> str:
    """For fish: commands and options with their help."""
    found = parsers()
    lines = ["# completion of armui for fish"]
    for name, parser in found.items():
        if name:
            about = _quoted(parser.description or "")
            lines.append(f"complete -c armui -n __fish_use_subcommand -a {name} -d {about}")
        condition = f"'__fish_seen_subcommand_from {name}'" if name else "__fish_use_subcommand"
        for each in options_of(parser):
            for text in each.option_strings:
                kind = f"-l {text[2:]}" if text.startswith("--") else f"-s {text[1:]}"
                values = (
                    "" if each.choices is None else f" -xa '{' '.join(map(str, each.choices))}'"
                )
                told = _quoted(each.help or "")
                lines.append(f"complete -c armui -n {condition} {kind}{values} -d {told}")
    return "\n".join(lines) + "\n"


def _quoted(text: str) -> str:
    plain = text.replace("%%", "%").replace("\\", "").replace("'", "").splitlines() or [""]
    return f"'{plain[0]}'"


def main(root: Path, day: str) -> None:
    """Write them where a system looks for them."""
    share = root / "usr/share"
    page = gzip.compress(man_page(day).encode(), 9, mtime=0)
    for place, data in (
        ("man/man1/armui.1.gz", page),
        ("bash-completion/completions/armui", bash_completion().encode()),
        ("zsh/vendor-completions/_armui", zsh_completion().encode()),
        ("fish/vendor_completions.d/armui.fish", fish_completion().encode()),
    ):
        path = share / place
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2])
