"""Every promise that is asked of every operation is asked once more through a client (S29, S30)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, Final

import pytest
from PySide6.QtWidgets import QApplication

from armui.interface.plain_forms import WITHOUT
from tests.safety import test_every_operation as every
from tests.safety.client_driver import BY_OTHER_MEANS, ClientDriver
from tests.safety.operation_questions import KNOWN, Question, excused
from tests.safety.operations_table import ENTRIES

pytestmark = pytest.mark.timeout(300)  # of a busy computer

ASKED: Final[dict[Question, Callable[..., None]]] = {
    Question.FRAMES: every.test_it_sends_what_it_is_said_to_send,
    Question.STOP: every.test_s01_s10_the_stop_is_heard_while_it_works_and_it_is_not_revived,
    Question.HALT: every.test_s10_s26_the_halt_is_heard_while_it_works_and_it_is_not_revived,
    Question.UNHEARD: every.test_s09_no_motion_frame_while_the_arm_is_not_heard,
    Question.SPEED: every.test_s12_never_faster_than_shown,
    Question.OTHER_HOST: every.test_s13_no_motion_frame_beside_another_hosts,
    Question.LATE: every.test_s14_its_first_frame_leaves_within_a_second_or_not_at_all,
    Question.EXCEPTION: (
        every.test_s23_an_exception_in_its_way_ends_every_motion_and_leaves_the_stop_alone
    ),
    Question.ZONE: every.test_s32_it_leads_into_no_zone,
    Question.SMALL: every.test_s32_nor_by_small_steps,
    Question.SECOND: every.test_s32_nor_while_another_motion_is_under_way,
    Question.LIMIT: every.test_s36_nothing_leads_further_beyond_a_limit,
    Question.REST: every.test_s36_nor_out_of_the_rest_pose,
    Question.AREA: every.test_s36_nor_deeper_into_a_work_area,
    Question.FLOOR: every.test_s36_nor_further_below_the_floor,
    Question.BACK_LIMIT: every.test_s36_back_within_a_limit_it_may_go,
    Question.BACK_REST: every.test_s36_and_out_of_the_rest_pose,
    Question.BACK_AREA: every.test_s36_and_out_of_a_work_area,
    Question.BACK_FLOOR: every.test_s36_and_up_from_below_the_floor,
}
CASES: Final = [
    pytest.param(question, name, id=f"{question.name.lower()}-{name}")
    for question in ASKED
    for name in ENTRIES
    if name not in WITHOUT.keys() - BY_OTHER_MEANS
    and name not in excused(question)
    and (question, name) not in KNOWN
]


@pytest.fixture
def new_driver(request: pytest.FixtureRequest, qapp: QApplication) -> Iterator[Callable[[], Any]]:
    """Makes drivers that are clients."""
    made: list[ClientDriver] = []

    def make() -> ClientDriver:
        made.append(ClientDriver(f"{request.node.nodeid} {len(made)}"))
        return made[-1]

    yield make
    for each in made:
        each.free()
        each.close()


@pytest.mark.each_value(full="each question of each operation")
@pytest.mark.parametrize(("question", "name"), CASES)
def test_by_a_client(new_driver: Callable[[], Any], question: Question, name: str) -> None:
    ASKED[question](new_driver, name)


def test_every_question_of_the_registry_is_asked() -> None:
    """All but those about declarations, which are the same, and the time in the window's thread."""
    assert set(Question) - set(ASKED) == {Question.MOVES, Question.THREAD}
