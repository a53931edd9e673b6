"""Every operation of the registry is asked every promise that can be asked of any.

An operation without an entry in `operations_table.py` fails here, and so does an entry without an
operation. What is not asked, and why, stands in `operation_questions.py`. What counts is what left
for the bus, and where the simulated arm is.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Final

import pytest
from PySide6.QtWidgets import QApplication

from armui.arm.refusal import Refusal
from armui.control.operating_state import StopState
from armui.control.safety.other_command import OTHER_HOST
from armui.protocol.codes import TeachingState
from armui.ui import words
from armui.ui.translation import Translator
from tests.accepted import accepted
from tests.cell.areas import wall
from tests.safety.arm_oracle import depth_beyond_mm
from tests.safety.operation_driver import DRIVERS, Answer, Driver, Midway, Sent
from tests.safety.operation_places import (
    BETWEEN_DEG,
    CRATE,
    FIRST_DEG,
    INTO,
    LAST_DEG,
    NEAR_WALL_MM,
    OUTSIDE,
    TWENTY,
    Outside,
    box_at,
    keep_out,
    small_step,
)
from tests.safety.operation_questions import KNOWN, NOT_ASKED, Question, asked, excused
from tests.safety.operations_table import (
    BENT_DEG,
    DRIVE,
    ENTRIES,
    FREE,
    SPEED_PERCENT,
    STAND,
    Way,
    motion_paused,
    motion_under_way,
)

NewDriver = Callable[[], Driver]

pytestmark = pytest.mark.timeout(300)  # of a busy computer

LATE_S: Final = 1.0
"""What has not begun by then never begins; until then what was accepted may still be checked."""
REST_S: Final = 1.0
"""An arm whose motion was ended is at rest by then."""
_AT_ONCE: Final = 0.0
_AT_WORK_S: Final = 0.3
_LOOK_S: Final = 0.08
_BACK_WITHIN_S: Final = 3.5


@pytest.fixture(params=list(DRIVERS))
def new_driver(
    request: pytest.FixtureRequest, qapp: QApplication, spoken: Callable[[Iterable[Refusal]], None]
) -> Iterator[NewDriver]:
    """Makes drivers; whatever was refused at any of them reads as words in both languages."""
    made: list[Driver] = []

    def make() -> Driver:
        made.append(DRIVERS[request.param](f"{request.node.nodeid} {len(made)}"))
        return made[-1]

    yield make
    for each in made:
        each.free()
        each.close()
    spoken(reason for each in made for reason in each.refusals)


@pytest.fixture(scope="module")
def spoken(qapp: QApplication) -> Iterator[Callable[[Iterable[Refusal]], None]]:
    """Holds reasons against both languages; each sentence once, with the figures it came with."""
    translator = Translator(qapp)
    known: set[str] = set()

    def check(reasons: Iterable[Refusal]) -> None:
        new = {str(each.reason): each for each in reasons if str(each.reason) not in known}
        for reason in new.values():
            text = words.refusal(reason)
            assert text.endswith("."), text
            assert not {"{", "}"} & set(text), text
            assert not _has_chinese(text), text
            assert "Not possible now" not in text, text
        if new:
            translator.set_language("zh")
            try:
                for reason in new.values():
                    text = words.refusal(reason)
                    assert _has_chinese(text), text
                    assert not {"{", "}"} & set(text), text
            finally:
                translator.set_language("en")
        known.update(new)

    yield check
    translator.set_language("en")


def _has_chinese(text: str) -> bool:
    return any("\u4e00" <= character <= "\u9fff" for character in text)


# What every question begins with -----------------------------------------------------------------


def ready(new_driver: NewDriver, name: str, way: Way = FREE) -> Driver:
    """An arm in the state that an operation begins in."""
    driver = standing(new_driver, way)
    assert ENTRIES[name].before(driver, way) is None
    return driver


def standing(new_driver: NewDriver, way: Way = FREE) -> Driver:
    """An arm that stands ready at the beginning of a way."""
    driver = new_driver()
    driver.connect(way.start_deg)
    accepted(driver.begin("motion.set_speed", SPEED_PERCENT))
    driver.run(0.1)
    return driver


def settle(driver: Driver, name: str, answer: Answer) -> None:
    """Let the time pass in which an operation's first frame may leave."""
    if isinstance(answer, Refusal):
        driver.run(0.1)
    else:
        driver.run(LATE_S + 0.2 if name in DRIVE else 0.3)


def motion(frames: Iterable[Sent]) -> list[str]:
    """The motion frames among some, as text."""
    return [str(each) for each in frames if each.is_motion]


def driving(frames: Iterable[Sent]) -> list[str]:
    """Those that may move an arm whose motion has ended, as text."""
    return [str(each) for each in frames if each.drives]


def stop_is_heard(driver: Driver) -> None:
    """The press itself has sent it, and the arm stops."""
    before = len(driver.frames)
    driver.stop()
    now = driver.frames[before:]
    stops = [each for each in now if each.is_stop]
    assert [each.frame.arbitration_id for each in stops] == [0x150, 0x160, 0x170]
    assert now[-3:] == stops, "something has left behind it"
    driver.run(0.1)
    assert driver.arm.condition.stopped


def halt_is_heard(driver: Driver) -> None:
    """The press itself has sent it, and what is behind it moves nothing."""
    before = len(driver.frames)
    assert driver.halt() is None
    now = driver.frames[before:]
    halts = [place for place, each in enumerate(now) if each.is_halt]
    assert halts
    assert driving(now[halts[0] :]) == []


def resume_and_enable(driver: Driver) -> None:
    """As an operator does after a stop."""
    accepted(driver.begin("motors.resume"))
    driver.run_until(lambda: driver.now.stop is StopState.RUNNING and driver.now.busy is None)
    accepted(driver.begin("motors.enable"))


def rests(driver: Driver) -> bool:
    """Whether no joint that has power turns."""
    if not all(driver.arm.enabled):
        return True
    before = driver.arm.joints_deg
    driver.run(0.2)
    return max(abs(a - b) for a, b in zip(before, driver.arm.joints_deg, strict=True)) < 0.02


def watched(
    driver: Driver, answer: Answer, excess: Callable[[Sequence[float]], float], seconds: float
) -> float:
    """Let time pass after an operation's answer; return the most that the arm was too far out."""
    most = excess(driver.arm.joints_deg)
    looks = 2 if isinstance(answer, Refusal) else round(seconds / _LOOK_S)
    for _ in range(looks):
        driver.run(_LOOK_S)
        most = max(most, excess(driver.arm.joints_deg))
    return most


# The tables ---------------------------------------------------------------------------------------


def test_every_operation_has_one_entry(new_driver: NewDriver) -> None:
    assert set(new_driver().operations) == set(ENTRIES)


def test_what_is_not_asked_and_what_is_known_is_of_operations_and_asked() -> None:
    for question in NOT_ASKED:
        assert set(excused(question)) <= set(ENTRIES), question
        assert set(excused(question)) != set(ENTRIES), question
    for question, name in KNOWN:
        assert name in ENTRIES
        assert name not in excused(question), (question, name)


@asked(Question.FRAMES)
def test_it_sends_what_it_is_said_to_send(new_driver: NewDriver, name: str) -> None:
    entry, driver = ENTRIES[name], ready(new_driver, name)
    before = len(driver.frames)
    answer = entry.begin(driver, name, FREE)
    assert not isinstance(answer, Refusal), str(answer)
    settle(driver, name, answer)
    sent = {each.identifier for each in driver.frames[before:] if each.is_motion}
    assert entry.frames <= sent <= entry.frames | ({0x151} if entry.frames else set())
    assert driver.failures == []


@asked(Question.MOVES)
def test_what_sends_a_motion_frame_is_declared_to_move(new_driver: NewDriver, name: str) -> None:
    assert new_driver().operations[name].moves is bool(ENTRIES[name].frames)


HELD_BACK: Final = {
    "motion.set_speed": (motion_paused, motion_under_way),
}
"""For what is not declared to move: a motion that is held back, and one that is under way."""


@pytest.mark.parametrize("name", excused(Question.MOVES))
def test_s11_a_speed_sets_nothing_going_and_slows_what_goes(
    new_driver: NewDriver, name: str
) -> None:
    held_back, under_way = HELD_BACK[name]
    driver = standing(new_driver)
    assert held_back(driver, FREE) is None
    before = len(driver.frames)
    for percent in (20, 80):
        accepted(driver.begin(name, percent))
        driver.run(LATE_S)
        assert rests(driver)
    assert motion(driver.frames[before:]) == []
    driver = standing(new_driver)
    assert under_way(driver, FREE) is None
    assert not rests(driver)
    before = len(driver.frames)
    accepted(driver.begin(name, 10))
    driver.run(0.3)
    told = [each.percent for each in driver.frames[before:] if each.percent is not None]
    assert told
    assert max(told) <= 10


# S1, S2, S10, S26: the stop and the halt ----------------------------------------------------------


@asked(Question.STOP)
def test_s01_s10_the_stop_is_heard_while_it_works_and_it_is_not_revived(
    new_driver: NewDriver, name: str
) -> None:
    for after_s in (_AT_ONCE,) if name in STAND else (_AT_ONCE, _AT_WORK_S):
        driver = ready(new_driver, name)
        ENTRIES[name].begin(driver, name, FREE)
        driver.run(after_s)
        stop_is_heard(driver)
        before = len(driver.frames)
        driver.run(LATE_S if name in DRIVE else 0.2)
        assert motion(driver.frames[before:]) == []
        resume_and_enable(driver)
        driver.run(0.5)
        assert driving(driver.frames[before:]) == []
        assert rests(driver)


@asked(Question.HALT)
def test_s10_s26_the_halt_is_heard_while_it_works_and_it_is_not_revived(
    new_driver: NewDriver, name: str
) -> None:
    for after_s in (_AT_ONCE, _AT_WORK_S):
        driver = ready(new_driver, name)
        ENTRIES[name].begin(driver, name, FREE)
        driver.run(after_s)
        halt_is_heard(driver)
        before = len(driver.frames)
        driver.run(REST_S)
        assert rests(driver)
        assert driving(driver.frames[before:]) == []


# S9, S13, S14: when nothing may leave -------------------------------------------------------------

STATUS, SOME_ANGLES = 0x2A1, 0x2A6


@asked(Question.UNHEARD)
def test_s09_no_motion_frame_while_the_arm_is_not_heard(new_driver: NewDriver, name: str) -> None:
    one_by_one = ((STATUS,), (SOME_ANGLES,))
    for silent in ((STATUS, SOME_ANGLES),) if name in STAND else one_by_one:
        driver = ready(new_driver, name)
        driver.silence(*silent)
        driver.run(0.6)
        before = len(driver.frames)
        answer = ENTRIES[name].begin(driver, name, FREE)
        settle(driver, name, answer)
        assert motion(driver.frames[before:]) == []
        if driver.operations[name].moves:
            assert isinstance(answer, Refusal)


GOES_ON: Final = frozenset({"planned.command", "run.go_on", "replay.go_on"})
"""What goes on with something that another host's word ends."""
ENDED_BY_THE_OTHER: Final = {
    "planned.command": "the motion held back is the other host's to go on with",
    "teaching.command": "the other host's mode word has ended drag teaching",
}
"""What is refused for another reason, which the other host has caused."""


@asked(Question.OTHER_HOST)
def test_s13_no_motion_frame_beside_another_hosts(new_driver: NewDriver, name: str) -> None:
    driver = ready(new_driver, name)
    told = len(driver.refusals)
    driver.other_says("151#0101320000000000")
    driver.run(0.1)
    before = len(driver.frames)
    answer = ENTRIES[name].begin(driver, name, FREE)
    settle(driver, name, answer)
    assert motion(driver.frames[before:]) == []
    if driver.operations[name].moves:
        assert isinstance(answer, Refusal)
        reasons = {each.reason for each in driver.refusals[told:]}
        assert OTHER_HOST in reasons or name in ENDED_BY_THE_OTHER


def _may_be_late(sent: Sent) -> bool:
    """A question, the end of a motion, and the operator's speed that is told again at rest."""
    return sent.identifier in {0x472, 0x477, 0x4AF, 0x151} or sent.is_halt


@asked(Question.LATE)
def test_s14_its_first_frame_leaves_within_a_second_or_not_at_all(
    new_driver: NewDriver, name: str
) -> None:
    driver = ready(new_driver, name)
    driver.hold_up()
    accepted(driver.begin("lamps.set", 1, 1, 0, 0, 0))  # the driver keeps this one
    driver.run(0.04)
    before = len(driver.frames)
    ENTRIES[name].begin(driver, name, FREE)
    driver.run(LATE_S + 0.1)
    driver.free()
    driver.run(0.5)
    kept, *late = driver.frames[before:]
    assert kept.identifier == 0x121
    assert driving(late) == []
    assert [str(each) for each in late if not _may_be_late(each)] == []
    assert rests(driver)


# S12 ----------------------------------------------------------------------------------------------


@asked(Question.SPEED)
def test_s12_never_faster_than_shown(new_driver: NewDriver, name: str) -> None:
    entry = ENTRIES[name]
    shown = SPEED_PERCENT if entry.percent is None else entry.percent
    for left_at in (None,) if name in GOES_ON else (None, 100):
        driver = ready(new_driver, name)
        in_force = [each.percent for each in driver.frames if each.percent is not None][-1]
        if left_at is not None:
            in_force = left_at
            driver.other_says(f"151#0101{left_at:02X}0000000000")
            driver.run(2.3)
        before = len(driver.frames)
        entry.begin(driver, name, FREE)
        driver.run(LATE_S + 0.2)
        sent = [each for each in driver.frames[before:] if each.is_motion]
        assert sent
        for each in sent:
            if each.percent is not None:
                in_force = each.percent
                assert in_force <= shown or not each.moving, str(each)
            elif each.is_target:
                assert in_force <= max(shown, SPEED_PERCENT), f"{each} at {in_force} %"


# S23 ----------------------------------------------------------------------------------------------


@asked(Question.EXCEPTION)
def test_s23_an_exception_in_its_way_ends_every_motion_and_leaves_the_stop_alone(
    new_driver: NewDriver, name: str
) -> None:
    driver = ready(new_driver, name)
    way = Midway(driver.module_of(name))
    with driver.failing(way):
        ENTRIES[name].begin(driver, name, FREE)
    driver.close()
    middle, end = 0.5, 1.0
    for share in (middle,) if name in STAND else (middle, end):
        driver = ready(new_driver, name)
        with driver.failing(way.at(share)):
            ENTRIES[name].begin(driver, name, FREE)
        assert driver.failures
        before = len(driver.frames)
        driver.run(REST_S if name in DRIVE else 0.3)
        assert driving(driver.frames[before:]) == []
        assert rests(driver)
        stop_is_heard(driver)


# S2 -----------------------------------------------------------------------------------------------


@asked(Question.THREAD)
def test_s02_it_does_not_hold_the_windows_thread_in_a_full_cell(
    new_driver: NewDriver, name: str
) -> None:
    driver = standing(new_driver)
    keep_out(driver, *TWENTY)
    driver.check_in_threads()
    driver.begin("motion.step", 6, 1.0)  # loads what a first motion needs
    driver.run(LATE_S)
    assert ENTRIES[name].before(driver, FREE) is None
    began_s = time.thread_time()
    ENTRIES[name].begin(driver, name, FREE)
    held_ms = 1e3 * (time.thread_time() - began_s)
    assert held_ms < 20.0


# S32 ----------------------------------------------------------------------------------------------


@asked(Question.ZONE)
def test_s32_it_leads_into_no_zone(new_driver: NewDriver, name: str) -> None:
    entry, driver = ENTRIES[name], standing(new_driver, INTO)
    assert entry.tip_mm is not None
    box = box_at(entry.tip_mm(INTO))
    assert box.depth_mm(INTO.start_deg) < -15.0
    keep_out(driver, box.zone)
    hand_mm = box.depth_mm(driver.arm.joints_deg)
    if entry.before(driver, INTO) is None:
        answer = entry.begin(driver, name, INTO)
        hand_mm = watched(driver, answer, box.depth_mm, 3.0)
    assert hand_mm <= 0.0, f"{hand_mm:.0f} mm inside"


@asked(Question.SMALL)
def test_s32_nor_by_small_steps(new_driver: NewDriver, name: str) -> None:
    entry, driver = ENTRIES[name], standing(new_driver)
    keep_out(driver, wall(NEAR_WALL_MM))
    most_mm = -1e9
    for _ in range(60):
        answer = entry.begin(driver, name, small_step(driver.arm.joints_deg))
        driver.run(0.12)
        driver.let_go()
        most_mm = max(most_mm, depth_beyond_mm(driver.arm.joints_deg, NEAR_WALL_MM))
        if isinstance(answer, Refusal):
            break
    assert most_mm <= 0.0, f"{most_mm:.0f} mm inside"


@asked(Question.SECOND)
def test_s32_nor_while_another_motion_is_under_way(new_driver: NewDriver, name: str) -> None:
    driver = standing(new_driver, Way(FIRST_DEG, LAST_DEG))
    keep_out(driver, CRATE.zone)
    accepted(driver.begin("motion.send", BETWEEN_DEG))
    driver.run(0.2)
    answer = ENTRIES[name].begin(driver, name, Way(LAST_DEG, LAST_DEG))
    most_mm = watched(driver, answer, CRATE.depth_mm, 3.0)
    assert most_mm <= 0.0, f"{most_mm:.0f} mm inside"


# S36 ----------------------------------------------------------------------------------------------


def goes_no_further(new_driver: NewDriver, name: str, place: Outside) -> None:
    """Neither does the arm, nor does a target that leaves name such a place."""
    driver = standing(new_driver, place.out)
    place.prepare(driver)
    begins = place.excess(place.out.start_deg)
    assert begins > 0.0
    before, most = len(driver.frames), begins
    if ENTRIES[name].before(driver, place.out) is None:
        answer = ENTRIES[name].begin(driver, name, place.out)
        most = watched(driver, answer, place.excess, 2.0)
    assert most <= begins + place.noise, f"from {begins:.1f} to {most:.1f} outside"
    for target_deg in targets(driver.frames[before:]):
        asked_for = place.excess(target_deg)
        assert asked_for <= begins + place.noise, f"from {begins:.1f}, told {asked_for:.1f}"


def targets(frames: Iterable[Sent]) -> Iterator[tuple[float, ...]]:
    """The joint angles that were sent as targets."""
    found: dict[int, tuple[float, float]] = {}
    for each in frames:
        if 0x155 <= each.identifier <= 0x157:
            first, second = (
                int.from_bytes(each.frame.data[place : place + 4], "big", signed=True) / 1000
                for place in (0, 4)
            )
            found[each.identifier] = first, second
            if each.identifier == 0x157 and len(found) == 3:
                yield (*found[0x155], *found[0x156], *found[0x157])


@asked(Question.LIMIT)
def test_s36_nothing_leads_further_beyond_a_limit(new_driver: NewDriver, name: str) -> None:
    goes_no_further(new_driver, name, OUTSIDE["limit"])


@asked(Question.REST)
def test_s36_nor_out_of_the_rest_pose(new_driver: NewDriver, name: str) -> None:
    goes_no_further(new_driver, name, OUTSIDE["rest"])


@asked(Question.AREA)
def test_s36_nor_deeper_into_a_work_area(new_driver: NewDriver, name: str) -> None:
    goes_no_further(new_driver, name, OUTSIDE["area"])


@asked(Question.FLOOR)
def test_s36_nor_further_below_the_floor(new_driver: NewDriver, name: str) -> None:
    goes_no_further(new_driver, name, OUTSIDE["floor"])


def comes_back(new_driver: NewDriver, name: str, place: Outside) -> None:
    """The arm comes inside, and is never further out on its way."""
    driver = standing(new_driver, place.back)
    place.prepare(driver)
    begins = place.excess(place.back.start_deg)
    answer = ENTRIES[name].begin(driver, name, place.back)
    assert not isinstance(answer, Refusal), str(answer)
    most = begins
    for _ in range(round(_BACK_WITHIN_S / _LOOK_S)):
        driver.run(_LOOK_S)
        now = place.excess(driver.arm.joints_deg)
        most = max(most, now)
        if now <= 0.0:
            break
    assert most <= begins + place.noise
    assert place.excess(driver.arm.joints_deg) <= place.noise


@asked(Question.BACK_LIMIT)
def test_s36_back_within_a_limit_it_may_go(new_driver: NewDriver, name: str) -> None:
    comes_back(new_driver, name, OUTSIDE["limit"])


@asked(Question.BACK_REST)
def test_s36_and_out_of_the_rest_pose(new_driver: NewDriver, name: str) -> None:
    comes_back(new_driver, name, OUTSIDE["rest"])


@asked(Question.BACK_AREA)
def test_s36_and_out_of_a_work_area(new_driver: NewDriver, name: str) -> None:
    comes_back(new_driver, name, OUTSIDE["area"])


@asked(Question.BACK_FLOOR)
def test_s36_and_up_from_below_the_floor(new_driver: NewDriver, name: str) -> None:
    comes_back(new_driver, name, OUTSIDE["floor"])


# The reason, in words -----------------------------------------------------------------------------


UNTOLD: Final = frozenset({"settings.read"})
"""What is refused without a word in the window: where the values stand, the page says so."""


def test_without_an_arm_every_reason_reads_as_words(new_driver: NewDriver) -> None:
    driver = new_driver()
    refused, untold = set(), set()
    for name, entry in ENTRIES.items():
        told = len(driver.refusals)
        if isinstance(entry.begin(driver, name, FREE), Refusal):
            refused.add(name)
            if len(driver.refusals) == told:
                untold.add(name)
    assert refused >= {name for name in DRIVE if driver.operations[name].moves}
    assert untold == UNTOLD
    assert driver.frames == []


# What is in no registry: the stop, the halt, the way out of another host's mode -------------------


def unheard(driver: Driver) -> None:
    driver.silence(0x2A1, 0x2A5, 0x2A6, 0x2A7)
    driver.run(0.6)


def beside_another_host(driver: Driver) -> None:
    driver.other_says("151#0101320000000000")
    driver.run(0.1)


def in_mit(driver: Driver) -> None:
    driver.other_says("151#010600AD00000000")
    driver.run(0.1)


def in_a_zone(driver: Driver) -> None:
    OUTSIDE["area"].prepare(driver)


def led_by_hand(driver: Driver) -> None:
    accepted(driver.begin("teaching.command", TeachingState.START_RECORDING))
    driver.run(0.3)


def during_a_check(driver: Driver) -> None:
    accepted(driver.begin("reference.begin"))


def before_the_cell_is_confirmed(driver: Driver) -> None:
    assert ENTRIES["cell.confirm"].before(driver, FREE) is None


def after_a_failure(driver: Driver) -> None:
    way = Midway(driver.module_of("motion.send"))
    with driver.failing(way):
        driver.begin("motion.send", FREE.end_deg)
    driver.run(REST_S)
    with driver.failing(way.at(0.5)):
        driver.begin("motion.send", FREE.start_deg)
    assert driver.failures


CIRCUMSTANCES: Final = (
    *(unheard, beside_another_host, in_mit, in_a_zone, led_by_hand, during_a_check),
    *(before_the_cell_is_confirmed, after_a_failure),
)


@pytest.mark.parametrize("circumstance", CIRCUMSTANCES, ids=lambda each: each.__name__)
def test_nothing_is_a_reason_against_the_stop(
    new_driver: NewDriver, circumstance: Callable[[Driver], None]
) -> None:
    driver = standing(new_driver)
    circumstance(driver)
    stop_is_heard(driver)


@pytest.mark.parametrize("circumstance", CIRCUMSTANCES, ids=lambda each: each.__name__)
def test_nothing_is_a_reason_against_the_halt(
    new_driver: NewDriver, circumstance: Callable[[Driver], None]
) -> None:
    driver = standing(new_driver)
    circumstance(driver)
    halt_is_heard(driver)


def in_anothers_mode(new_driver: NewDriver) -> Driver:
    """Another host has left the arm in CPV, and its firmware can be led out by a word."""
    driver = new_driver()
    driver.connect(BENT_DEG, version="S-V1.8-8")
    accepted(driver.begin("motion.set_speed", SPEED_PERCENT))
    driver.other_says("151#0105320000000000")
    driver.run(3.0)
    return driver


def test_the_way_out_of_anothers_mode_holds_the_arm_at_the_speed_shown(
    new_driver: NewDriver,
) -> None:
    driver = in_anothers_mode(new_driver)
    before = len(driver.frames)
    assert driver.leave_mode() is None
    driver.run(LATE_S)
    sent = [each for each in driver.frames[before:] if each.is_motion]
    assert {each.identifier for each in sent} == {0x151, 0x155, 0x156, 0x157}
    assert {each.percent for each in sent} == {None, SPEED_PERCENT}
    (held_deg,) = targets(sent)
    assert held_deg == pytest.approx(BENT_DEG, abs=0.5)


@pytest.mark.parametrize("circumstance", [unheard, beside_another_host, in_mit])
def test_the_way_out_of_anothers_mode_is_refused(
    new_driver: NewDriver, circumstance: Callable[[Driver], None]
) -> None:
    driver = in_anothers_mode(new_driver)
    circumstance(driver)
    before = len(driver.frames)
    assert isinstance(driver.leave_mode(), Refusal)
    driver.run(LATE_S + 0.2)
    assert motion(driver.frames[before:]) == []


def test_the_way_out_of_anothers_mode_is_no_late_one(new_driver: NewDriver) -> None:
    driver = in_anothers_mode(new_driver)
    driver.hold_up()
    accepted(driver.begin("lamps.set", 1, 1, 0, 0, 0))
    driver.run(0.04)
    before = len(driver.frames)
    driver.leave_mode()
    driver.run(LATE_S + 0.1)
    driver.free()
    driver.run(0.5)
    assert motion(driver.frames[before:]) == []


@pytest.mark.parametrize("press", ["stop", "halt"])
def test_the_way_out_of_anothers_mode_is_not_revived(new_driver: NewDriver, press: str) -> None:
    driver = in_anothers_mode(new_driver)
    assert driver.leave_mode() is None
    before = len(driver.frames)
    if press == "stop":
        stop_is_heard(driver)
    else:
        assert driver.halt() is None
    driver.run(LATE_S + 0.2)
    assert motion(driver.frames[before:]) == []


def test_an_exception_in_the_way_out_of_anothers_mode_sends_nothing(new_driver: NewDriver) -> None:
    way = Midway("armui.control.safety.mode_exit")
    with (driver := in_anothers_mode(new_driver)).failing(way):
        driver.leave_mode()
    driver = in_anothers_mode(new_driver)
    with driver.failing(way.at(0.5)):
        driver.leave_mode()
    assert driver.failures
    before = len(driver.frames)
    driver.run(LATE_S)
    assert motion(driver.frames[before:]) == []
    stop_is_heard(driver)
