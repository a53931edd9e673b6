"""The window 仿真故障: begins and ends faults of this program's simulated arm."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QComboBox, QWidget

from armui.arm.limits import JOINTS
from armui.control.arm_controller import ArmController
from armui.ui.actions.act import Act, ActFamily, toggle_button
from armui.ui.actions.command import with_simulated
from armui.ui.dialogs.base import ArmDialog, CloseButton
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import STRETCH, empty_grid, fill, in_row
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.text_label import text_label
from armui.ui.words.text import Texts, listed

if TYPE_CHECKING:
    from armui.ui.picture.target_drag import HandGuide


AT_A_JOINT: Final = Texts("SimulatedFault") | {
    "motor-overtemperature": "Motor too hot",
    "driver-overtemperature": "Driver too hot",
    "overcurrent": "Overcurrent",
    "joint-communication": "Joint not reached",
    "sensor-error": "Encoder fails",
    "driver-error": "Driver fails",
    "stall": "Joint blocked",
    "collision": "Collision (40 N·m)",
    "stiff-joint": "Joint turns stiffly",
    "hot-joint": "Joint runs hot",
    "slip": "Slips by 5°, seen at resume",
    "lost-reference": "Reference lost, until release",
    "corrupt-limits": "Limits 0xFFFF, until reset",
}
OF_THE_ARM: Final = Texts("SimulatedFault") | {
    "power-off": "Power off",
    "undervoltage": "Undervoltage (18 V)",
    "feedback-stopped": "Feedback silent",
    "bus-off": "Bus off",
    "deaf-adapter": "Adapter deaf",
    "lost-frames": "10 % of frames lost",
    "latency": "Frames 50 ms late",
    "garbage": "Foreign frames, 100/s",
}
"""The faults by their names in `armui.sim.faults.schedule`."""
_ONCE: Final = frozenset({"lost-reference", "corrupt-limits", "slip"})
"""The faults whose end changes nothing."""


class FaultsDialog(ArmDialog):
    """Switches faults of the simulated arm by its hand, never by a bus: no real arm is reached.

    Args:
        controller: Gives the connected arm.
        hand: Returns what leads the simulated arm and switches its faults, or None.
        parent: The main window.
    """

    switches = ActFamily(
        {
            name: Act(
                faults.entry(name), named=f"fault_{name}", needs=with_simulated, kind=toggle_button
            )
            for faults in (AT_A_JOINT, OF_THE_ARM)
            for name in faults
        }
    )

    def __init__(
        self, controller: ArmController, hand: Callable[[], HandGuide | None], parent: QWidget
    ) -> None:
        super().__init__(controller, parent)
        self._hand = hand
        self._joint_label, self._arm_label = text_label(), text_label()
        self.joint_box = named("fault_joint", QComboBox())
        self.joint_box.addItems([f"J{joint}" for joint in JOINTS])
        self._joint_label.setBuddy(self.joint_box)
        self._message = named("faults_message", MessageLine())
        joint = in_row(self._joint_label, self.joint_box, STRETCH)
        grid, left = empty_grid(gaps=(8, 8), margins=0), Qt.AlignmentFlag.AlignLeft
        for faults, head in ((AT_A_JOINT, joint), (OF_THE_ARM, in_row(self._arm_label))):
            first = grid.rowCount()
            grid.addLayout(head, first, 0, 1, 3)
            for place, name in enumerate(faults):
                grid.addWidget(self.switches[name], first + 1 + place // 3, place % 3, left)
        fill(self.body, grid, STRETCH, self._message)
        fill(self.footer, STRETCH, CloseButton(self))
        self.joint_box.currentIndexChanged.connect(self._refresh)
        controller.operating_state_changed.connect(self._refresh)
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("Simulated faults"))
        self._joint_label.setText(self.tr("At joint"))
        self._arm_label.setText(self.tr("Of the arm and its bus"))
        self._refresh()

    @switches.pressed
    def _on_switch(self, name: str) -> None:
        hand, joint = self._reached(), self._joint_of(name)
        if hand is not None:
            hand.switch(name, joint, begins=(name, joint) not in hand.faults)
            if name in _ONCE:
                hand.switch(name, joint, begins=False)
        self._refresh()

    def _reached(self) -> HandGuide | None:
        """Return the access to the simulated arm while it is the connected arm, else None."""
        return None if with_simulated(self._controller.operating_state) else self._hand()

    def _joint_of(self, name: str) -> int:
        return self.joint_box.currentIndex() + 1 if name in AT_A_JOINT else 0

    def _refresh(self, *_: object) -> None:
        self.show_acts()
        hand = self._reached()
        on = set() if hand is None else hand.faults
        for name, button in self.switches.items():
            button.setChecked((name, self._joint_of(name)) in on)
        said = with_simulated(self._controller.operating_state)
        said = said or self.tr("Pressed, a fault begins; pressed again, it ends.")
        words = [f"{AT_A_JOINT.text(n)} J{j}" if j else OF_THE_ARM.text(n) for n, j in sorted(on)]
        if words:
            said = self.tr("On: {faults}").format(faults=listed(words))
        self._message.show_message(said)
