"""What is measured, and what armui tells: typed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Generic, TypeVar, cast

from armui_client.errors import Invalid, Stale

Six = tuple[float, float, float, float, float, float]
T = TypeVar("T")


@dataclass(frozen=True)
class Measured(Generic[T]):
    """A measured value.

    Attributes:
        value: ``None`` if it was never heard; of six values, if one of them was not.
        age_s: The time from its measuring to armui's answer.
        fresh: True if it is at most 0.5 s old.
    """

    value: T | None = None
    age_s: float | None = None
    fresh: bool = False

    def get(self, max_age_s: float = 0.5) -> T:
        """Return the value.

        Raises:
            Stale: It is older, or was never heard.
        """
        if self.value is None or self.age_s is None:
            raise Stale("The arm has not told this value.")
        if self.age_s > max_age_s:
            raise Stale(f"The value is {self.age_s:.2f} s old; wanted: at most {max_age_s:g} s.")
        return self.value


@dataclass(frozen=True)
class Status:
    """What the arm says of itself, in the words of its protocol.

    A word is a number where the protocol has no word for it.
    """

    control_mode: str | int
    arm_status: str | int
    move_mode: str | int
    reached: bool
    joints_beyond_limits: tuple[int, ...]
    joints_without_communication: tuple[int, ...]


@dataclass(frozen=True)
class State:
    """The measured state of the arm. A field that was not asked for has no value.

    Attributes:
        sequence: Counts up with each change.
    """

    sequence: int
    joints_deg: Measured[Six] = Measured()
    flange_pose_mm_deg: Measured[Six] = Measured()
    joint_speeds_deg_s: Measured[Six] = Measured()
    joint_currents_a: Measured[Six] = Measured()
    motor_temperatures_c: Measured[Six] = Measured()
    driver_temperatures_c: Measured[Six] = Measured()
    supply_v: Measured[Six] = Measured()
    enabled: Measured[tuple[bool, ...]] = Measured()
    gripper_mm: Measured[float] = Measured()
    gripper_deg: Measured[float] = Measured()
    gripper_torque_nm: Measured[float] = Measured()
    gripper_enabled: Measured[bool] = Measured()
    status: Measured[Status] = Measured()


@dataclass(frozen=True)
class Event:
    """An event of armui: what was done, what happened, with the time of day in ISO 8601."""

    at: str
    id: str
    level: str
    text: str
    figures: Mapping[str, Any]


@dataclass(frozen=True)
class Offered:
    """An operation that can be called.

    Attributes:
        id: For :meth:`Arm.call`.
        moves: True if it moves the arm.
        asks_the_operator: True if the operator must hold a button for it each time.
        why_not: What speaks against it now, or ``None``.
    """

    id: str
    title: str
    moves: bool
    asks_the_operator: bool
    why_not: str | None


@dataclass(frozen=True)
class Listed:
    """A trajectory or recording of the operator's library.

    Attributes:
        kind: "points" or "recording".
        count: The number of points or samples.
        length_s: How long it takes, ``None`` if that is not known yet.
        modified: The time of day of its last change in ISO 8601.
        check: How its last check ended: "ok", "warnings", "errors"; ``None`` without one.
        has_run: False if nobody has seen it run.
        damage: What is wrong with its file, or ``None``.
    """

    name: str
    kind: str
    count: int
    length_s: float | None
    modified: str
    note: str
    folder: str
    check: str | None
    has_run: bool
    damage: str | None


@dataclass(frozen=True)
class Finding:
    """What a check has found.

    Attributes:
        severity: "error": it is not run; "warning": the operator may accept it.
        row: The point or sample, from 1; ``None``: the whole.
        of_approach: True if it is about the way there from where the arm stands.
    """

    id: str
    severity: str
    text: str
    figures: Mapping[str, Any]
    row: int | None
    of_approach: bool


@dataclass(frozen=True)
class Checked:
    """The result of a check.

    Attributes:
        errors: The number of findings that forbid a run.
        warnings: The number of those that the operator may accept.
        findings: The first thousand, errors first.
        length_s: How long it takes at its own speed.
    """

    name: str
    errors: int
    warnings: int
    findings: tuple[Finding, ...]
    length_s: float | None


@dataclass(frozen=True)
class Plan(Checked):
    """The result of a check, with the path.

    Attributes:
        expected_s: The time of each point from the one before.
        times_s: The times of some places on the path, from 0.
        joints_deg: The six angles at each.
        rows: The point to which the arm is on its way there, from 1.
    """

    expected_s: tuple[float, ...]
    times_s: tuple[float, ...]
    joints_deg: tuple[Six, ...]
    rows: tuple[int, ...]


def checked_of(told: Mapping[str, Any]) -> Checked:
    """Return what armui has told as the result of a check."""
    return Checked(**{**told, "findings": _findings_of(told)})


def plan_of(told: Mapping[str, Any]) -> Plan:
    """Return what armui has told as a plan."""
    lists = {name: tuple(told[name]) for name in ("expected_s", "times_s", "rows")}
    joints_deg = tuple(map(as_six, told["joints_deg"]))
    return Plan(**{**told, **lists, "joints_deg": joints_deg, "findings": _findings_of(told)})


def _findings_of(told: Mapping[str, Any]) -> tuple[Finding, ...]:
    return tuple(Finding(**each) for each in told["findings"])


def fields_of(fields: Sequence[str] | None) -> dict[str, Any]:
    """Return the arguments that ask for these fields, or for all."""
    return {} if fields is None else {"fields": list(fields)}


def six(values: Sequence[float]) -> list[float]:
    """Return six numbers as plain ones, whatever they come in: a list, a tuple, an array.

    Raises:
        Invalid: They are not six.
    """
    numbers = [float(each) for each in values]
    if len(numbers) != 6:
        raise Invalid(f"Six numbers are wanted, not {len(numbers)}.")
    return numbers


def as_six(values: Sequence[float]) -> Six:
    """Return what armui has told as six numbers."""
    return cast("Six", tuple(values))


def state_of(told: Mapping[str, Any]) -> State:
    """Return what armui has told as a state."""
    found: dict[str, Any] = {}
    for name, each in told["measured"].items():
        value = each["value"]
        if isinstance(value, list):
            value = None if None in value else tuple(value)
        elif isinstance(value, dict):
            value = _status_of(value)
        found[name] = Measured(value, each["age_s"], each["fresh"])
    return State(told["sequence"], **found)


def _status_of(told: Mapping[str, Any]) -> Status:
    return Status(
        told["control_mode"],
        told["arm_status"],
        told["move_mode"],
        told["reached"],
        tuple(told["joints_beyond_limits"]),
        tuple(told["joints_without_communication"]),
    )
