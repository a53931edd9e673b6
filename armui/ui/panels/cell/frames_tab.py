"""The tab of the user frames: by three points or typed, chosen, renamed and deleted."""

from __future__ import annotations

from collections.abc import Sequence

from armui.arm.state import ArmState
from armui.cell.placement import WORLD
from armui.cell.user_frames import UserFrame
from armui.control.arm_controller import ArmController
from armui.ui.actions.act import Act
from armui.ui.actions.command import Command
from armui.ui.panels.cell.cell_tab import Answered, figures
from armui.ui.panels.cell.frame_by_points import FrameByPoints
from armui.ui.panels.cell.named_tab import CellItem, ForceTab, NamedTab, TabTexts
from armui.ui.widgets.text_label import text_label
from armui.ui.words.text import Text


class FramesTab(ForceTab):
    """The user frames of the chosen cell; see :class:`NamedTab`."""

    key = "frames"
    part = "frame"
    kind = UserFrame
    title = Text("CellPanel", "Frames")
    commands = (
        Command("cell.frame", Text("FramesTab", "Frame in force")),
        Command("cell.frame_by_points", Text("FramesTab", "Frame by three points")),
    )
    changes = NamedTab.changes_of(
        "frame",
        apply=Text("FramesTab", "Apply the figures of the frame"),
        add=Text("FramesTab", "Add as a new frame"),
        delete=Text("FramesTab", "Delete the frame"),
    )
    here = Act(
        "From the present tool pose",
        named="cell_frame_here",
        tip="Fills in the present tool pose, with the axes of the tool.",
        key="cell.frame_here",
        title=Text("FramesTab", "Frame from the present tool pose"),
    )
    here.pressed(NamedTab.take_tool_pose)
    here.why_not(NamedTab.why_no_tool_pose)

    def __init__(self, controller: ArmController, answered: Answered) -> None:
        super().__init__(controller, answered, FrameByPoints(controller, answered))
        self._of_base = text_label("cell_frame_of_base", rank="muted", wraps=True)
        self._lay_out(below=[self._of_base, self.here])
        self.retranslate_ui()

    def typed(self) -> UserFrame:
        """Return the frame as typed; an empty field counts as 0, a text as itself."""
        return UserFrame(self._name.text().strip(), figures(self._fields))

    @property
    def _items(self) -> Sequence[CellItem]:
        return self._cell.all_frames

    def _fixed(self) -> str:
        if self._chosen != WORLD:
            return ""
        return self.tr("It is the room's: it moves with the figures under Base.")

    def show_state(self, state: ArmState) -> None:
        """Show whether the present tool pose can be filled in."""
        super().show_state(state)
        FramesTab.here.show(self)

    def _next_step(self, *, new: bool, changed: bool) -> str:
        if self._fixed() and not new:
            return self._fixed()
        if new:
            return self.tr("Press Add for a further frame, or Apply: the chosen one gets these.")
        if self._item is None:
            return self.tr(
                "Press By three points, or type a name and the frame's pose in the base, then "
                "press Add."
            )
        if changed:
            return self.tr("Press Apply: the frame moves, and what belongs to it moves with it.")
        return self.tr("Poses are shown and typed in this frame. Choose another one, or the base.")

    def _texts(self) -> TabTexts:
        return TabTexts(
            kind=self.tr("Frame"),
            choice=self.tr("Frame in force"),
            name=self.tr("Frame's name"),
            none=self.tr("— (base)"),
            missing=self.tr("No frame is chosen. Add one, or choose one above."),
            apply=self.tr(
                "Puts these figures in the place of those of the chosen frame. Points of "
                "trajectories that belong to it move with it; their way is checked anew."
            ),
            add=[self.tr("Adds a frame of this name; it is in force once it is chosen.")],
            delete=self.tr(
                "Deletes the chosen frame; the base is chosen then. Trajectories with points that "
                "belong to it are not run until they have another frame."
            ),
        )

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._name_ways(self.tr("Type it"), self.tr("By three points"))
        self._of_base.setText(self.tr("The frame's own pose, in the base (mm, °)"))
        super().retranslate_ui()
