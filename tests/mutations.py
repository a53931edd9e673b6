"""The changes of one place of a module that its tests must notice: the operators of cosmic-ray, and
statements left out."""

from __future__ import annotations

import ast
import difflib
import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

_IS_NO_FAULT = ("# noqa", "TYPE_CHECKING", "__slots__", "@dataclass(")
_BY_IDENTITY = re.compile(r"Operator_(Is|IsNot)_(?!Is)")
"""What is compared by identity is ``None``, a member of an enumeration or a truth value: equality
is the same there, and an order is a fault of types."""
_BITS = re.compile(r"Operator_(Add|Sub|Mul|Div|Mod)_(Bit|[LR]Shift)")
"""Arithmetic is done with times, angles and speeds, which have no bits."""


@dataclass(frozen=True)
class Mutant:
    """One change of one module.

    Attributes:
        operator: cosmic-ray's name of it.
        source: The module's text with it.
        change: The lines that differ.
    """

    operator: str
    source: str
    change: str


def mutants(source: str) -> Iterator[Mutant]:
    """Every change of a module's text that is not only in a string of documentation."""
    import cosmic_ray.plugins as plugins  # noqa: PLC0415 - needed for this command only
    from cosmic_ray.ast import ast_nodes, get_ast  # noqa: PLC0415
    from cosmic_ray.mutating import mutate_code  # noqa: PLC0415

    seen = {_meaning(source), None}
    nodes = list(ast_nodes(get_ast(source)))
    for name in sorted(plugins.operator_names()):
        operator = plugins.get_operator(name)
        if operator.arguments() or _BY_IDENTITY.search(name) or _BITS.search(name):
            continue
        for occurrence in range(_places(operator(), nodes)):
            changed = mutate_code(source, operator(), occurrence)
            text = changed.decode() if isinstance(changed, bytes) else changed
            change = _difference(source, text)
            meaning = _meaning(text)
            if meaning not in seen and not _is_no_fault(name, change):
                seen.add(meaning)
                yield Mutant(name, text, change)
    for text in _without_a_statement(source):
        yield Mutant("a statement left out", text, _difference(source, text))


def _without_a_statement(source: str) -> Iterator[str]:
    """A module without one of its calls, or without one of the values it keeps.

    A local name that is not set any more is a fault that every test finds.
    """
    lines = source.splitlines()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Assign):
            places = [part for target in node.targets for part in ast.walk(target)]
            kept = any(isinstance(place, ast.Attribute | ast.Subscript) for place in places)
        elif isinstance(node, ast.AugAssign):
            kept = True
        else:
            kept = isinstance(node, ast.Expr) and isinstance(node.value, ast.Call)
        if kept and isinstance(node, ast.stmt) and node.col_offset > 0:
            indent = " " * node.col_offset
            rest = lines[node.end_lineno :]
            yield "\n".join([*lines[: node.lineno - 1], f"{indent}pass", *rest, ""])


def _is_no_fault(name: str, change: str) -> bool:
    """Whether a change alters only what the type checker or another check looks after."""
    unchecked = "strict=False" in change and name.endswith("ReplaceTrueWithFalse")
    return unchecked or any(word in change for word in _IS_NO_FAULT)


def _places(operator: Any, nodes: list[Any]) -> int:
    """How many places of a module an operator can change."""
    try:
        return sum(len(list(operator.mutation_positions(node))) for node in nodes)
    except AttributeError:  # a tuple of exceptions is more than the operator knows
        return 0


def _meaning(source: str) -> str | None:
    """What a module does, without its annotations: nothing evaluates them; ``None``: nothing."""
    try:
        tree = ast.parse(source)
    except SyntaxError:
        return None
    for node in ast.walk(tree):
        if isinstance(node, ast.AnnAssign | ast.arg):
            node.annotation = ast.Constant(None)
        elif isinstance(node, ast.arguments):
            # whether an argument may be given by its place, too, is the type checker's matter
            node.args = [*node.posonlyargs, *node.args, *node.kwonlyargs]
            node.defaults = [*node.defaults, *filter(None, node.kw_defaults)]
            node.posonlyargs, node.kwonlyargs, node.kw_defaults = [], [], []
        elif isinstance(node, ast.FunctionDef):
            node.returns = None
    return ast.dump(tree)


def _difference(before: str, after: str) -> str:
    lines = difflib.unified_diff(before.splitlines(), after.splitlines(), n=0, lineterm="")
    return "\n".join(f"    {line}" for line in lines if not line.startswith(("---", "+++")))
