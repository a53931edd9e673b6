"""What the command palette finds: by Chinese, English, pinyin, initials and mixtures."""

import pytest

from armui.ui.actions.names import Names
from armui.ui.actions.search import rank

NAMES = Names(
    [
        ("运动控制", "Motion control", "yun dong kong zhi"),
        ("回零", "Home", "hui ling"),
        ("目标", "Target of", "mu biao"),
        ("使能", "Enable", "shi neng"),
        ("归零", "", "gui ling"),
        ("仿真", "", "fang zhen"),
    ]
)


def how_well(query: str, title: str, place: str = "") -> tuple[int, ...]:
    ranked = rank(query, NAMES.search_text([title], place))
    assert ranked is not None
    return ranked


def found(query: str, title: str, place: str = "") -> bool:
    return rank(query, NAMES.search_text([title], place)) is not None


@pytest.mark.parametrize("shown", ["运动控制", "Motion control"])
@pytest.mark.parametrize(
    "query",
    [
        *("ydkz", "yundongkongzhi", "yundkz", "ydkongzhi", "kz", "kongz", "运动", "控制"),
        *("motion", "control", "MOTION CON", "mot 控制"),
    ],
)
def test_a_name_is_found_in_either_language(shown, query):
    assert found(query, shown)


@pytest.mark.parametrize("query", ["yxkz", "ydzk", "yunkz", "motor", "灯", "y d x"])
def test_what_it_is_not_called_does_not_find_it(query):
    assert not found(query, "运动控制")


@pytest.mark.parametrize("query", ["hl", "home", "hl yundong", "motion home", "运动 回零"])
def test_the_place_may_be_named_with_it(query):
    assert found(query, "回零", "运动控制")


@pytest.mark.parametrize("query", ["mbj3", "target of j3", "目标 j3", "mubiao j3"])
def test_what_follows_a_name_is_found(query):
    assert found(query, "目标 J3")
    assert not found(query, "目标 J4")


def test_what_is_called_so_comes_before_what_is_done_there():
    assert how_well("ydkz", "运动控制") < how_well("ydkz", "回零", "运动控制")


def test_several_words_are_first_of_all_the_beginning_of_a_name():
    connect = rank("simulated fa", NAMES.search_text(["Connect"], "", ("simulated", "仿真")))
    assert connect is not None
    assert how_well("simulated fa", "Simulated faults") < connect


def test_initials_come_before_a_part_within():
    assert how_well("sn", "使能") < how_well("sn", "snap")


def test_nothing_asked_finds_everything():
    assert found("", "回零")
    assert found("   ", "回零")


@pytest.mark.parametrize("query", ["guiling", "gl", "gling", "归零", "origin", "guil"])
def test_synonyms_are_found_by_pinyin_too(query):
    text = NAMES.search_text(["Home"], "", ("zero", "origin", "归零"))
    found_so = rank(query, text)
    assert found_so is not None
    assert rank(query, NAMES.search_text(["Home"], "")) is None
    assert how_well("home", "Home") < found_so


def test_a_synonym_has_no_other_name():
    assert NAMES.search_text(["归零"], "").names == ("归零",)
