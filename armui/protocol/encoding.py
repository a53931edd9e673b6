"""Physical values to raw ones: nothing is clamped, and what cannot be said is refused in words."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from armui.protocol.errors import EncodeError

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from armui.protocol.layout import MessageLayout, SignalLayout

_STEP_NOISE = 1e-6
"""Part of a raw step by which a value may pass the end of a range: noise of the scaling."""


def raw_value(layout: MessageLayout, signal: SignalLayout, value: float | None) -> int:
    """Raw value of a physical one, rounded to the nearest raw step.

    Args:
        layout: The message, for the error's text.
        signal: The signal of that message.
        value: In the signal's unit; None for "leave unchanged".

    Raises:
        EncodeError: Out of range, not finite, outside the table, a fraction where only whole
            numbers mean something, or None where nothing can be left unchanged.
    """
    if value is None:
        if signal.unchanged_raw is None:
            raise _refused(layout, signal, None, "it cannot be left unchanged: give a value")
        return signal.unchanged_raw
    try:
        steps = signal.to_steps(value)
        finite = math.isfinite(steps)
    except (TypeError, ValueError, OverflowError):
        raise _refused(layout, signal, value, f"give a number: {allowed(signal)}") from None
    if not finite:
        raise _refused(layout, signal, value, f"give a finite number: {allowed(signal)}")
    raw = round(steps)
    if raw in signal.words and abs(steps - raw) < _STEP_NOISE:
        return raw
    if signal.exhaustive or not _within(signal, value):
        raise _refused(layout, signal, value, f"give {allowed(signal)}")
    if signal.is_count and raw != steps:
        raise _refused(layout, signal, value, f"give a whole number: {allowed(signal)}")
    return raw


def neutral_value(layout: MessageLayout, signal: SignalLayout) -> int:
    """Raw value of a signal nobody gave: "leave unchanged" where the protocol has it, else 0.

    Raises:
        EncodeError: 0 means nothing for this signal, so it must be given.
    """
    if signal.unchanged_raw is not None:
        return signal.unchanged_raw
    raw = round(signal.to_steps(0.0))
    if raw not in signal.legal_raw:
        raise _refused(layout, signal, None, f"it must be given: {allowed(signal)}")
    return raw


def chosen_variant(layout: MessageLayout, signals: Mapping[str, float | None]) -> MessageLayout:
    """The message as its selector, given or neutral, has it.

    Raises:
        EncodeError: The selector is wrong, or it leaves no room for one of the signals.
    """
    selector = layout.selector
    if selector is None:
        return layout
    given = selector.name in signals
    raw = (
        raw_value(layout, selector, signals[selector.name])
        if given
        else neutral_value(layout, selector)
    )
    variant = layout.variant_of(raw)
    for name in signals:
        if name not in variant.signals:
            selection = layout.signals[name].selection
            word = selector.words.get(selection.raw if selection else raw, "")
            raise EncodeError(
                f"{layout.name}.{name} is only there with {selector.name} = {word!r}; give that",
                message=layout.name,
                signal=name,
                value=signals[name],
            )
    return variant


def unknown_signal(layout: MessageLayout, signal: str) -> EncodeError:
    """The error for a signal the message does not have in this generation."""
    return EncodeError(
        f"{layout.name} has no signal {signal} in this generation; it has {listed(layout.signals)}",
        message=layout.name,
        signal=signal,
    )


def allowed(signal: SignalLayout) -> str:
    """What a signal may be, in words: its range, its codes or both."""
    words = listed(
        f"{number(signal.to_physical(raw), signal)} ({word})"
        for raw, word in sorted(signal.words.items())
    )
    if signal.exhaustive:
        return words
    return f"{_range(signal)}, or {words}" if words else _range(signal)


def number(value: object, signal: SignalLayout) -> str:
    """A physical value with its unit, as messages print it."""
    try:
        text = f"{value:.10g}" if isinstance(value, int | float) else repr(value)
    except OverflowError:
        text = "a number beyond any frame"
    return f"{text} {signal.unit}".rstrip()


def listed(items: Iterable[str]) -> str:
    """Items as messages list them."""
    return ", ".join(items)


def _within(signal: SignalLayout, value: float) -> bool:
    slack = signal.scale * _STEP_NOISE
    return signal.minimum - slack < value < signal.maximum + slack


def _range(signal: SignalLayout) -> str:
    return f"{signal.minimum:.10g} to {number(signal.maximum, signal)}"


def _refused(
    layout: MessageLayout, signal: SignalLayout, value: object, remedy: str
) -> EncodeError:
    given = "nothing" if value is None else number(value, signal)
    return EncodeError(
        f"{layout.name}.{signal.name} cannot be {given} (range {_range(signal)}); {remedy}",
        message=layout.name,
        signal=signal.name,
        value=value,
        minimum=signal.minimum,
        maximum=signal.maximum,
        unit=signal.unit,
    )
