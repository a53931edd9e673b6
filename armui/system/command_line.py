"""Functions shared by several of the program's commands."""

from __future__ import annotations

import argparse
import errno
import math
import os
import re
import sys
import textwrap
import unicodedata
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from functools import cache
from itertools import pairwise
from typing import Any, Final, NoReturn, TextIO

from armui.system.plain_words import (
    LANGUAGES,
    Language,
    Translate,
    language_of_system,
    settings_file,
    translation,
)
from armui.system.sentence import Sentence, Told, filled

_COLUMN: Final = 26
"""The largest column at which the help of an option begins."""
_WIDTH: Final = 79
_PARTS: Final = re.compile(r"[\x21-\x7e]+[，。；：、）”！]*|\s+|[^\x00-\x7f][，。；：、）”！]*")
"""A word or one Chinese character, with punctuation that must not begin a line; or white space."""
CONTEXT: Final = Told.context
OF_ARGPARSE: Final = (
    "%(prog)s: error: %(message)s\n",
    "argument %(argument_name)s: %(message)s",
    "ambiguous option: %(option)s could match %(matches)s",
    "expected at least one argument",
    "expected at most one argument",
    "expected one argument",
    "ignored explicit argument %r",
    "invalid %(type)s value: %(value)r",
    "invalid choice: %(value)r (choose from %(choices)s)",
    "not allowed with argument %s",
    "the following arguments are required: %s",
    "unrecognized arguments: %s",
)
"""The sentences of argparse about a wrong command line, which are translated by `say`."""
OF_SYSTEM: Final = (
    "File exists",
    "File name too long",
    "Input/output error",
    "Is a directory",
    "No space left on device",
    "No such device",
    "No such file or directory",
    "Not a directory",
    "Operation not permitted",
    "Permission denied",
    "Read-only file system",
    "Too many levels of symbolic links",
    "Connection timed out",
    "database disk image is malformed",
    "file is not a database",
    "unable to open database file",
)
"""The file errors in the words of the system and SQLite: in English, because no locale is set."""

_WHOLE_TURN_DEG: Final = 360.0


@cache
def _texts(language: Language, context: str) -> Translate:
    return translation(language, context)


def _language() -> Language:
    """Return the language asked for, or else that of the operator, if the terminal can show it."""
    asked = [after for word, after in pairwise(sys.argv) if word == "--lang"]
    spoken = "zh" if "zh" in asked else "en" if asked else language_of_system(settings_file())
    try:
        "用法".encode(getattr(sys.stdout, "encoding", None) or "ascii")
    except UnicodeEncodeError:
        return "en"
    return "zh" if spoken == "zh" else "en"


def say(text: str, /, **figures: object) -> str:
    """Return a text of the command line in the operator's language, with its figures filled in."""
    if isinstance(text, Told):
        return text.translated(_translate)
    return filled(_translate(CONTEXT, text), figures, _translate)


def say_sentence(what: Sentence, figures: Mapping[str, object]) -> str:
    """Return a declared sentence in the operator's language, with its figures filled in."""
    return filled(_translate(what.context, what.source), figures, _translate)


def _translate(context: str, text: str) -> str:
    return _texts(_language(), context)(context, text)


def wrapped(text: str, width: int) -> list[str]:
    """Return a text in lines of so many columns; a Chinese character takes two."""
    if text.isascii():
        return textwrap.wrap(text, width)
    lines, used = [""], 0
    for part in _PARTS.findall(text):
        columns = _columns(part)
        if used and used + columns > width:
            lines.append("")
            used = 0
        if used or not part.isspace():
            lines[-1] += part
            used += columns
    return [line.rstrip() for line in lines]


def _columns(text: str) -> int:
    return sum(2 if unicodedata.east_asian_width(each) in "WF" else 1 for each in text)


@contextmanager
def _argparse_translated() -> Iterator[None]:
    """Translate argparse's own sentences by `say`: it looks them up as ``argparse._``."""
    before = vars(argparse)["_"]
    setattr(argparse, "_", say)  # noqa: B010 - the type stubs do not know it
    try:
        yield
    finally:
        setattr(argparse, "_", before)  # noqa: B010 - likewise


class CommandParser(argparse.ArgumentParser):
    """Reads a command line and answers in the operator's language.

    Args:
        prog: The name of the command.
        usage: The line of its usage; by default argparse makes it from the options.
        description: What it is for.
        epilog: The text below its options.

    Attributes:
        lists: The lists set by `list_names`.
        ending: The sentence set by `list_names`.
    """

    def __init__(
        self,
        prog: str,
        *,
        usage: str | None = None,
        description: str | None = None,
        epilog: str | None = None,
    ) -> None:
        super().__init__(prog, usage, description, epilog, formatter_class=HelpFormatter)
        self.lists: Mapping[str, Mapping[str, str]] = {}
        self.ending = ""

    def format_help(self) -> str:
        """Return the help in the operator's language; its lists are translated here alone."""
        english = self.epilog
        if self.lists:
            self.epilog = _lists(self.lists, self.ending, say)
        try:
            return super().format_help()
        finally:
            self.epilog = english

    def parse_args(self, args: Any = None, namespace: Any = None) -> Any:
        """Read a command line; errors in it are reported in the operator's language."""
        with _argparse_translated():
            return super().parse_args(args, namespace)

    def error(self, message: str) -> NoReturn:
        """Print what is wrong with the command line, and exit with code 2."""
        with _argparse_translated():
            super().error(say(message))


class HelpFormatter(argparse.RawDescriptionHelpFormatter):
    """Wraps help and description; the lists after them keep their layout."""

    def __init__(self, prog: str) -> None:
        super().__init__(prog, max_help_position=_COLUMN)

    def add_text(self, text: str | None) -> None:
        """Add a text; one of a single paragraph is wrapped."""
        if text is not None and "\n" not in text and text is not argparse.SUPPRESS:
            text = "\n".join(wrapped(say(text), _WIDTH))
        super().add_text(text)

    def add_usage(
        self,
        usage: str | None,
        actions: Iterable[argparse.Action],
        groups: Iterable[argparse._MutuallyExclusiveGroup],
        prefix: str | None = None,
    ) -> None:
        """Add the usage line, translated."""
        if usage is not None:
            usage = say(usage)
        super().add_usage(usage, actions, groups, say("usage: ") if prefix is None else prefix)

    def start_section(self, heading: str | None) -> None:
        """Begin a group of options under a translated heading."""
        super().start_section(None if heading is None else say(heading))

    def _get_help_string(self, action: argparse.Action) -> str | None:
        return None if action.help is None else say(action.help)

    def _split_lines(self, text: str, width: int) -> list[str]:
        return wrapped(" ".join(text.split()), width)


def list_names(
    parser: argparse.ArgumentParser, lists: Mapping[str, Mapping[str, str]], ending: str = ""
) -> None:
    """Add lists of names with their meanings below the options, in the layout of argparse.

    Args:
        parser: The parser of the command.
        lists: By their titles; in each the meanings by the names.
        ending: A sentence below them.
    """
    parser.epilog = _lists(lists, ending, str)
    if isinstance(parser, CommandParser):
        parser.lists, parser.ending = lists, ending


def _lists(
    lists: Mapping[str, Mapping[str, str]], ending: str, spoken: Callable[[str], str]
) -> str:
    parts = [_name_list(title, meanings, spoken) for title, meanings in lists.items()]
    return "\n\n".join([*parts, *filter(None, [spoken(ending) if ending else ""])])


def _name_list(title: str, meanings: Mapping[str, str], spoken: Callable[[str], str]) -> str:
    lines = [f"{spoken(title)}:"]
    for name, meaning in meanings.items():
        first = f"  {name}".ljust(_COLUMN - 1) + " "
        if len(first) > _COLUMN:
            lines.append(first.rstrip())
            first = " " * _COLUMN
        begins, *more = wrapped(spoken(meaning), _WIDTH - _COLUMN)
        lines += [first + begins, *(" " * _COLUMN + each for each in more)]
    return "\n".join(lines)


def add_device(parser: argparse._ActionsContainer) -> None:
    """Declares the options that name a CAN adapter."""
    parser.add_argument("--interface", help="python-can's name of the adapter, e.g. socketcan")
    parser.add_argument("--channel", help="the adapter's channel, e.g. can0")
    parser.add_argument("--bitrate", type=int, help="bit/s, where the program sets it (1000000)")


def no_version(text: str, example: object) -> argparse.ArgumentTypeError:
    """Return the error that a text is no firmware version."""
    said = say("{text!r} is no firmware version; write it as {example}", text=text, example=example)
    return argparse.ArgumentTypeError(said)


def add_generation(parser: argparse.ArgumentParser) -> None:
    """Add the option for the protocol of a recorded arm."""
    parser.add_argument(
        "--generation",
        choices=("1", "2", "auto"),
        default="auto",
        help="protocol of the recorded arm; auto looks for evidence in the log (default)",
    )


def add_language(parser: argparse._ActionsContainer, of_what: str) -> None:
    """Declares the option that chooses a language for this run; `say` uses it."""
    parser.add_argument("--lang", choices=LANGUAGES, help=of_what)


def add_joints(parser: argparse._ActionsContainer, meaning: str) -> None:
    """Declares the option for the six joint angles of a simulated arm.

    Args:
        parser: The parser of the command.
        meaning: The help text: the purpose, and the angles without the option.
    """
    joints = tuple(f"J{joint}" for joint in range(1, 7))
    parser.add_argument("--joints", type=_angle, nargs=6, metavar=joints, help=meaning)


def _angle(text: str) -> float:
    try:
        angle_deg = float(text)
    except ValueError:
        angle_deg = math.nan
    if not abs(angle_deg) <= _WHOLE_TURN_DEG:
        raise argparse.ArgumentTypeError(
            say(
                "{text!r} is no angle; give degrees from -{most:g} to {most:g}",
                text=text,
                most=_WHOLE_TURN_DEG,
            )
        )
    return angle_deg


class OutputError(Exception):
    """The standard output is full or closed; the text gives the reason."""


class _Output:
    """The standard output, whose errors are told apart from all other errors.

    Args:
        stream: The stream to write to.
    """

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)

    def write(self, text: str) -> int:
        """Write a text; see `_output_failures`."""
        with _output_failures():
            return self._stream.write(text)

    def flush(self) -> None:
        """Flush the stream; see `_output_failures`."""
        with _output_failures():
            self._stream.flush()


@contextmanager
def _output_failures() -> Iterator[None]:
    """Raise errors of the standard output as types of their own.

    Raises:
        BrokenPipeError: The reader has ended, for example `head`. Windows calls that an invalid
            argument.
        OutputError: It is full, for example.
    """
    try:
        yield
    except BrokenPipeError:
        raise
    except OSError as error:
        system: str = sys.platform
        if system == "win32" and error.errno == errno.EINVAL:
            raise BrokenPipeError(errno.EPIPE, os.strerror(errno.EPIPE)) from error
        raise OutputError(error.strerror or str(error)) from error


def with_output(name: str, run: Callable[[], int]) -> int:
    """Run a command; a standard output that is full or closed costs one line on the other one.

    Args:
        name: The name of the command.
        run: Runs it, and returns its exit code.

    Returns:
        Its exit code; 0 if the reader of its output has seen enough, as `head` does; 1 if the
        output cannot be written.
    """
    own: Any = sys.stdout
    failure = Told("it is closed")
    if own is not None:
        output: Any = _Output(own)
        sys.stdout = output
        try:
            try:
                return run()
            finally:
                output.flush()
        except BrokenPipeError:
            detach_output()
            return 0
        except OutputError as error:
            failure = Told(str(error))
            detach_output()
        finally:
            sys.stdout = own
    if sys.stderr is not None:
        text = Told("the standard output cannot be written: {reason}", reason=failure)
        sys.stderr.write(f"{name}: {say(text)}\n")
    return 1


def write_out(text: str) -> None:
    """Write to the output without buffering.

    Raises:
        BrokenPipeError, OutputError: See `_output_failures`.
    """
    with _output_failures():
        sys.stdout.write(text)
        sys.stdout.flush()


def detach_output() -> None:
    """Redirect the closed output, so that the interpreter's last flush does not fail again."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, sys.stdout.fileno())
    os.close(nowhere)


def has_display() -> bool:
    """Return whether there is a desktop session in which to show a window."""
    system: str = sys.platform
    if system in {"win32", "darwin"} or os.environ.get("QT_QPA_PLATFORM"):
        return True
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))
