"""The error raised when something cannot be said to the arm."""

from __future__ import annotations


class EncodeError(ValueError):
    """A command that has no frame: unknown name, value out of range, code outside the table.

    Nothing has been sent when it is raised. The text names message, signal, value, what is allowed
    and what to do.

    Attributes:
        message: Name of the message asked for.
        signal: Name of the signal at fault, "" when the message itself is unknown.
        value: The value given, None when none was.
        minimum: Smallest value allowed, None where there is no range.
        maximum: Largest value allowed, None where there is no range.
        unit: Unit of value, minimum and maximum.
    """

    def __init__(
        self,
        text: str,
        *,
        message: str,
        signal: str = "",
        value: object = None,
        minimum: float | None = None,
        maximum: float | None = None,
        unit: str = "",
    ) -> None:
        super().__init__(text)
        self.message = message
        self.signal = signal
        self.value = value
        self.minimum = minimum
        self.maximum = maximum
        self.unit = unit
