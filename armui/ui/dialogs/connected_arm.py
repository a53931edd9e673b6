"""What the doctor says about the arm that the window is connected to, from what it hears itself."""

from __future__ import annotations

from dataclasses import replace

from armui.arm.models import model_data
from armui.control.arm_controller import ArmController
from armui.control.operating_state import LinkState
from armui.doctor.facts import Diagnosis, DiagnosisLevel, HeardFacts, Section
from armui.doctor.hearing import arm_facts
from armui.doctor.judge import judge_heard
from armui.protocol.codec import Codec
from armui.protocol.generation import Generation


def judge_connected(controller: ArmController, *, frames: int, seconds: float) -> list[Diagnosis]:
    """Findings about the arm on the open device; none where no device is open.

    Args:
        controller: Who hears it.
        frames: So many frames were received while it was listened to.
        seconds: So long that was.
    """
    now = controller.operating_state
    if now.device is None:
        return []
    generation = now.generation or Generation.TWO
    online = now.link is LinkState.ONLINE
    arm = arm_facts(
        controller.state,
        Codec(generation, now.addressing),
        reason="",
        frames_per_s=frames / seconds if seconds > 0 else 0.0,
        firmware=controller.state.firmware,
    )
    arm = replace(arm, chosen_model=model_data(now.model).name)
    heard = HeardFacts(
        interface=now.device.interface,
        channel=str(now.device.channel),
        seconds=seconds,
        frames=frames,
        arm=arm if online else None,
        problem="" if now.link_problem is None else now.link_problem.code,
        problem_text="" if now.link_problem is None else str(now.link_problem.params),
        leader=now.teaching_input,
    )
    findings = judge_heard(heard)
    if now.other_host is not None and not now.teaching_input:
        params = {"device": now.device.name, "frames": now.other_host.frames}
        findings.append(Diagnosis(Section.ARM, "other_host", DiagnosisLevel.WARNING, params))
    return findings
