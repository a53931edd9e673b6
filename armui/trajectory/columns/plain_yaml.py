"""Reads plain YAML, as programs write it: mappings, lists and scalars, in blocks or brackets.

Anchors, tags and texts of several lines are none of it: what holds them is not read. Nothing else
here wants a library for all of YAML.
"""

from __future__ import annotations

import re
from typing import Any, Final

_KEY: Final = re.compile(
    r"""("[^"]*"|'[^']*'|[^\s"'\[\]{}#&*!|>,-][^:#]*?|-[^\s:][^:#]*?):(?:\s+(.*))?"""
)
_COMMENT: Final = re.compile(r"(?:^|\s)#.*$")
_ITEM: Final = re.compile(r"-(?:\s+(.*))?")
_WORDS: Final = {"null": None, "~": None, "": None, "true": True, "false": False}
_FLOW: Final = re.compile(r"""\s*("[^"]*"|'[^']*'|[\[\]{},:]|[^\[\]{},:\s][^\[\]{},:]*)""")


_Line = tuple[int, str]
"""The indentation of a line, and what stands behind it."""


class _NotPlainError(Exception):
    """It is not the YAML that is read here."""


def read_yaml(text: str) -> list[Any] | None:
    """Return the documents of a text in plain YAML, or ``None`` if it is no such text."""
    documents: list[list[_Line]] = [[]]
    try:
        for line in _lines(text):
            if line[1] == "..." or line[1].startswith("---"):
                documents.append([])
            else:
                documents[-1].append(line)
        return [_document(lines) for lines in documents if lines]
    except (_NotPlainError, RecursionError):
        return None


def _lines(text: str) -> list[_Line]:
    """Return the lines that say something; brackets that go over several are one."""
    lines: list[_Line] = []
    open_brackets = 0
    for raw in text.splitlines():
        bare = _COMMENT.sub("", raw).rstrip() if "#" in raw else raw.rstrip()
        if not bare:
            continue
        body = bare.lstrip(" ")
        if open_brackets:
            lines[-1] = (lines[-1][0], f"{lines[-1][1]} {body}")
        else:
            lines.append((len(bare) - len(body), body))
        if open_brackets or "[" in body or "{" in body:
            open_brackets += sum(map(body.count, "[{")) - sum(map(body.count, "]}"))
    return lines


def _document(lines: list[_Line]) -> Any:
    value, end = _block(lines, 0)
    if end < len(lines):
        raise _NotPlainError
    return value


def _block(lines: list[_Line], at: int) -> tuple[Any, int]:
    """Return the value that begins at a line, and the first line behind it."""
    indent, text = lines[at]
    if _ITEM.fullmatch(text):
        return _list(lines, at, indent)
    if _KEY.fullmatch(text):
        return _mapping(lines, at, indent)
    return _scalar(text), at + 1


def _list(lines: list[_Line], at: int, indent: int) -> tuple[list[Any], int]:
    found: list[Any] = []
    while at < len(lines) and lines[at][0] == indent:
        item = _ITEM.fullmatch(lines[at][1])
        if item is None:
            break
        inner = item.group(1)
        is_short = inner and ":" not in inner and not inner.startswith("- ") and inner != "-"
        if inner and (is_short or not (_KEY.fullmatch(inner) or _ITEM.fullmatch(inner))):
            value, at = _scalar(inner), at + 1
        elif inner:  # what stands behind the dash begins a block of its own
            lines[at] = (indent + len(lines[at][1]) - len(inner), inner)
            value, at = _block(lines, at)
        elif at + 1 < len(lines) and lines[at + 1][0] > indent:
            value, at = _block(lines, at + 1)
        else:
            value, at = None, at + 1
        found.append(value)
    return found, at


def _mapping(lines: list[_Line], at: int, indent: int) -> tuple[dict[str, Any], int]:
    found: dict[str, Any] = {}
    while at < len(lines) and lines[at][0] == indent:
        match = _KEY.fullmatch(lines[at][1])
        if match is None:
            break
        key, inner = match.group(1).strip("\"'"), match.group(2)
        at += 1
        if inner:
            found[key] = _scalar(inner)
        elif at < len(lines) and (
            lines[at][0] > indent or (lines[at][0] == indent and _ITEM.fullmatch(lines[at][1]))
        ):
            found[key], at = _block(lines, at)
        else:
            found[key] = None
    if at < len(lines) and lines[at][0] > indent:
        raise _NotPlainError
    return found, at


def _scalar(text: str) -> Any:
    """Return a number, a word or a text; what stands in brackets as list or mapping."""
    if text[0] in "[{":
        tokens = _FLOW.findall(text)
        value, end = _flow(tokens, 0)
        if end != len(tokens):
            raise _NotPlainError
        return value
    if text[0] in "&*!|>%@`":
        raise _NotPlainError
    if text[0] in "\"'":
        return text.strip("\"'")
    try:
        return int(text)
    except ValueError:
        pass
    try:
        return float(text.replace(".nan", "nan").replace(".inf", "inf"))
    except ValueError:
        return _WORDS.get(text.lower(), text)


def _flow(tokens: list[str], at: int) -> tuple[Any, int]:
    """Return the value that begins at a token, and the token behind it."""
    if at >= len(tokens) or tokens[at] in "]},:":
        raise _NotPlainError
    if tokens[at] not in "[{":
        return _scalar(tokens[at].strip()), at + 1
    is_list, at = tokens[at] == "[", at + 1
    items: list[Any] = []
    pairs: dict[str, Any] = {}
    while at < len(tokens) and tokens[at] not in "]}":
        value, at = _flow(tokens, at)
        if not is_list:
            if tokens[at : at + 1] != [":"]:
                raise _NotPlainError
            pairs[str(value)], at = _flow(tokens, at + 1)
        else:
            items.append(value)
        if tokens[at : at + 1] == [","]:
            at += 1
    if at >= len(tokens):
        raise _NotPlainError
    return (items if is_list else pairs), at + 1
