from itertools import combinations, product
from types import SimpleNamespace

import pytest

from tests.conftest import pytest_collection_modifyitems
from tests.pairs import few_of

NAMES = ("generation", "model", "language", "end")


def combined(*counts):
    return [
        dict(zip(NAMES, each, strict=False))
        for each in product(*(range(count) for count in counts))
    ]


def shown(cases, together):
    return {each for case in cases for each in combinations(sorted(case.items()), together)}


@pytest.mark.parametrize("counts", [(2, 4), (4, 2), (2, 2, 6), (2, 4, 3, 9), (3,), (1, 5)])
@pytest.mark.parametrize("together", [1, 2])
def test_what_occurs_together_in_all_does_so_in_the_few(counts, together):
    cases = combined(*counts)
    few = [cases[place] for place in few_of(cases, together)]
    assert shown(few, together) == shown(cases, together)


@pytest.mark.parametrize(("counts", "most"), [((2, 4), 4), ((4, 2), 4), ((2, 9, 3), 9)])
def test_as_few_as_the_longest_list_show_each_value(counts, most):
    assert len(few_of(combined(*counts), 1)) == most


@pytest.mark.parametrize(("counts", "most"), [((2, 6, 9), 54), ((2, 4, 4), 16), ((2, 2, 2), 4)])
def test_as_few_as_the_two_longest_lists_show_each_pair(counts, most):
    assert len(few_of(combined(*counts), 2)) <= most * 1.2


def test_the_shorter_list_takes_turns():
    cases = combined(2, 8)
    turns = [cases[place]["generation"] for place in few_of(cases, 1)]
    assert sorted(turns) == [0] * 4 + [1] * 4


def test_of_what_are_not_all_combinations_only_some_that_are_there_are_taken():
    cases = [case for case in combined(4, 4) if case["generation"] != case["model"]]
    few = [cases[place] for place in few_of(cases, 1)]
    assert all(case["generation"] != case["model"] for case in few)
    assert shown(few, 1) == shown(cases, 1)


def test_without_a_choice_all_are_taken():
    assert few_of([], 1) == []
    assert few_of([{}], 1) == [0]
    assert few_of(combined(3), 2) == [0, 1, 2]
    assert few_of(combined(3, 5), 2) == list(range(15))


def test_it_is_always_the_same():
    assert few_of(combined(2, 4, 3), 2) == few_of(combined(2, 4, 3), 2)


class Item:
    """A test of one generation and one of many ends."""

    def __init__(self, name, generation, end, *marks):
        self.nodeid = f"{name}[{generation}-{end}]"
        self.callspec = SimpleNamespace(params={"generation": generation, "end": end})
        self.get_closest_marker = {mark: mark for mark in marks}.get


def run(full):
    ends = ([1], [2], [3], [4])
    thinned = [Item("thinned", one, end, "each_value") for one in (1, 2) for end in ends]
    whole = [Item("whole", one, end) for one in (1, 2) for end in ends]
    items, left = [*thinned, *whole], []

    def deselected(items):
        left.extend(items)

    hook = SimpleNamespace(pytest_deselected=deselected)
    pytest_collection_modifyitems(SimpleNamespace(getoption=lambda _: full, hook=hook), items)
    assert len(items) + len(left) == 16
    assert set(whole) <= set(items)
    return [(each.callspec.params["generation"], *each.callspec.params["end"]) for each in left]


def test_only_what_is_marked_is_thinned():
    left = run(full=False)
    assert sorted(end for _, end in left) == [1, 2, 3, 4]
    assert {generation for generation, _ in left} == {1, 2}


def test_the_option_leaves_nothing_out():
    assert run(full=True) == []
