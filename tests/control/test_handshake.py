"""What the program asks an arm when it comes online: its generation and its limits."""

from __future__ import annotations

import pytest

from armui.arm.state import ArmState, Reading, Status
from armui.control.link.handshake import Handshake, HandshakePhase
from armui.protocol.addressing import Addressing
from armui.protocol.codec import Codec
from armui.protocol.firmware_version import ArmIdentity, MitLayout, NamedVersion
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from tests.family import FACTORY_LIMITS
from tests.moments import now
from tests.ui.arm_states import heard_six

BEGIN_S = 0.25
STEP_S = 0.015625
VERSION = Frame(0x4AF, bytes.fromhex("01 00 00 00 00 00 00 00"))
NOTHING = ArmState()
ALL_LIMITS = NOTHING._replace(
    limits=heard_six(FACTORY_LIMITS, BEGIN_S),
    accelerations_deg_s2=(Reading(286.5, BEGIN_S),) * 6,
)


def questions(*joints):
    """0x472: the joint, 1 for its limits or 2 for its acceleration."""
    return [
        Frame(0x472, bytes([joint, kind, 0, 0, 0, 0, 0, 0])) for joint in joints for kind in (1, 2)
    ]


class Wire:
    """Stands for the bus thread."""

    def __init__(self) -> None:
        self.sent: list[Frame] = []
        self.codecs: list[Codec] = []
        self.refined: list[Codec] = []
        self.may_send = True

    def send(self, frames) -> bool:
        self.sent.extend(frames)
        return self.may_send

    def use_codec(self, codec, *, forget=True) -> None:
        (self.codecs if forget else self.refined).append(codec)

    def take(self) -> list[Frame]:
        """What was sent since this was asked last."""
        sent, self.sent = self.sent, []
        return sent


class Talk:
    """A handshake and the wire, moment by moment."""

    def __init__(self, addressing: Addressing | None = None) -> None:
        self.wire = Wire()
        self.now_s = BEGIN_S
        self.handshake = Handshake(self.wire, self.now_s, addressing or Addressing())

    def wait(self, seconds: float, state: ArmState = NOTHING) -> None:
        """Advance every 1/64 s."""
        end_s = self.now_s + seconds
        while self.now_s < end_s:
            self.now_s += STEP_S
            self.handshake.follow_arm(state, self.now_s)

    def settle(self) -> None:
        """The arm names its version."""
        self.wait(STEP_S, NOTHING._replace(firmware="S-V1.8-8"))
        self.wire.take()


@pytest.fixture
def talk():
    return Talk()


def test_it_begins_with_nothing_heard_in_the_newer_generation(talk):
    (codec,) = talk.wire.codecs
    assert codec is talk.handshake.codec
    assert codec.generation is Generation.TWO
    assert codec.addressing == Addressing()
    assert talk.wire.sent == []
    assert now(talk.handshake.generation) is None
    assert talk.handshake.firmware is None
    assert talk.handshake.phase is HandshakePhase.GENERATION
    assert not talk.handshake.done


def test_a_version_settles_generation_2(talk):
    talk.wait(STEP_S)
    assert talk.wire.take() == [VERSION]
    talk.wait(STEP_S, NOTHING._replace(firmware="S-V1.8-8"))
    assert talk.handshake.generation is Generation.TWO
    assert talk.handshake.firmware == "S-V1.8-8"
    assert talk.handshake.phase is HandshakePhase.LIMITS
    assert len(talk.wire.codecs) == 1


def test_the_question_is_asked_at_once_and_once_again_after_half_a_second(talk):
    talk.handshake.follow_arm(NOTHING, BEGIN_S)
    assert talk.wire.take() == [VERSION]
    talk.wait(0.484375)
    assert talk.wire.take() == []
    talk.wait(STEP_S)
    assert talk.wire.take() == [VERSION]
    talk.wait(0.484375)
    assert talk.wire.take() == []
    assert now(talk.handshake.generation) is None


def test_an_arm_that_is_asked_and_does_not_answer_is_of_generation_1(talk):
    offsets = Addressing(0x10, 0x20)
    talk = Talk(offsets)
    talk.wait(1.0)
    assert now(talk.handshake.generation) is None
    talk.wait(STEP_S, NOTHING._replace(frames=10_000))  # its pace says nothing
    assert talk.handshake.generation is Generation.ONE
    assert talk.handshake.firmware is None
    assert talk.handshake.phase is HandshakePhase.LIMITS
    first, second = talk.wire.codecs
    assert (first.generation, second.generation) == (Generation.TWO, Generation.ONE)
    assert first.addressing == second.addressing == offsets
    assert talk.handshake.codec is second


def test_an_answer_that_cannot_be_read_is_of_generation_2_all_the_same(talk):
    talk.wait(2.0, NOTHING._replace(version_heard_s=BEGIN_S + 0.1))
    assert talk.wire.take() == [VERSION] * 4  # frames of an answer get lost
    assert now(talk.handshake.generation) is None
    talk.wait(STEP_S, NOTHING._replace(version_heard_s=BEGIN_S + 0.1))
    assert talk.handshake.generation is Generation.TWO
    assert talk.handshake.firmware is None
    assert len(talk.wire.codecs) == 1


@pytest.mark.parametrize(
    ("version", "layouts"),
    [("S-V1.8-7", [MitLayout.A]), ("S-V1.8-8", []), ("S-V1.9-0", []), ("S-V1.5-2", [MitLayout.A])],
)
def test_the_version_says_how_mit_frames_are_read_and_nothing_is_forgotten(talk, version, layouts):
    talk.wait(STEP_S, NOTHING._replace(firmware=version))
    assert str(talk.handshake.codec.firmware) == version
    assert [codec.quirks.mit_layout for codec in talk.wire.refined] == layouts
    assert len(talk.wire.codecs) == 1


def test_a_version_that_is_named_late_counts_as_well(talk):
    torn = NOTHING._replace(version_heard_s=BEGIN_S + 0.1)
    talk.wait(2.0 + STEP_S, torn)
    assert talk.handshake.generation is Generation.TWO
    talk.wait(STEP_S, torn._replace(firmware="S-V1.7-3"))
    assert talk.handshake.firmware == "S-V1.7-3"
    assert talk.wire.refined == [talk.handshake.codec]


def test_a_teaching_input_that_answers_nothing_is_not_taken_for_generation_1(talk):
    """S-V1.7-3: it leads, its drivers may tell, and 0x2A1 and 0x4AF stay silent."""
    for _ in range(64 * 6):
        talk.wait(STEP_S, NOTHING._replace(foreign_targets_s=talk.now_s))
    assert now(talk.handshake.generation) is None
    assert talk.wire.take() == [VERSION] * 5  # at 0, 0.5, 1, 3 and 5 s
    talk.wait(2.0, NOTHING._replace(firmware="S-V1.7-3"))  # it follows again
    assert talk.handshake.generation is Generation.TWO


def test_a_leader_beside_an_arm_that_tells_its_status_says_nothing_of_it(talk):
    status = Reading(Status(1, 0, 1, 0, True, None, None, (False,) * 6, (False,) * 6), BEGIN_S)
    for _ in range(70):
        talk.wait(STEP_S, NOTHING._replace(foreign_targets_s=talk.now_s, status=status))
    assert talk.handshake.generation is Generation.ONE


def test_a_log_may_have_told_the_version_elsewhere():
    wire = Wire()
    handshake = Handshake(wire, 0.0, Addressing(), Generation.TWO, "S-V1.8-5")
    assert handshake.codec.quirks.mit_layout is MitLayout.A
    handshake.follow_arm(NOTHING._replace(firmware="S-V1.8-5"), 0.1)
    assert wire.refined == []


@pytest.mark.parametrize(
    ("per_s", "generation"), [(1500.0, Generation.ONE), (1600.0, Generation.TWO)]
)
def test_an_arm_that_may_not_be_asked_is_told_by_its_pace(talk, per_s, generation):
    talk.wire.may_send = False
    talk.wait(1.0)
    talk.now_s += 3.0
    heard = round(per_s * (talk.now_s + STEP_S - BEGIN_S))
    talk.wait(STEP_S, NOTHING._replace(frames=heard))
    assert talk.handshake.generation is generation


@pytest.mark.parametrize("asked", [(True, False), (False, True)])
def test_an_arm_that_was_asked_once_is_not_told_by_its_pace(talk, asked):
    talk.wire.may_send = asked[0]
    talk.wait(0.25)
    talk.wire.may_send = asked[1]
    talk.wait(1.0, NOTHING._replace(frames=10_000))
    assert talk.handshake.generation is Generation.ONE


# Its limits ---------------------------------------------------------------------------------------


def test_the_limits_of_all_joints_are_asked_for(talk):
    talk.settle()
    talk.handshake.follow_arm(NOTHING, talk.now_s)
    assert talk.wire.take() == questions(1, 2, 3, 4, 5, 6)
    assert not talk.handshake.done


def test_they_are_asked_for_as_soon_as_the_version_is_known(talk):
    talk.wait(STEP_S)
    talk.settle()
    talk.wait(STEP_S)
    assert talk.wire.take() == questions(1, 2, 3, 4, 5, 6)


def test_what_is_missing_is_asked_for_again_after_a_fifth_of_a_second(talk):
    talk.settle()
    some = ALL_LIMITS._replace(limits=(*ALL_LIMITS.limits[:4], None, ALL_LIMITS.limits[5]))
    talk.wait(STEP_S, some)
    assert talk.wire.take() == questions(5)
    talk.wait(0.1875, some)
    assert talk.wire.take() == []
    talk.wait(STEP_S, some)
    assert talk.wire.take() == questions(5)


def test_a_further_question_after_exactly_a_fifth_of_a_second():
    talk = Talk()
    talk.handshake = Handshake(talk.wire, 0.0)
    talk.handshake.follow_arm(NOTHING._replace(firmware="S-V1.8-8"), 0.0)
    talk.handshake.follow_arm(NOTHING, 0.0)
    talk.wire.take()
    talk.handshake.follow_arm(NOTHING, 0.2)
    assert talk.wire.take() == questions(1, 2, 3, 4, 5, 6)


def test_it_is_done_when_they_are_all_read(talk):
    talk.settle()
    talk.wait(STEP_S)
    talk.wire.take()
    talk.wait(STEP_S, ALL_LIMITS)
    assert talk.handshake.done
    assert talk.handshake.phase is HandshakePhase.DONE
    talk.wait(2.0)
    assert talk.wire.take() == []


def test_limits_that_are_known_already_are_not_asked_for(talk):
    talk.settle()
    talk.wait(STEP_S, ALL_LIMITS)
    assert talk.handshake.done
    assert talk.wire.take() == []


@pytest.mark.parametrize(
    ("version", "after_s"), [(None, 1.0 + STEP_S), ("S-V1.8-8", STEP_S)], ids=["gen1", "gen2"]
)
def test_after_five_questions_it_is_done_with_what_was_read(talk, version, after_s):
    talk.wait(after_s, NOTHING._replace(firmware=version))
    talk.wire.take()
    talk.wait(0.25 * 4)
    asked = len(talk.wire.sent) // 12
    assert asked == 5
    assert not talk.handshake.done
    talk.wait(0.25)
    assert talk.handshake.done
    assert len(talk.wire.sent) // 12 == 5


# Who it is, later ---------------------------------------------------------------------------------


@pytest.mark.parametrize("pauses", [1, 0])
def test_after_every_pause_it_is_asked_twice_who_it_is(talk, pauses):
    """Its power may have been off for long enough to exchange it."""
    talk.settle()
    talk.wait(STEP_S, ALL_LIMITS)
    for count in (pauses, 2, 1):
        paused = NOTHING._replace(pauses=count)
        talk.wait(STEP_S, paused)
        assert talk.wire.take() == [VERSION] * bool(count)
        talk.wait(0.484375, paused)
        assert talk.wire.take() == []
        talk.wait(2.0, paused)
        assert talk.wire.take() == [VERSION] * bool(count)


@pytest.mark.parametrize(("began_s", "asked"), [(0.0, [VERSION]), (STEP_S, [])])
def test_an_answer_that_began_after_the_pause_ends_the_questions(talk, began_s, asked):
    talk.settle()
    talk.wait(STEP_S, ALL_LIMITS)
    talk.wait(STEP_S, NOTHING._replace(pauses=1))
    talk.wire.take()
    named = NamedVersion("S-V1.8-8", "", talk.now_s + began_s)
    answered = NOTHING._replace(pauses=1, versions_named=(NamedVersion("S-V1.8-8", "", 0.0), named))
    talk.wait(1.0, answered)
    assert talk.wire.take() == asked
    talk.wait(1.0, NOTHING._replace(pauses=1))
    assert talk.wire.take() == []


def test_generation_1_cannot_be_asked_after_a_pause(talk):
    talk.wait(1.0 + STEP_S)
    talk.wait(STEP_S, ALL_LIMITS)
    talk.wire.take()
    talk.wait(1.0, NOTHING._replace(pauses=1, firmware="S-V1.8-8"))
    assert talk.wire.take() == []
    assert talk.handshake.firmware is None


def test_the_identity_grows_as_its_texts_are_heard_until_one_contradicts(talk):
    first = ArmIdentity("S-V1.8-8")
    whole = first._replace(hardware="H-V1.2-1")
    for identity, kept in (
        (None, None),
        (first, first),
        (None, first),
        (whole, whole),
        (whole._replace(hardware="H-V1.3-1"), whole),
    ):
        talk.wait(STEP_S, NOTHING._replace(firmware="S-V1.8-8", identity=identity))
        assert talk.handshake.identity == kept


def test_a_log_that_states_its_generation_is_not_asked_for_it():
    wire = Wire()
    handshake = Handshake(wire, 0.0, Addressing(), Generation.ONE)
    assert handshake.generation is Generation.ONE
    assert handshake.codec.generation is Generation.ONE
    handshake.follow_arm(NOTHING, 0.0)
    assert wire.take() == questions(1, 2, 3, 4, 5, 6)
