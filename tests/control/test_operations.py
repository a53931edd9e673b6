"""Every operation is declared once, has its words, and says in any state whether it may be done."""

from __future__ import annotations

import inspect
import itertools
import re
from collections.abc import Iterator
from typing import Any, get_type_hints

import pytest

from armui.arm.figures import WHOLE_OUT_OF_RANGE, figures_of
from armui.arm.refusal import Reason, Refusal
from armui.control.authority import Authority
from armui.control.link.link_state import LinkState
from armui.control.motion.motion_command import End
from armui.control.operating_state import OperatingState
from armui.control.operations.operation import Consent, Operations, declare, operation, operation_of
from armui.control.operations.started import Ending, Started
from armui.control.safety.reference_status import ReferenceStatus
from armui.control.sessions.progress import EpisodePhase
from armui.protocol.codes import EndLoad, TeachingState, TrajectoryCommand
from armui.protocol.generation import Generation
from armui.ui import words
from tests.control.test_recovery_rules import online, without_link
from tests.translations import ROOT
from tests.ui.test_translation import committed  # noqa: F401 - a fixture

EVERY_STATE = 61
"""One of so many of the recovery's states: some hundred are left, of each kind some."""

ARGUMENTS: dict[str, tuple[dict[str, Any], ...]] = {
    "teaching.command": tuple({"command": each} for each in TeachingState if each),
    "planned.command": tuple(
        {"command": TrajectoryCommand[name]}
        for name in ("PAUSE", "CONTINUE", "CLEAR_CURRENT", "CLEAR_ALL", "ABORT")
    ),
    "reference.drive": ({"joint": 1},),
}
"""What a reason may depend on beside the state."""

OTHERWISE = {"run.go_on", "settings.read"}
"""What asks, records and refuses in its own way: there is not always a record, or nothing is told.
"""


def operating_states() -> Iterator[OperatingState]:
    found = (now for _state, now in itertools.chain(without_link(), online()))
    yield from itertools.islice(found, 0, None, EVERY_STATE)
    yield OperatingState()
    for generation in (None, *Generation):
        for pending in ("teaching", "linkage", "settings", "end_reports"):
            yield OperatingState(
                link=LinkState.ONLINE,
                generation=generation,
                pending=frozenset({pending}),
                cannot_move=None,
                cannot_run=None,
                cannot_enable=None,
            )
            yield OperatingState(
                link=LinkState.ONLINE, generation=generation, running=True, run_sets_lamps=True
            )
    for reference in (ReferenceStatus((5,)), ReferenceStatus((5,), checking=True, looked=True)):
        yield OperatingState(link=LinkState.ONLINE, reference=reference, speed_percent=30)
    for episode in EpisodePhase:
        yield OperatingState(link=LinkState.ONLINE, episode=episode)
    for generation in Generation:  # everything is as it should be, with a gripper; then a run
        for running in (False, True):
            yield OperatingState(
                link=LinkState.ONLINE,
                generation=generation,
                gripper_heard=True,
                running=running,
                speed_percent=30,
                cannot_move=None,
                cannot_run=None,
                cannot_enable=None,
            )


def test_every_plain_number_of_an_operation_has_its_range(rig):
    for name, bound in rig.controller.operations.items():
        method = bound.carry_out
        figures = figures_of(getattr(method, "__func__", method))
        plain = {
            argument
            for argument, hint in get_type_hints(method).items()
            if hint in {int, float} and argument != "return"
        }
        assert figures.keys() == plain, name


def test_what_is_out_of_its_range_is_refused_and_not_begun(rig):
    rig.ready()
    rig.heard()
    operations = rig.controller.operations
    for name, joint in (("motors.enable", 0), ("joints.clear_error", 8), ("joints.set_zero", -1)):
        assert operations[name].carry_out(joint).reason == WHOLE_OUT_OF_RANGE
    assert operations["motion.step"].carry_out(0, 1.0).reason == WHOLE_OUT_OF_RANGE
    rig.step()
    assert rig.heard() == []


def test_the_registry_holds_every_declaration(rig):
    declared = set()
    for path in (ROOT / "armui").rglob("*.py"):
        text = path.read_text(encoding="utf-8")
        declared |= set(re.findall(r'@(?:operation|declare)\(\s*"([a-z_.]+)"', text))
    assert set(rig.controller.operations) == declared
    assert len(declared) >= 36


def test_each_has_words_in_both_languages(rig, committed):  # noqa: F811 - the fixture
    chinese = {
        entry.source: text for entry, text in committed.items() if entry.context == "Operation"
    }
    titles = {bound.operation.title for bound in rig.controller.operations.values()}
    assert titles == set(chinese)


def test_each_says_in_any_state_whether_it_may_be_done(rig):
    states = list(operating_states())
    assert len(states) > 100
    silent, never = set(), set()
    for name in rig.controller.operations:
        reasons = set()
        for now in states:
            for arguments in ARGUMENTS.get(name, ({},)):
                reason = rig.controller.operations[name].operation.why_not(now, **arguments)
                if reason is not None:
                    assert words.refusal(reason), (name, reason)
                reasons.add(None if reason is None else reason.code)
        if reasons == {None}:
            silent.add(name)
        if None not in reasons:
            never.add(name)
    assert (silent, never) == ({"motion.set_speed"}, set()), "slowing down is never refused"


def test_what_moves_the_arm_is_refused_without_one(rig):
    for name, bound in rig.controller.operations.items():
        if not bound.operation.moves:
            continue
        for arguments in ARGUMENTS.get(name, ({},)):
            reason = bound.operation.why_not(OperatingState(), **arguments)
            assert isinstance(reason, Refusal), name


@pytest.mark.parametrize(
    ("name", "arguments"),
    [
        ("motors.enable", ()),
        ("motors.disable", ()),
        ("motors.resume", ()),
        ("joints.clear_error", (1,)),
        ("joints.set_zero", (1,)),
        ("lamps.set", (1, 0, 1, 2, 3)),
        ("gripper.move", (10.0, 1.0)),
        ("gripper.disable", ()),
        ("end_load.set", (EndLoad.FULL,)),
        ("teaching.command", (TeachingState.START_RECORDING,)),
        ("planned.command", (TrajectoryCommand.ABORT,)),
        ("motion.send", ((0.0,) * 6,)),
        ("motion.home", ()),
        ("run.pause", ()),
        ("settings.reset_joint_limits", ()),
    ],
)
def test_what_is_refused_is_refused_by_the_reason_of_its_declaration(rig, name, arguments):
    bound = rig.controller.operations[name]
    given = {"command": arguments[0]} if name in ARGUMENTS else {}
    reason = bound.operation.why_not(rig.controller.operating_state, **given)
    assert reason is not None
    assert bound.carry_out(*arguments) == reason


def test_an_operation_is_declared_once():
    class Twice:
        @declare("a.b", "A", lambda _now: None)
        def first(self) -> None: ...

        @declare("a.b", "B", lambda _now: None, consent=Consent.HELD)
        def second(self) -> None: ...

    assert operation_of(Twice.first).consent is Consent.NONE
    assert operation_of(Twice.second).consent is Consent.HELD
    with pytest.raises(ValueError, match=r"a\.b is declared twice"):
        Operations([Twice()])


def test_what_each_takes_resolves_at_run_time(rig):
    begun = set()
    for name, bound in rig.controller.operations.items():
        hints = get_type_hints(bound.carry_out)
        taken = set(inspect.signature(bound.carry_out).parameters)
        assert set(hints) == taken | {"return"}, name
        begun |= {name} if hints.get("started") is Started else set()
    assert set(rig.controller.operations) - begun == OTHERWISE


TOO_FAR, LATE = Reason("too_far", "Too far."), Reason("late", "Too late.")


class Part:
    """A part that keeps what its method is given."""

    def __init__(self, refusal=None):
        self.calls: list[object] = []
        self.names: list[str] = []
        self.refusal = refusal
        self.authority = Authority()
        self._context: Any = self

    def begun(self, name):
        self.names.append(name)

    def refresh(self):
        self.calls.append("refreshed")
        return OperatingState()

    def refuse(self, refusal, *, sends=True):
        self.calls.append(refusal)
        return refusal

    def end_last(self):
        self.calls.append("ended")

    @operation("part.act", "Act", lambda _now, far: TOO_FAR() if far > 9 else None, first=end_last)
    def act(self, started: Started, far: int, *, fast: bool = False) -> Refusal | None:
        self.started = started
        self.calls.append((far, fast))
        return self.refusal

    @operation("part.default", "Default", lambda _now, far=10: TOO_FAR() if far > 9 else None)
    def default(self, started: Started, far: int = 1) -> None:
        self.calls.append(far)


def test_the_method_gets_its_record_and_the_caller_too():
    part = Part()
    started = part.act(9, fast=True)
    assert part.calls == ["ended", "refreshed", (9, True)]
    assert len(part.names) == 1, "whoever watches operations is told that it has begun"
    assert started is part.started
    assert (started.operation, started.ending) == ("part.act", None)


def test_the_reason_is_asked_again_where_something_ends_by_the_beginning():
    class Ends(Part):
        def begun(self, name):
            self.authority.end_command(End.CANCELLED)

    part = Ends()
    part.act(9)
    assert part.calls == ["ended", "refreshed", "refreshed", (9, False)]


def test_a_reason_of_the_arguments_is_asked_and_told_once_and_nothing_is_done():
    part = Part()
    assert part.act(10) == TOO_FAR() == part.act(far=11)
    assert part.calls == 2 * ["ended", "refreshed", TOO_FAR()]


def test_what_the_method_refuses_late_is_told_once_and_its_record_closed():
    part = Part(LATE())
    assert part.act(1) == LATE()
    assert part.calls == ["ended", "refreshed", (1, False), LATE()]
    assert part.started.ending is Ending.REFUSED


def test_the_default_of_the_method_is_what_is_asked_about():
    part = Part()
    assert isinstance(part.default(), Started)
    assert part.calls == ["refreshed", 1]


def test_a_reason_that_asks_for_what_no_caller_gives_is_found_at_its_declaration():
    with pytest.raises(TypeError, match=r"part\.lost: the reason asks for \['far'\]"):

        @operation("part.lost", "Lost", lambda _now, far: None)
        def lost(self: Part, started: Started) -> None: ...
