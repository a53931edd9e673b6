"""Compares the chosen model with the arm's reports and warns; the operator decides.

It also finds the zeros from which the arm counts joints 2 and 3: by its version, and by the pose it
reports, which takes precedence.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from armui.arm.model_check import FittingArm, ModelFit, Models, fitting_arms
from armui.arm.models import model_data
from armui.control.context import ControllerPart
from armui.control.events import Notice
from armui.telemetry.events import EventKind, Level

if TYPE_CHECKING:
    from armui.arm.device import Device
    from armui.arm.state import ArmState
    from armui.control.context import Context
    from armui.protocol.generation import PiperModel

MODEL_OTHER_NOTICE = Notice(
    "model_other",
    "Connected as a {chosen}, but the pose it reports is that of a {fits}. Connect it as a {fits}.",
    Level.WARNING,
    EventKind.STATUS,
)
MODEL_NONE = Notice(
    "model_none",
    "The pose the arm reports fits its angles in no model of the family, {chosen} included.",
    Level.WARNING,
    EventKind.STATUS,
)
MODEL_RECALLED = Notice(
    "model_recalled",
    "Last time this arm (node {node}) was a {before}: that is used instead of {chosen}, which "
    "was only the default.",
    Level.INFO,
    EventKind.STATUS,
)
MODEL_WAS_OTHER = Notice(
    "model_was_other",
    "Connected as a {chosen}, but last time this arm (node {node}) was a {before}. If it is "
    "one, connect it as that.",
    Level.WARNING,
    EventKind.STATUS,
)

_EVERY_S: Final = 0.5
_LOOKS: Final = 2
"""The number of equal results in a row before a result counts."""


class ModelWatch(ControllerPart):
    """Compares the model twice a second while the arm stands still.

    A single pose that fits more than one model decides nothing; together with the poses before it
    may.

    Args:
        context: The context that the controller's parts share.

    Attributes:
        fitting: The models that fit the arm's reports; ``None`` before the first comparison.
    """

    def __init__(self, context: Context) -> None:
        self._context = context
        self.fitting: Models | None = None
        self._seen: Models | None = None
        self._looks = 0
        self._looked_s = -_EVERY_S
        self._warned: Models | None = None
        self._pose_tells: bool | None = None
        self._before: PiperModel | None = None
        self._zeros: tuple[Device, PiperModel, bool] | None = None

    def fit(self) -> ModelFit:
        """Return the chosen model and whether the arm's reports fit it."""
        connection = self._context.connection
        arm = connection.device, connection.model
        older_zeros = self._zeros is not None and self._zeros == (*arm, True)
        before = self._before if self.fitting is None else None
        return ModelFit(connection.model, self.fitting, older_zeros, before)

    def recall(self, model: PiperModel, node: str) -> None:
        """Take over the model with which this very arm was last connected, by its identity.

        It replaces a model that was only offered, while nothing is under way. A model that the
        operator has chosen this time stays, and the operator is asked.

        Args:
            model: The model stored for the arm, which had confirmed it.
            node: Its node number.
        """
        connection = self._context.connection
        now = self._context.refresh()
        device, chosen = connection.device, connection.model
        if device is None or device.simulated or device.recorded is not None or model is chosen:
            return
        names = {
            "chosen": model_data(chosen).name,
            "before": model_data(model).name,
            "node": node,
        }
        idle = now.occupied is None and not now.moving and not self._context.authority.under_way
        if self.fit().confirmed:
            return  # the arm's own feedback confirms the model
        if not (device.model_assumed and idle):
            self._before = model
            self._context.emit_event(MODEL_WAS_OTHER, **names)
            self._context.refresh()
            return
        connection.model = model
        self.forget_arm()
        self._context.emit_event(MODEL_RECALLED, **names)
        self._context.refresh()

    def assume(self, model: PiperModel) -> None:
        """Plan for this model while no device is open."""
        connection = self._context.connection
        if connection.device is None and connection.model is not model:
            connection.model = model
            self._context.refresh()

    def follow_arm(self) -> None:
        """Compare the model while the arm stands still."""
        now_s = self._context.clock()
        self._look_for_zeros()
        if now_s - self._looked_s < _EVERY_S or not self._context.authority.at_rest:
            return
        joints_deg, pose = _fresh_angles_and_pose(self._context.state(), now_s)
        if joints_deg is None or pose is None:
            return
        self._looked_s = now_s
        device = self._context.connection.device
        found = fitting_arms(joints_deg, pose, _version(self._context.state(), device))
        self._take_zeros(found)
        self._look_for_zeros()
        self._note_fitting(frozenset(arm.model for arm in found))

    def forget_arm(self) -> None:
        """Forget the comparison, because another arm may be another model."""
        self.fitting = self._seen = self._warned = None
        self._looks = 0
        self._pose_tells = self._before = None

    def _look_for_zeros(self) -> None:
        """Find the zeros of joints 2 and 3; while nothing shows them, they stay as they were."""
        connection = self._context.connection
        device = connection.device
        firmware = _version(self._context.state(), device)
        if device is None:
            return
        model = connection.model
        if self._pose_tells is not None:
            self._zeros = device, model, self._pose_tells
        elif device.recorded is not None and device.recorded.older_zeros is not None:
            self._zeros = device, model, device.recorded.older_zeros
        elif firmware is not None:
            self._zeros = device, model, model_data(model).older_zeros(firmware)

    def _take_zeros(self, found: frozenset[FittingArm]) -> None:
        """Take the zeros with which the reported pose fits the chosen model, if either does."""
        chosen = self._context.connection.model
        zeros = {arm.older_zeros for arm in found if arm.model is chosen}
        if len(zeros) == 1:
            self._pose_tells = zeros.pop()

    def _note_fitting(self, found: Models) -> None:
        before = self.fitting
        if before is not None and len(found) > 1 and found & before:
            found &= before
        self._looks = self._looks + 1 if found == self._seen else 1
        self._seen = found
        if self._looks < _LOOKS:
            return
        self.fitting = found
        fit = self.fit()
        if fit.wrong is None:
            self._warned = None
        elif self._warned != found:
            self._warned = found
            chosen = model_data(fit.chosen).name
            if found:
                self._context.emit_event(MODEL_OTHER_NOTICE, **fit.wrong.params)
            else:
                self._context.emit_event(MODEL_NONE, chosen=chosen)


def _version(state: ArmState, device: Device | None) -> str | None:
    """The version the arm has named, or that of the arm in a log."""
    recorded = None if device is None else device.recorded
    return state.firmware or (recorded.firmware if recorded is not None else None) or None


def _fresh_angles_and_pose(
    state: ArmState, now_s: float
) -> tuple[tuple[float, ...] | None, tuple[float, ...] | None]:
    """Return the angles and the pose; both ``None`` unless every value of both is fresh."""
    fresh = all(each is not None and each.fresh(now_s) for each in (*state.joints_deg, *state.pose))
    return (state.angles_deg(), state.end_pose()) if fresh else (None, None)
