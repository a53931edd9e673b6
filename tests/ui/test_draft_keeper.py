"""When the editor's unsaved changes are written."""

from dataclasses import replace

from armui.protocol.codes import MoveMode
from armui.trajectory.library import Library
from armui.trajectory.program import Trajectory, Waypoint
from armui.ui.trajectory.document import Document
from armui.ui.trajectory.draft_keeper import DraftKeeper

POINT = Waypoint(MoveMode.MOVE_J, (0.0,) * 6)


def test_a_draft_waits_for_a_pause_in_the_edits(qtbot, tmp_path):
    library = Library(tmp_path)
    trajectory = Trajectory("Test", points=(POINT,))
    library.save(trajectory)
    document = Document(trajectory)
    keeper = DraftKeeper(document, library)
    for speed in (10, 20, 30):
        document.edit((replace(POINT, speed_percent=speed + 1),), "edit")
        assert keeper._timer.isActive()
        assert keeper._timer.remainingTime() > 500
    assert library.drafts() == []
    qtbot.waitUntil(lambda: library.drafts() == ["Test"])
