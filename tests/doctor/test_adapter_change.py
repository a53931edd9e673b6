"""The adapter's helper as the window starts it: planned, told to go, refused, closed, hung."""

import queue
import sys

import pytest

from armui.doctor import adapter_change
from armui.doctor.adapter_change import AdapterChange, Answer, Done, Planned, are_owned
from tests.packages.adapter_system import AdapterSystem

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="the helper is for Linux")

WITHIN_S = 50.0


@pytest.fixture
def system(tmp_path):
    system = AdapterSystem(tmp_path)
    system.add("can0", serial="AB12")
    return system


class Answers:
    """What a change tells, in the order it is told."""

    def __init__(self):
        self._queue: queue.Queue[Answer] = queue.Queue()

    def __call__(self, answer):
        self._queue.put(answer)

    def next(self):
        return self._queue.get(timeout=WITHIN_S)

    def is_empty(self):
        return self._queue.empty()


def script(tmp_path, text):
    """A program in the place of pkexec."""
    path = tmp_path / "pkexec"
    path.write_text(f"#!{sys.executable} -IS\nimport sys, time\n{text}\n")
    path.chmod(0o755)
    return [str(path)]


def test_it_is_planned_told_to_go_and_done(system):
    answers = Answers()
    change = AdapterChange(["up", "can0", "1000000"], answers, system.command())
    assert answers.next() == Planned()
    assert not system.link("can0")["up"]
    change.go()
    done = answers.next()
    assert isinstance(done, Done)
    assert (done.result["up"], done.result["bitrate"]) == (True, 1_000_000)
    assert change.wait(WITHIN_S)
    assert answers.is_empty()


def test_a_plan_alone_writes_nothing(system):
    answers = Answers()
    change = AdapterChange(["remember", "can0", "arm_left", "1000000"], answers, system.command())
    planned = answers.next()
    assert sorted(path.rsplit("/", 1)[1] for path in planned.files) == [
        "70-armui-arm_left.link",
        "70-armui-arm_left.network",
    ]
    change.end()
    assert change.wait(WITHIN_S)
    assert answers.is_empty()
    assert system.files() == {}


def test_what_the_helper_refuses_has_its_sentence(system):
    answers = Answers()
    AdapterChange(["up", "can9", "1000000"], answers, system.command())
    refusal = answers.next()
    assert (refusal.code, refusal.params["text"]) == ("adapter_no_interface", "can9")


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("sys.exit(126)", "adapter_dismissed"),
        (
            "print('Error: Not authorized', file=sys.stderr); sys.exit(127)",
            "adapter_not_authorised",
        ),
        ("print('{\"plan\": 3}'); print('[]'); sys.exit(0)", "adapter_no_answer"),
        ('print(\'{"refused": {"code": "new", "text": "?"}}\')', "adapter_system"),
        ("sys.exit(1)", "adapter_no_answer"),
    ],
)
def test_polkit_that_refuses_and_a_helper_that_says_nonsense(tmp_path, text, code):
    answers = Answers()
    change = AdapterChange(["up", "can0", "1000000"], answers, script(tmp_path, text))
    assert answers.next().code == code
    assert change.wait(WITHIN_S)
    assert answers.is_empty()


def test_without_pkexec_it_is_said(tmp_path):
    answers = Answers()
    AdapterChange(["up", "can0", "1000000"], answers, [str(tmp_path / "none")])
    assert answers.next().code == "adapter_not_authorised"


def test_one_that_hangs_is_ended(tmp_path):
    answers = Answers()
    change = AdapterChange(["up", "x", "1"], answers, script(tmp_path, "time.sleep(600)"))
    change.end()
    assert change.wait(WITHIN_S)
    assert answers.is_empty()


def test_one_that_hangs_after_it_was_told_to_go_is_given_up(tmp_path, monkeypatch):
    monkeypatch.setattr(adapter_change, "_GO_S", 0.2)
    answers = Answers()
    text = "print('{\"plan\": {}}', flush=True); time.sleep(600)"
    change = AdapterChange(["up", "x", "1"], answers, script(tmp_path, text))
    assert answers.next() == Planned()
    change.go()
    assert answers.next().code == "adapter_tool_hangs"
    assert change.wait(WITHIN_S)


def test_nothing_of_the_user_is_passed_on(tmp_path, monkeypatch):
    for name in ("PYTHONPATH", "LD_LIBRARY_PATH", "LD_PRELOAD", "SHELL", "IFS"):
        monkeypatch.setenv(name, "/nowhere")
    answers = Answers()
    text = (
        "import json, os; told = {'code': 'x', 'text': ' '.join(sorted(os.environ))};"
        " print(json.dumps({'refused': told}))"
    )
    AdapterChange(["x"], answers, script(tmp_path, text))
    names = set(str(answers.next().params["text"]).split())
    assert "PATH" in names
    assert not names & {"PYTHONPATH", "LD_LIBRARY_PATH", "LD_PRELOAD", "SHELL", "IFS"}


def test_a_helper_that_others_can_change_is_none(tmp_path):
    owner = tmp_path.stat().st_uid
    tmp_path.chmod(0o755)
    helper = tmp_path / "armui-adapter"
    assert not are_owned([helper], owner)
    helper.write_text("")
    helper.chmod(0o755)
    assert are_owned([helper], owner)
    assert not are_owned([helper], owner + 1)
    helper.chmod(0o775)
    assert not are_owned([helper], owner)
    helper.chmod(0o755)
    tmp_path.chmod(0o777)
    assert not are_owned([helper], owner)
