"""Reasons against an action: ids that stay, figures that fit, and none that nothing raises."""

from __future__ import annotations

import ast
import json
import pickle
import string
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from armui.arm.refusal import Reason, Refusal
from tests.translations import REFUSALS, ROOT, reasons

REASONS = {each.name: each for each in reasons()}
RAISERS = {"broken", "SceneError"}
"""They take a reason and its figures."""
HELPS_A_FIGURE = {"joint", "parameter", "unit"}
"""Not in the sentence itself: a parameter's name says its joint, its kind says the unit."""


def trees() -> Iterator[tuple[Path, ast.Module]]:
    for path in sorted((ROOT / "armui").rglob("*.py")):
        yield path, ast.parse(path.read_text(encoding="utf-8"))


def figures_of(source: str) -> set[str]:
    return {name for _, name, _, _ in string.Formatter().parse(source) if name}


def raised(tree: ast.Module) -> Iterator[tuple[str, ast.Call]]:
    """Each place that raises a reason and gives its figures by name."""
    for node in ast.walk(tree):
        match node:
            case ast.Call(func=ast.Name(id=name)) if name in REASONS:
                yield name, node
            case ast.Call(func=ast.Name(id=how), args=[ast.Name(id=name), *_]) if (
                how in RAISERS and name in REASONS
            ):
                yield name, node


def test_an_id_is_given_once_and_is_the_constants_name():
    ids = Counter(each.id for each in reasons())
    assert [each for each, count in ids.items() if count > 1] == []
    assert [each.name for each in reasons() if each.id != each.name.lower()] == []


def test_every_reason_is_a_constant_of_its_module_with_literal_arguments():
    calls = sum(
        isinstance(node, ast.Call)
        and isinstance(node.func, ast.Name)
        and node.func.id == "Reason"
        and len(node.args) == 2
        for _, tree in trees()
        for node in ast.walk(tree)
    )
    assert calls == len(list(reasons())) > 250


def test_the_figures_given_are_those_of_the_sentence():
    wrong = []
    looked_at = 0
    for path, tree in trees():
        for name, call in raised(tree):
            given = {keyword.arg for keyword in call.keywords}
            wanted = figures_of(REASONS[name].source)
            missing = set() if None in given else wanted - given
            spare = given - wanted - HELPS_A_FIGURE - {None}
            if missing or spare:
                wrong.append((f"{path.relative_to(ROOT)}:{call.lineno}", name, missing, spare))
            looked_at += 1
    assert wrong == []
    assert looked_at > 300


def test_every_reason_is_raised_or_asked_for():
    used = Counter(
        node.id
        for _, tree in trees()
        for node in ast.walk(tree)
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)
    )
    assert [name for name in REASONS if not used[name]] == []


def test_the_sentences_are_kept_by_id():
    kept = json.loads(REFUSALS.read_text(encoding="utf-8"))
    assert {each.id: each.source for each in reasons()}.items() <= kept.items()


def test_a_reason_is_the_same_by_its_id():
    reason = Reason("too_far", "{value} m is too far.")
    refusal = reason(value=3)
    assert refusal == Refusal(Reason("too_far"), {"value": 3})
    assert pickle.loads(pickle.dumps(refusal)).reason == reason
    assert refusal.code == "too_far"
    assert str(refusal) == "too_far(value=3)"
