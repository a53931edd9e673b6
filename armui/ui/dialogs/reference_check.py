"""The window of the reference check: does each joint stand where it reports? (S34)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import Qt
from PySide6.QtGui import QCloseEvent, QImage, QPixmap, QShowEvent
from PySide6.QtWidgets import QCheckBox, QFrame, QLabel, QWidget

from armui.arm.limits import JOINTS
from armui.arm.reference_record import ReferenceRecord
from armui.arm.refusal import Refusal
from armui.control.arm_controller import ArmController
from armui.control.events import Level
from armui.control.operations.started import Started, refusal_of
from armui.control.safety.reference_control import ReferenceControl, why_not_drive
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.act import Act
from armui.ui.background import Background, Job
from armui.ui.dialogs.base import ArmDialog, CloseButton
from armui.ui.dialogs.confirm_dialog import confirm
from armui.ui.dialogs.files import choose_file
from armui.ui.widgets.buttons import named
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.layouts import STRETCH, empty_grid, fill, in_column, in_row
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.text_label import text_label
from armui.ui.words.reference import reference_text
from armui.ui.words.text import Text

if TYPE_CHECKING:
    from collections.abc import Sequence

    from armui.control.safety.reference_check import CheckStep, ReferenceCheck

_SIZE_PX: Final = (720, 620)
_PHOTO_PX: Final = 200
_PHOTOS: Final = "*.png *.jpg *.jpeg *.bmp"


class ReferenceDialog(ArmDialog):
    """Leads through the check: the arm by eye, each joint in doubt by hand, the others slowly.

    Args:
        controller: Carries out the check.
        background: Reads the photo of the reference pose.
        parent: The main window.
    """

    begin_button = Act(
        "Begin the check",
        named="reference_begin",
        does=ReferenceControl.begin,
        key="reference.begin",
        primary=True,
    )
    allow_button = Act(
        "Move anyway",
        named="reference_allow",
        does=ReferenceControl.allow,
        key="reference.allow",
        held=True,
    )
    look_button = Act("The others stand as shown", named="reference_look")
    off_button = Act("Motor off…", named="reference_motor_off")
    drive_button = Act(
        "Drive to the mark",
        named="reference_drive",
        does=ReferenceControl.drive,
        key="reference.drive",
        held=True,
    )
    mark_button = Act("Stands at its mark", named="reference_at_mark")
    differs_button = Act("Off by this", named="reference_differs")
    finish_button = Act(
        "Finish the check",
        named="reference_finish",
        does=ReferenceControl.finish,
        key="reference.finish",
        primary=True,
    )
    back_button = Act("Answer again", named="reference_back")
    teach_button = Act(
        "Teach reference pose…",
        named="reference_teach",
        does=ReferenceControl.teach,
        key="reference.teach",
        title=Text("ReferenceDialog", "Teach reference pose…"),
    )

    def __init__(
        self, controller: ArmController, background: Background, parent: QWidget | None = None
    ) -> None:
        super().__init__(controller, parent)
        self._background = background
        self._photo = ""
        self._refusal: Refusal | None = None
        self._build()
        self.off_field.value_edited.connect(self._show)
        controller.state_changed.connect(self._on_changed)
        controller.operating_state_changed.connect(self._on_changed)
        self.resize(*_SIZE_PX)
        self.retranslate_ui()

    # -- layout -------------------------------------------------------------------------------

    def _build(self) -> None:
        self._intro = text_label("reference_intro", rank="muted", wraps=True)
        self._labels: dict[int, tuple[QLabel, QLabel, QLabel, QLabel]] = {}
        table = QFrame()
        grid = empty_grid(table, gaps=(28, 6), margins=0)
        self._heads = [text_label(rank="muted") for _ in range(4)]
        for column, head in enumerate(self._heads):
            grid.addWidget(head, 0, column)
        for joint in JOINTS:
            cells = (text_label(), text_label(), text_label(), text_label(f"reference_{joint}"))
            self._labels[joint] = cells
            for column, cell in enumerate(cells):
                grid.addWidget(cell, joint, column)
        grid.setColumnStretch(3, 1)
        self._task = text_label("reference_task", wraps=True, plain=True)
        self._task.setAlignment(Qt.AlignmentFlag.AlignTop)
        self._elsewhere = {
            joint: named(f"reference_elsewhere_{joint}", QCheckBox(f"J{joint}")) for joint in JOINTS
        }
        self.off_field = named("reference_off_field", FigureField(1, "°"))
        self.off_field.setFixedWidth(100)
        self._picture = QLabel()
        self._picture.setVisible(False)
        self._message = MessageLine(self)
        does = in_row(*self._elsewhere.values(), self.look_button, STRETCH, spacing=10)
        answers = in_row(
            *(self.off_button, self.drive_button, self.mark_button),
            *(self.off_field, self.differs_button, self.finish_button, STRETCH),
            spacing=10,
        )
        task = in_column((self._task, 1), does, answers, spacing=10)
        card = QFrame()
        card.setProperty("card", True)
        in_row((task, 1), self._picture, on=card, spacing=14, margins=14)
        fill(self.body, self._intro, table, (card, 1), self._message)
        self._close = CloseButton(self)
        fill(self.footer, self.teach_button, self.allow_button, STRETCH)
        fill(self.footer, self.begin_button, self.back_button, self._close)
        self.begin_button.setFocus()  # else it is on `teach_button`, which skips the check

    def showEvent(self, event: QShowEvent) -> None:
        """Show the present state and the photo of the reference pose."""
        super().showEvent(event)
        if not event.spontaneous():
            self._refusal = None
            self._show()

    def closeEvent(self, event: QCloseEvent) -> None:
        """Leave a check that has no result yet."""
        self._controller.reference.leave()
        super().closeEvent(event)

    def reject(self) -> None:
        """Close by Escape as by the button."""
        self._controller.reference.leave()
        super().reject()

    # -- what the operator does ---------------------------------------------------------------

    @property
    def _check(self) -> ReferenceCheck | None:
        return self._controller.reference.check

    @property
    def _step(self) -> CheckStep | None:
        check = self._check
        return check.next if check is not None and check.looked else None

    def _show_result(self, result: Started | Refusal | None) -> None:
        self._refusal = refusal_of(result)
        self._show()

    @begin_button.pressed
    def _on_begin(self) -> None:
        self._show_result(self._controller.reference.begin())

    @allow_button.pressed
    def _on_allow(self) -> None:
        self._show_result(self._controller.reference.allow())

    @finish_button.pressed
    def _on_finish(self) -> None:
        self._show_result(self._controller.reference.finish())

    @look_button.pressed
    def _on_looked(self) -> None:
        self._controller.reference.note_elsewhere(
            [j for j, box in self._elsewhere.items() if box.isChecked()]
        )
        self._show()

    @off_button.why_not
    def _why_not_off(self) -> str:
        step, enabled = self._step, self._controller.operating_state.enabled
        off = step is not None and enabled[step.joint - 1] is False
        return self.tr("The motor is off.") if off else ""

    @off_button.pressed
    def _ask_motor_off(self) -> None:
        step = self._step
        if step is None:
            return
        confirm(
            self,
            self._controller,
            title=self.tr("Switch off the motor of joint {joint}").format(joint=step.joint),
            text=self.tr(
                "Joint {joint} goes limp, and what hangs on it drops: hold the arm with both "
                "hands. The other joints keep their power."
            ).format(joint=step.joint),
            action_label=self.tr("Motor off"),
            on_confirmed=lambda: self._show_result(self._controller.motors.disable(step.joint)),
            hold=True,
            still=lambda: self._step == step,
            on_withdrawn=self._show_result,
        )

    @drive_button.why_not
    def _why_not_drive(self) -> Refusal | None:
        joint = JOINTS[0] if self._step is None else self._step.joint
        return why_not_drive(self._controller.operating_state, joint)

    @drive_button.pressed
    def _on_drive(self) -> None:
        step = self._step
        if step is not None:
            self._show_result(self._controller.reference.drive(step.joint))

    @mark_button.why_not
    def _why_not_at_mark(self) -> str:
        step = self._step
        if step is None or not step.by_hand or step.mark_deg is None or self._why_not_off():
            return ""
        return self.tr("Switch its motor off and turn it by hand first.")

    @mark_button.pressed
    def _on_at_mark(self) -> None:
        step, reference = self._step, self._controller.reference
        if step is not None:
            off_deg = 0.0 if step.mark_deg is None else reference.at_mark(step.joint)
            if off_deg is not None:
                self._answer(step.joint, off_deg)

    @differs_button.why_not
    def _why_not_differs(self) -> str:
        given = self.off_field.value is not None
        return "" if given else self.tr("Type first by how much it is off.")

    @differs_button.pressed
    def _on_differs(self) -> None:
        step, off_deg = self._step, self.off_field.value
        if step is not None and off_deg is not None:
            self._answer(step.joint, off_deg)

    def _answer(self, joint: int, off_deg: float) -> None:
        self._controller.reference.answer(joint, round(off_deg, 1))
        self.off_field.show_value(None)
        self._show()

    @back_button.why_not
    def _why_not_back(self) -> str:
        check = self._check
        answered = check is not None and len(check.unanswered) < len(JOINTS)
        return "" if answered else self.tr("No joint is answered yet.")

    @back_button.pressed
    def _on_back(self) -> None:
        check = self._check
        if check is not None:
            answered = [s.joint for s in check.steps if check.answered(s.joint) is not None]
            if answered:
                self._controller.reference.take_back(answered[-1])
            self._show()

    @teach_button.pressed
    def _ask_to_teach(self) -> None:
        confirm(
            self,
            self._controller,
            title=self.tr("Teach the reference pose"),
            text=self.tr(
                "Where the arm stands now is kept as its reference pose: joints 2 and 3, which "
                "have no mark, are compared with it. Put the arm where you will recognise it to "
                "the degree, for example with the fingertip on a cross on the table. You may "
                "then choose a photo of it. Only teach it while the reference is right."
            ),
            action_label=self.tr("Keep this pose"),
            on_confirmed=self._on_teach,
            on_withdrawn=self._show_result,
        )

    def _on_teach(self) -> None:
        self._show_result(self._controller.reference.teach())
        if self._refusal is None:
            choose_file(
                self,
                self._controller,
                title=self.tr("Photo of the arm in its reference pose"),
                name_filter=self.tr("Pictures ({kinds})").format(kinds=_PHOTOS),
                on_chosen=lambda path: self._controller.reference.keep_photo(str(path)),
            )

    # -- appearance ---------------------------------------------------------------------------

    def _on_changed(self) -> None:
        if self.isVisible():
            self._show()

    def _show(self) -> None:
        check, step = self._check, self._step
        record = self._controller.reference.record
        self._show_joints(record.doubtful, step)
        looks = check is not None and not check.looked
        done = check is not None and check.looked and step is None
        marked = step is not None and step.mark_deg is not None
        by_hand = step is not None and step.by_hand
        for joint, box in self._elsewhere.items():
            box.setVisible(looks)
            if check is None:
                box.setChecked(joint in record.doubtful)
            box.setEnabled(joint not in record.doubtful)
        self.look_button.setVisible(looks)
        self.off_button.setVisible(by_hand)
        self.drive_button.setVisible(marked and not by_hand)
        for widget in (self.mark_button, self.off_field, self.differs_button):
            widget.setVisible(step is not None)
        self.finish_button.setVisible(done)
        self.begin_button.setVisible(check is None)
        self.teach_button.setVisible(check is None)
        self.allow_button.setVisible(check is None and bool(record.doubtful))
        self.back_button.setVisible(check is not None and check.looked)
        self.show_acts()
        self._task.setText(self._task_text(record, check, step))
        self._show_photo(record.photo if step is not None and step.joint in (2, 3) else "")
        said = words.why_not(self._refusal)
        self._message.show_message(said, Level.WARNING if said else Level.INFO)

    def _show_joints(self, doubtful: Sequence[int], step: CheckStep | None) -> None:
        check, state = self._check, self._controller.state
        marks = {} if check is None else {each.joint: each.mark_deg for each in check.steps}
        for joint, (name, reported, mark, result) in self._labels.items():
            heard = state.joints_deg[joint - 1]
            arrow = "▸ " if step is not None and step.joint == joint else ""
            name.setText(f"{arrow}J{joint}")
            reported.setText(fmt.NOTHING if heard is None else fmt.angle(heard.value))
            at = marks.get(joint)
            mark.setText(fmt.NOTHING if at is None else fmt.angle(at))
            off = None if check is None else check.answered(joint)
            text = self.tr("in doubt") if joint in doubtful else ""
            if off is not None and check is not None:
                fits = joint not in check.off_deg
                text = self.tr("fits") if fits else self.tr("off by {off}")
                text = text.format(off=fmt.angle(off))
            result.setText(text)

    def _task_text(
        self, record: ReferenceRecord, check: ReferenceCheck | None, step: CheckStep | None
    ) -> str:
        if check is None:
            return "\n\n".join((reference_text(record), self._remedy(record)))
        if not check.looked:
            return self.tr(
                "Look at the whole arm beside the picture, which shows what it reports. Tick each "
                "joint that stands elsewhere than the picture shows. Nothing drives those joints; "
                "any that is in doubt is ticked already."
            )
        if step is None:
            if check.off_deg:
                return self.tr(
                    "All joints are answered for, and some are off. Finish the check: they stay in "
                    "doubt, and what can be done is shown then."
                )
            return self.tr("All joints stand where they report. Finish the check to keep that.")
        return self._joint_text(step)

    def _joint_text(self, step: CheckStep) -> str:
        place = self.tr("its mark")
        if step.joint in (2, 3):
            place = self.tr("its place in the reference pose")
        figures = {"joint": step.joint, "place": place}
        if step.mark_deg is None:
            text = self.tr(
                "Joint {joint} has no mark, and no reference pose is taught. Compare it with the "
                "picture: does it stand as shown? If not, type by how much it is off."
            )
        elif step.by_hand:
            text = self.tr(
                "Joint {joint} may stand 85° from what it reports: nothing drives it. Hold the "
                "arm, switch its motor off and turn it to {place} by hand; then press “Stands at "
                "its mark”. What it reports there shows how far it is off."
            )
        else:
            text = self.tr(
                "Hold “Drive to the mark”: joint {joint} goes to {place} at 5 %, the others stay. "
                "Look whether it then stands there. If not, type by how much it is off."
            )
        return text.format(**figures)

    def _remedy(self, record: ReferenceRecord) -> str:
        if not record.off_deg:
            return self.tr(
                "The check takes some two minutes. A joint in doubt is brought to its mark by "
                "hand; the others are driven slowly, each by a held button."
            )
        return self.tr(
            "What can be done: (1) Reset with the arm held. Emergency stop, hold the arm, Release: "
            "its motors lose their power and the arm drops; the arm then finds its reference "
            "again. Enable, and check once more. (2) Set the joint's zero, only if a reset does "
            "not help and the joint stands at its mark: nothing moves, but every angle, limit and "
            "saved point counts from there. Neither ends the doubt: only this check does."
        )

    def _show_photo(self, path: str) -> None:
        self._picture.setVisible(bool(path))
        if path and path != self._photo:
            self._picture.clear()
            self._background.begin_here(Job(self._on_photo), _read_photo, path)
        self._photo = path

    def _on_photo(self, photo: QImage | Refusal) -> None:
        if isinstance(photo, Refusal) or photo.isNull():
            self._picture.setText(self.tr("The photo cannot be read."))
        else:
            self._picture.setPixmap(QPixmap.fromImage(photo))

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("Reference check"))
        self._intro.setText(
            self.tr("Does each joint stand where it reports? The feedback alone cannot tell.")
        )
        heads = (self.tr("Joint"), self.tr("Reported"), self.tr("At the mark"), self.tr("Result"))
        for head, text in zip(self._heads, heads, strict=True):
            head.setText(text)
        self.off_field.setAccessibleName(self.tr("Off by"))
        self._show()


def _read_photo(path: str) -> QImage:
    """Return a photo as small as it is shown; it waits for a disk."""
    size = Qt.AspectRatioMode.KeepAspectRatio
    image = QImage(path)
    if image.isNull():
        return image
    smooth = Qt.TransformationMode.SmoothTransformation
    return image.scaled(_PHOTO_PX, _PHOTO_PX, size, smooth)
