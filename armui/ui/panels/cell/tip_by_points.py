"""The guided search for a tool's tip: poses in which it touches one point, and its orientation."""

from __future__ import annotations

from functools import partial
from typing import Any, Final

from PySide6.QtWidgets import QCheckBox, QComboBox, QGridLayout, QLabel, QPushButton

from armui.arm.refusal import Refusal
from armui.cell.tool_calibration import (
    DEFAULT_LIMIT_MM,
    LEAST_POSES,
    MOST_POSES,
    WANTED_DEG,
    TipFit,
    along_axis,
    by_two_points,
    find_tip,
    spread,
    turned_from_deg,
)
from armui.cell.tools import NO_TOOL
from armui.control.arm_controller import ArmController
from armui.control.cell.cell_reasons import CELL_NONE
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.panels.cell.cell_tab import NARROW_PX, Answered
from armui.ui.panels.cell.point_search import PointSearch, Pose
from armui.ui.widgets.buttons import caption, enable_or_explain, named, push_button, show_primary
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.layouts import STRETCH, empty_grid, in_column, in_row
from armui.ui.widgets.text_label import text_label
from armui.ui.words.text import listed

_AXES: Final = ("+X", "−X", "+Y", "−Y", "+Z", "−Z")
_AS_BEFORE: Final = 0
_TWO_POINTS: Final = 1 + len(_AXES)


class TipByPoints(PointSearch):
    """Finds a tool's tip from poses that touch one point; see :class:`PointSearch`."""

    def __init__(self, controller: ArmController, answered: Answered) -> None:
        super().__init__(controller, answered, "tip")
        self._poses: list[Pose] = []
        self._before: Pose = NO_TOOL
        self._turn_poses: list[Pose | None] = [None, None]
        self.take = push_button("tip_take")
        self._rows: list[tuple[QCheckBox, QLabel, QPushButton]] = []
        self._grid = empty_grid(gaps=(8, 2), margins=0)
        self._limit_label = QLabel()
        self._limit = named("tip_limit", FigureField(2, "mm"))
        self._limit.show_value(DEFAULT_LIMIT_MM)
        self._limit_label.setBuddy(self._limit)
        self._turn_label = QLabel()
        self._turn = named("tip_orientation", QComboBox())
        self._turn.setMinimumWidth(NARROW_PX)
        self._turn_takes = [push_button(f"tip_turn_{number}") for number in (1, 2)]
        self._note = text_label("tip_note", rank="muted", wraps=True)
        self._lay_out()
        self.take.clicked.connect(self._on_take)
        self._limit.value_edited.connect(self._show)
        self._turn.activated.connect(self._on_turn_chosen)
        for place, button in enumerate(self._turn_takes):
            button.clicked.connect(partial(self._on_turn_taken, place))
        self.retranslate_ui()

    def _lay_out(self) -> None:
        for number in range(1, MOST_POSES + 1):
            used = named(f"tip_use_{number}", QCheckBox())
            used.setChecked(True)
            used.toggled.connect(lambda _on: self._show())
            residual = text_label(f"tip_residual_{number}")
            again = push_button(f"tip_again_{number}")
            again.setProperty("compact", True)
            again.clicked.connect(partial(self._on_again, number - 1))
            for column, widget in enumerate((used, residual, again)):
                self._grid.addWidget(widget, number, column)
                widget.hide()
            self._rows.append((used, residual, again))
        self._grid.setColumnStretch(1, 1)
        for button in (*self._turn_takes, self.take):
            button.setMinimumWidth(NARROW_PX)
        limit = in_row(self._limit_label, STRETCH, self._limit)
        turn = in_row(self._turn_label, (self._turn, 1))
        turn_takes = in_row(*((button, 1) for button in self._turn_takes), spacing=6)
        ends = in_row((self._apply, 1), (self._restart, 1), spacing=6)
        rows: QGridLayout = self._grid
        first = (self._next, self._live, self.take, turn_takes, self._result, ends)
        in_column(*first, rows, turn, limit, self._note, STRETCH, on=self, spacing=6, margins=0)

    # -- actions ------------------------------------------------------------------------------

    def _on_take(self) -> None:
        self._captured(self._poses.append)

    def _on_again(self, place: int) -> None:
        def replace_pose(pose: Pose) -> None:
            self._poses[place] = pose

        self._captured(replace_pose)

    def _on_turn_taken(self, place: int) -> None:
        def keep(pose: Pose) -> None:
            self._turn_poses[place] = pose

        self._captured(keep)

    def _on_turn_chosen(self) -> None:
        self._turn_poses = [None, None]
        self._show()

    def restart(self) -> None:
        """Forget the poses taken so far."""
        self._poses.clear()
        self._turn_poses = [None, None]
        for used, _residual, _again in self._rows:
            used.setChecked(True)
        self._show()

    # -- results ------------------------------------------------------------------------------

    @property
    def _used(self) -> list[int]:
        return [place for place in range(len(self._poses)) if self._rows[place][0].isChecked()]

    def fit(self) -> TipFit | Refusal:
        """Return the tip given by the poses in use, or why they are too few."""
        return find_tip([self._poses[place] for place in self._used])

    def found(self) -> Pose | Refusal:
        """Return the pose of the tool that may be applied, or why there is none."""
        fit = self.fit()
        if isinstance(fit, Refusal):
            return fit
        refusal = fit.refusal(self._limit.value or DEFAULT_LIMIT_MM)
        if refusal is not None:
            figure = refusal.params.get("pose")
            # the fit numbers only the poses in use, but the operator sees the numbers of all
            if isinstance(figure, int):
                pose = self._used[figure - 1] + 1
                return Refusal(refusal.reason, {**refusal.params, "pose": pose})
            return refusal
        turned = self._orientation(fit)
        return turned if isinstance(turned, Refusal) else (*fit.tip_mm, *turned)

    def _orientation(self, fit: TipFit) -> Pose | Refusal:
        chosen = self._turn.currentIndex()
        first, second = self._turn_poses
        if chosen == _TWO_POINTS and first is not None and second is not None:
            return by_two_points(fit, first, second)
        if _AS_BEFORE < chosen < _TWO_POINTS and first is not None:
            shown = self._controller.cartesian.in_frame(first)
            return along_axis(shown, (chosen - 1) // 2, 1 if chosen % 2 else -1)
        return self._before[3:]

    @property
    def _turn_missing(self) -> bool:
        chosen = self._turn.currentIndex()
        needed = 0 if chosen == _AS_BEFORE else 2 if chosen == _TWO_POINTS else 1
        return None in self._turn_poses[:needed]

    # -- appearance ---------------------------------------------------------------------------

    def show_chosen(self, chosen: Any, why_not: str) -> None:
        """Show for which tool it is."""
        self._before, self._why_not = NO_TOOL if chosen is None else chosen.pose, why_not
        self._name_axes()
        self._show()

    def show_live(self) -> None:
        """Show how the arm's present pose differs from those taken; called while it moves."""
        refusal = self._controller.cell.why_not_capture()
        full = self.tr("No more than {count} poses are taken. Take one of them again.")
        why_not = words.why_not(refusal)
        if len(self._poses) == MOST_POSES:
            why_not = why_not or full.format(count=MOST_POSES)
        use = self.tr("Takes the measured pose; nothing moves.")
        enable_or_explain(self.take, why_not, use)
        anew = self.tr("Puts the measured pose in the place of this one.")
        for _used, _residual, again in self._rows[: len(self._poses)]:
            enable_or_explain(again, words.why_not(refusal), anew)
        for button in self._turn_takes:
            enable_or_explain(button, words.why_not(refusal), use)
        self._live.setText(self._live_text(refusal))

    def _live_text(self, refusal: Refusal | None) -> str:
        if refusal is not None:
            return self._why_no_pose(refusal)
        pose = self._controller.state.end_pose()
        if pose is None or not self._poses:
            return ""
        turned = turned_from_deg(pose, [self._poses[place] for place in self._used])
        text = self.tr("{turned}° from the nearest pose taken; {wanted}° or more are wanted.")
        return text.format(turned=fmt.number(turned, 1), wanted=round(WANTED_DEG))

    def _show(self) -> None:
        fit, found = self.fit(), self.found()
        used = self._used
        for place, (box, residual, again) in enumerate(self._rows):
            taken = place < len(self._poses)
            for widget in (box, residual, again):
                widget.setVisible(taken)
            if not taken:
                continue
            value = None
            if not isinstance(fit, Refusal) and place in used:
                value = fit.residuals_mm[used.index(place)]
            residual.setText(fmt.with_unit(value, "mm"))
        self._result.setText(self._result_text(fit, found))
        chosen = self._turn.currentIndex()
        self._turn_takes[0].setVisible(chosen != _AS_BEFORE)
        self._turn_takes[1].setVisible(chosen == _TWO_POINTS)
        two = chosen == _TWO_POINTS
        caption(self._turn_takes[0], self.tr("On the shank") if two else self.tr("It points so"))
        ready = not isinstance(found, Refusal) and not self._turn_missing
        reason = words.refusal(found) if isinstance(found, Refusal) else ""
        missing = self.tr("The orientation is not taken yet.") if self._turn_missing else ""
        use = self.tr("Puts the tip found in force, in the place of what was.")
        enable_or_explain(self._apply, self._why_not or reason or missing, use)
        new = ready and self._spread_is_enough and not self._is_in_force(found)
        show_primary(self._apply, wanted=new and not self._why_not)
        more = not ready or not self._spread_is_enough
        show_primary(self.take, wanted=more and self._controller.cell.cell is not None)
        self._restart.setEnabled(bool(self._poses))
        self._next.setText(self._next_step(found))
        self.show_live()

    @property
    def _spread_is_enough(self) -> bool:
        poses = [self._poses[place] for place in self._used]
        return len(poses) >= LEAST_POSES and spread(poses).is_enough

    def _next_step(self, found: Pose | Refusal) -> str:
        poses = [self._poses[place] for place in self._used]
        if self._controller.cell.cell is None:
            return words.refusal(CELL_NONE())
        if not poses:
            return self.tr(
                "Fix a sharp point in front of the arm. Bring the tool's tip onto it (by Jog "
                "above, or lead the arm by hand), and press Take pose."
            )
        if len(poses) < LEAST_POSES or not self._spread_is_enough:
            turn = self._which_turn(poses)
            text = self.tr("Pose {count} of at least {least} is taken. {turn}")
            return text.format(count=len(poses), least=LEAST_POSES, turn=turn)
        if isinstance(found, Refusal):
            return words.refusal(found)
        if self._turn_missing:
            return self._turn_step()
        if self._is_in_force(found):
            return self.tr("The tip found is in force. Start again for another tool.")
        return self.tr("Compare what was found with what was, then press Apply the tip.")

    def _turn_step(self) -> str:
        if self._turn.currentIndex() != _TWO_POINTS:
            return self.tr("Turn the tool until it points along that axis; press It points so.")
        if self._turn_poses[0] is None:
            return self.tr("Touch the point with the shank behind the tip; press On the shank.")
        return self.tr("Touch the point with the side of the tool's X; press On the X side.")

    def _is_in_force(self, found: Pose | Refusal) -> bool:
        if isinstance(found, Refusal) or self._controller.cell.in_force is None:
            return False
        return tuple(round(each, fmt.DECIMALS) for each in found) == self._before

    def _which_turn(self, poses: list[Pose]) -> str:
        """Say how to turn next: about the two axes other than the one that was tilted least."""
        if len(poses) == 1:
            text = self.tr("Tilt the tool by {wanted}° or more, touch the point, take the pose.")
            return text.format(wanted=round(WANTED_DEG))
        known = spread(poses)
        about = {"X": "Y, Z", "Y": "X, Z", "Z": "X, Y"}[known.axis]
        text = self.tr(
            "The flange's {axis} axis has pointed {turned}° apart so far: turn about {about} by "
            "{wanted}° or more, touch the point, take the pose."
        )
        return text.format(
            axis=known.axis,
            turned=fmt.number(known.turned_deg, 1),
            about=listed(about.split(", ")),
            wanted=round(WANTED_DEG),
        )

    def _result_text(self, fit: TipFit | Refusal, found: Pose | Refusal) -> str:
        if isinstance(fit, Refusal):
            return ""
        figures = self.tr(
            "RMS {rms} mm, largest {largest} mm, condition {condition}, {turned}° apart"
        ).format(
            rms=fmt.number(fit.rms_mm, 3),
            largest=fmt.number(fit.largest_mm, 3),
            condition=f"{fit.condition:.0f}",
            turned=fmt.number(fit.spread.turned_deg, 1),
        )
        if isinstance(found, Refusal):
            return f"{figures}\n{words.refusal(found)}"
        was = self.tr("Found: {found}\nBefore: {before}")
        return f"{figures}\n" + was.format(
            found=fmt.pose(found, 2), before=fmt.pose(self._before, 2)
        )

    def _name_axes(self) -> None:
        """Name the axes that the tool may point along: of the user frame in force, or the base."""
        frame = self._controller.cartesian.frame
        of_base = self.tr("it points along {axis} of the base")
        text = of_base if frame is None else self.tr("it points along {axis} of “{name}”")
        for place, axis in enumerate(_AXES, start=1):
            name = "" if frame is None else frame.name
            self._turn.setItemText(place, text.format(axis=axis, name=name))

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        caption(self.take, self.tr("Take pose"))
        for number, (used, _residual, again) in enumerate(self._rows, start=1):
            pose = self.tr("Pose {number}").format(number=number)
            caption(used, pose)
            used.setToolTip(self.tr("Left out of the search while it is not ticked"))
            caption(again, self.tr("Again"), whose=pose)
        self._limit_label.setText(self.tr("Largest residual allowed"))
        self._limit.setAccessibleName(self.tr("Largest residual allowed"))
        self._turn_label.setText(self.tr("Orientation"))
        self._turn.setAccessibleName(self.tr("Orientation"))
        chosen = max(0, self._turn.currentIndex())
        self._turn.clear()
        self._turn.addItem(self.tr("as before"))
        self._turn.addItems(_AXES)
        self._name_axes()
        self._turn.addItem(self.tr("by two more points"))
        self._turn.setCurrentIndex(chosen)
        caption(self._turn_takes[1], self.tr("On the X side"))
        caption(self._apply, self.tr("Apply the tip"))
        caption(self._restart, self.tr("Start again"))
        self._note.setText(
            self.tr("The residual says how well the poses fit, not how true the tool is.")
        )
        self._show()
