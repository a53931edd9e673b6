"""An arm on the rig that an oracle never lets out of its sight."""

from __future__ import annotations

from armui.arm.refusal import Refusal
from armui.control.operations.started import Started
from armui.ui import words
from tests.arm_rig import ArmRig
from tests.control.jogger import fastest_deg_s
from tests.safety.mesh_oracle import Gap, Judge, MeshOracle

RESTS_DEG_S = 0.02
LOOK_S = 0.02
ENDS_WITHIN_S = 12.0


class Watch:
    """Looks where the simulated arm truly is, whenever the rig lets time pass.

    Args:
        rig: The arm.
        oracle: What measures it.
    """

    def __init__(self, rig: ArmRig, oracle: MeshOracle) -> None:
        self._rig = rig
        self._judge = Judge(oracle)
        self._see()
        rig.company.append(self)

    def step(self, dt_s: float) -> None:
        """Look where the arm has come by now; the rig calls it before time passes."""
        self._see()

    @property
    def least(self) -> Gap:
        """The nearest that the arm has ever been."""
        self._see()
        return self._judge.least

    def end(self) -> Gap:
        """Look no more; return the nearest that the arm has been."""
        self._rig.company.remove(self)
        return self.least

    def _see(self) -> None:
        firmware = self._rig.firmware
        self._judge.see(firmware.true_joints_deg, firmware.gripper.travel)


def watch(rig: ArmRig) -> Watch:
    """Watch an arm in the cell that is in force."""
    cell = rig.controller.cell.cell
    assert cell is not None
    return Watch(rig, MeshOracle.of(cell))


def settle(rig: ArmRig, answer: Started | Refusal | None, seconds: float = ENDS_WITHIN_S) -> bool:
    """Let time pass until a motion has ended and the arm rests; whether it had begun."""
    if not isinstance(answer, Started):
        told(answer)
        return False
    for _ in range(round(seconds / LOOK_S)):
        rig.step(LOOK_S)
        if answer.ending is not None and fastest_deg_s(rig) < RESTS_DEG_S:
            break
    return True


def rest(rig: ArmRig, seconds: float = 20.0) -> None:
    """Let time pass until the arm has stood for a second."""
    stood = 0
    for _ in range(round(seconds / LOOK_S)):
        rig.step(LOOK_S)
        stood = stood + 1 if fastest_deg_s(rig) < RESTS_DEG_S else 0
        if stood > 1.0 / LOOK_S:
            return
    raise AssertionError("it does not come to rest")


def told(answer: Started | Refusal | None) -> Refusal:
    """Return a refusal, whose sentence the operator can read."""
    assert isinstance(answer, Refusal), f"it was taken: {answer}"
    sentence = words.refusal(answer)
    assert sentence.strip()
    assert "{" not in sentence
    return answer
