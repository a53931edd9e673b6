"""Sentences beside what raises them: ids that stay, figures that fit, and none that nobody says."""

from __future__ import annotations

import ast
import json
import pickle
import string
from collections import Counter
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

from armui.arm.refusal import Reason, Refusal
from armui.control.events import Notice
from tests.translations import KEPT, KINDS, ROOT, SENTENCES, Constant, constants, modules

RAISERS = {"broken", "SceneError"}
"""They take a sentence and its figures."""
EMITTERS = {"emit_event", "_emit_event", "close", "_close", "report", "_report"}
"""They take a notice among other things, and its figures by name."""
HELPS_A_FIGURE = {"joint", "parameter", "unit"}
"""Not in the sentence itself: a parameter's name says its joint, its kind says the unit."""
OF_THE_EVENT = {"count", "feedback", "frames", "lamp", "reason", "values"}
"""An event keeps more than its sentence shows."""


@pytest.fixture(scope="module", autouse=True)
def names_end_with_the_module(trees_end_with_the_module):
    """They are kept by tree."""
    yield
    known.cache_clear()


@cache
def by_place() -> dict[tuple[Path, str], Constant]:
    """The sentences that are constants of their module."""
    return {(each.path, each.name): each for each in constants() if not each.owner}


def figures_of(source: str) -> set[str]:
    return {name for _, name, _, _ in string.Formatter().parse(source) if name}


@cache
def known(path: Path, tree: ast.Module) -> dict[str, Constant]:
    """The sentences that a module has names for: its own, and those it imports, with ``a.NAME``."""
    names = {name: each for (place, name), each in by_place().items() if place == path}
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.module:
            there = ROOT / f"{node.module.replace('.', '/')}.py"
            for alias in node.names:
                if (there, alias.name) in by_place():
                    names[alias.asname or alias.name] = by_place()[there, alias.name]
                module = there.with_suffix("") / f"{alias.name}.py"
                names |= {
                    f"{alias.name}.{name}": each
                    for (place, name), each in by_place().items()
                    if place == module
                }
    return names


def name_of(node: ast.AST) -> str:
    """The name, or module and name, that is read there; "" for anything else."""
    match node:
        case ast.Name(id=name, ctx=ast.Load()):
            return name
        case ast.Attribute(value=ast.Name(id=module), attr=name):
            return f"{module}.{name}"
    return ""


def raised(path: Path, tree: ast.Module) -> Iterator[tuple[Constant, ast.Call]]:
    """Each place that raises a sentence and gives its figures by name."""
    names = known(path, tree)
    for node in ast.walk(tree):
        match node:
            case ast.Call(func=ast.Name(id=how), args=[what, *_]) if how in RAISERS:
                said = [what]
            case ast.Call(func=ast.Attribute(attr=how) | ast.Name(id=how), args=told) if (
                how in EMITTERS
            ):
                said = told
            case ast.Call(func=what):
                said = [what]
            case _:
                continue
        for each in said:
            either = (each.body, each.orelse) if isinstance(each, ast.IfExp) else (each,)
            for one in either:
                if name_of(one) in names:
                    yield names[name_of(one)], node


def test_an_id_is_given_once_in_its_context_and_is_the_constants_name():
    ids = Counter((each.context, each.id) for each in constants())
    assert [each for each, count in ids.items() if count > 1] == []
    named = {each.name: {each.id, f"{each.id}_notice"} for each in constants()}
    assert [name for name, names in named.items() if name.lower() not in names] == []


def test_each_is_a_constant_of_its_module_with_literal_arguments():
    kinds = {kind.__name__ for kind in KINDS}
    calls = sum(
        isinstance(node, ast.Call)
        and isinstance(node.func, ast.Name)
        and node.func.id in kinds
        and len(node.args) > 1
        for _, tree in modules()
        for node in ast.walk(tree)
    )
    assert calls == len(constants()) > 600


def test_the_figures_given_are_those_of_the_sentence():
    wrong = []
    looked_at = 0
    for path, tree in modules():
        for each, call in raised(path, tree):
            given = {keyword.arg for keyword in call.keywords}
            wanted = figures_of(each.source)
            missing = set() if None in given else wanted - given
            spare = given - wanted - HELPS_A_FIGURE - {None}
            if each.context == Notice.context:
                spare -= OF_THE_EVENT
            if missing or spare:
                place = f"{path.relative_to(ROOT)}:{call.lineno}"
                wrong.append((place, each.name, missing, spare))
            looked_at += 1
    assert wrong == []
    assert looked_at > 580


def test_each_is_raised_or_asked_for():
    used: set[object] = {
        known(path, tree)[name_of(node)]
        for path, tree in modules()
        for node in ast.walk(tree)
        if name_of(node) in known(path, tree)
    }
    used |= {
        (node.value.id, node.attr)
        for _, tree in modules()
        for node in ast.walk(tree)
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name)
    }
    assert [each for each in constants() if {each, (each.owner, each.name)}.isdisjoint(used)] == []


def test_what_files_name_is_kept_by_id():
    kept = json.loads(SENTENCES.read_text(encoding="utf-8"))
    for context in [kind.context for kind in KEPT]:
        said = {each.id: each.source for each in constants() if each.context == context}
        assert said.items() <= kept[context].items()


def test_a_reason_is_the_same_by_its_id():
    reason = Reason("too_far", "{value} m is too far.")
    refusal = reason(value=3)
    assert refusal == Refusal(Reason("too_far"), {"value": 3})
    assert pickle.loads(pickle.dumps(refusal)).reason == reason
    assert refusal.code == "too_far"
    assert str(refusal) == "too_far(value=3)"
