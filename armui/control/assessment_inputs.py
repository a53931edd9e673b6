"""Collects what the controller's parts are doing, and assesses what the operator can do."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from armui.control.assessment import assess
from armui.control.operating_state import Busy, OperatingState

if TYPE_CHECKING:
    from armui.arm.state import ArmState
    from armui.control.authority_watch import AuthorityWatch
    from armui.control.controller_parts import ControllerParts
    from armui.control.link.connection import Connection
    from armui.control.safety.stopping import Stopping


@dataclass(eq=False, repr=False)
class Assessor:
    """Keeps the operating state, so that reading it costs nothing; :meth:`refresh` assesses anew.

    Attributes:
        controller: Has the parts.
        connection: The way to the arm.
        stopping: Follows the stops.
        watch: Feeds the authority, which knows who moves the arm.
        clock: Monotonic time in seconds.
        state: Returns the arm as last heard.
        announce: Called with another operating state.
    """

    controller: ControllerParts
    connection: Connection
    stopping: Stopping
    watch: AuthorityWatch
    clock: Callable[[], float]
    state: Callable[[], ArmState]
    announce: Callable[[OperatingState], object]
    _operating_state: OperatingState | None = field(default=None, init=False)

    def read(self) -> OperatingState:
        """Return the operating state of the last assessment."""
        if self._operating_state is None:
            return OperatingState(speed_percent=self.controller.motion.speed_percent)
        return self._operating_state

    def observe(self) -> None:
        """Give the authority all feedback received so far."""
        self.watch.observe(self.clock())

    def refresh(self) -> OperatingState:
        """Observe the arm and the other hosts anew, and return the new operating state."""
        self.observe()
        return self.assess()

    def assess(self) -> OperatingState:
        """Return a new operating state, from the last observation and the state of the parts."""
        now_s = self.clock()
        authority, offsets = self.watch.authority, self.connection.offsets
        known = self._known(now_s)
        operating_state = assess(self.state(), known, authority, offsets, now_s)
        if operating_state != self.read():
            self._operating_state = operating_state
            self.announce(operating_state)
        return self.read()

    def _pending(self) -> frozenset[str]:
        controller = self.controller
        busy = {
            "clearing_error": controller.joint_errors.busy,
            "end_reports": controller.end_reports.busy,
            "linkage": controller.linkage.busy,
            "settings": controller.settings.busy,
            "teaching": controller.teaching.pending is not None,
        }
        return frozenset(part for part, is_busy in busy.items() if is_busy)

    def _known(self, now_s: float) -> OperatingState:
        """Return what the program knows beside the arm's feedback at monotonic time ``now_s``."""
        controller, connection = self.controller, self.connection
        emergency_stop = self.stopping.emergency_stop
        busy = controller.motors.busy or (Busy.ZEROING if controller.zeroing.busy else None)
        resuming = busy is Busy.RESUMING
        run = controller.last_run
        return OperatingState(
            link=connection.link,
            device=connection.device,
            link_problem=connection.problem,
            stop=self.stopping.state(self.state(), now_s, resuming=resuming),
            stop_unconfirmed=emergency_stop.unconfirmed(now_s),
            stop_lapsed=emergency_stop.lapsed,
            busy=busy,
            speed_percent=controller.speed_override.percent,
            generation=connection.generation,
            model_fit=controller.model_watch.fit(),
            below_base_mm=controller.jog_floor.below_base_mm(self.state()),
            below_lowest_mm=controller.jog_floor.below_lowest_mm(self.state()),
            intrusion=controller.area_guard.intrusion(self.state()),
            keeps_area=controller.area_guard.area is not None,
            reference=controller.reference.status,
            uncommanded=controller.sinking.motion,
            other_host=self.watch.report(),
            running=run.running,
            run_phase=run.phase,
            jogging=controller.jogging.active,
            recording=controller.recorder.recording,
            episode=controller.episodes.phase,
            altering=controller.transactions.altering,
            run_sets_lamps=controller.player.sets_lamps,
            pending=self._pending(),
        )
