"""停放位: a park position of the operator's own, kept for each arm."""

from __future__ import annotations

from datetime import datetime
from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import Signal
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu, QSizePolicy, QWidget

from armui.arm.limits import check_joints
from armui.arm.refusal import Reason, Refusal
from armui.control.context import GENERATION_UNKNOWN
from armui.control.events import Event, Level, Notice
from armui.control.link.arm_key import arm_key
from armui.control.link.link_state import NOT_CONNECTED
from armui.control.motion.joint_motion import Motion
from armui.control.safety.interlocks import JOINTS_UNKNOWN
from armui.ui import format as fmt
from armui.ui.actions.act import Act, HasActs
from armui.ui.actions.command import also
from armui.ui.actions.operator_view import why_taken
from armui.ui.widgets.buttons import enable_or_explain, give_menu, named, push_button
from armui.ui.widgets.layouts import in_row
from armui.ui.widgets.translated import Translated
from armui.ui.words.text import Text

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from armui.control.arm_controller import ArmController
    from armui.settings import SettingsStore

NO_OWN_HOME = Reason(
    "no_own_home", "No park position is kept for this arm. Set it with the arrow beside."
)
OWN_HOME_KEPT = Notice("own_home_kept", "Park position set: {angles}", Level.DONE)


_ARROW_PX: Final = 28

Angles = tuple[float, ...]


class OwnHome(HasActs, Translated, QWidget):
    """Moves to the operator's home pose of the connected arm, and sets it.

    Setting it moves nothing. The arm moves there like to any other target: by MOVE J, with the same
    checks.

    Args:
        controller: Moves the arm, and gives its state.
        preferences: The settings with the pose of each arm.
        typed: Returns the six angles in the panel, or ``None`` if one is invalid.

    Signals:
        refused: A :class:`Refusal`, or ``None`` when it was set.
        wanted: The motion is wanted: what sends it, as :func:`drive` takes it.
        kept: It was set: an :class:`Event` with the angles.

    Attributes:
        set_measured, set_typed: The buttons that set it.
    """

    refused = Signal(object)
    wanted = Signal(object)
    kept = Signal(object)

    go = Act(
        "Park position",
        named="own_home_button",
        does=Motion.send_joints,
        key="motion.own_home",
        title=Text("OwnHome", "Park position"),
        leads=True,  # the page shows whether a home is stored, and where
        synonyms=also("home park rest 原位 停放 待机位"),
    )

    def __init__(
        self,
        controller: ArmController,
        preferences: SettingsStore,
        typed: Callable[[], Sequence[float] | None],
    ) -> None:
        super().__init__()
        self._controller = controller
        self._preferences = preferences
        self._typed = typed
        self._set = push_button("set_own_home_button")
        self._menu = QMenu(self._set)
        self.set_measured = named("set_own_home_measured", QAction(self._menu))
        self.set_typed = named("set_own_home_typed", QAction(self._menu))
        self._menu.addActions([self.set_measured, self.set_typed])
        give_menu(self._set, self._menu)
        self._set.setFixedWidth(_ARROW_PX)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        in_row((self.go, 1), self._set, on=self, spacing=2, margins=0)
        self.set_measured.triggered.connect(lambda _checked=False: self._keep_measured())
        self.set_typed.triggered.connect(lambda _checked=False: self._keep(self._typed()))
        self.retranslate_ui()

    @property
    def _arm(self) -> str | None:
        """The key under which the arm's own home is stored; ``None`` before it is known."""
        now = self._controller.operating_state
        return arm_key(now.device, now.generation, self._controller.state.identity)

    @property
    def _node(self) -> str:
        """The number that the arm reports of itself; "" if it reports none, as in generation 1."""
        identity = self._controller.state.identity
        return "" if identity is None else identity.node_number

    @property
    def angles_deg(self) -> Angles | None:
        """The six angles, or ``None`` if none are stored for this arm."""
        kept = self._preferences.settings.home_poses.get(self._arm or "")
        return None if kept is None else tuple(kept)

    @go.pressed
    def _on_go(self) -> None:
        angles_deg = self.angles_deg
        if angles_deg is None:
            self.refused.emit(NO_OWN_HOME())
            return
        self.wanted.emit(partial(self._controller.motion.send_joints, angles_deg))

    def _keep_measured(self) -> None:
        unheard = self._controller.operating_state.unreachable
        if unheard is not None and not self._controller.operating_state.listens_only:
            self.refused.emit(unheard)
            return
        self._keep(self._controller.state.angles_deg())

    def _keep(self, angles_deg: Sequence[float] | None) -> None:
        arm, device = self._arm, self._controller.operating_state.device
        if arm is None:
            self.refused.emit(NOT_CONNECTED() if device is None else GENERATION_UNKNOWN())
        elif angles_deg is None:
            self.refused.emit(JOINTS_UNKNOWN())
        else:
            kept = tuple(round(angle, 3) for angle in angles_deg)
            refusal = self._refusal_of(arm, kept)
            self.refused.emit(refusal)
            if refusal is None:
                at = datetime.now().astimezone()
                self.kept.emit(Event(at, OWN_HOME_KEPT, {"angles": _figures(kept)}))
        self.show_possible()

    def _refusal_of(self, arm: str, angles_deg: Angles) -> Refusal | None:
        beyond = check_joints(angles_deg, self._controller.operating_state.limits)
        if beyond is not None:
            return beyond
        return self._preferences.keep("home_poses", {arm: angles_deg})

    @go.why_not
    def _why_not_go(self) -> Refusal | None:
        angles_deg, now = self.angles_deg, self._controller.operating_state
        if angles_deg is None:
            return NO_OWN_HOME()
        return now.cannot_move or check_joints(angles_deg, now.limits)

    @go.tip
    def _what_it_does(self) -> str:
        if self.angles_deg is None:
            return self._doubt()
        use = self.tr("Moves the joints to {angles}.").format(angles=_figures(self.angles_deg))
        return "\n".join(filter(None, (use, self._doubt())))

    def show_possible(self) -> None:
        """Enable it, or show why not; the tooltip contains the pose."""
        self.show_acts()
        use = self.tr("Sets the park position of this arm; nothing moves.")
        use = "\n".join(filter(None, (use, self._doubt())))
        enable_or_explain(self._set, why_taken("motion.set_own_home"), use)

    def _doubt(self) -> str:
        """Return a warning if other arms at this adapter cannot be told from this one, else ""."""
        if self._arm is None or self._node:
            return ""
        return self.tr(
            "This arm reports no number of its own: another one without a number at this "
            "adapter would be taken for it."
        )

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._set.setAccessibleName(self.tr("Set park position"))
        self.set_measured.setText(self.tr("Set to the measured angles"))
        self.set_typed.setText(self.tr("Set to the targets in the fields"))
        self.show_possible()


def _figures(angles_deg: Angles) -> str:
    return "  ".join(f"J{joint} {fmt.angle(a)}" for joint, a in enumerate(angles_deg, start=1))
