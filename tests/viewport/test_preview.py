"""A path, its marks and a ghost beside the arm, pixel by pixel."""

from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt

from armui.system.paths import URDF
from armui.viewport.palette import DARK, LIGHT, rgb
from armui.viewport.path_picture import NOTHING, FindingMark, PathPicture, Preview
from armui.viewport.process.scene import Scene
from tests.viewport.pinhole import HEIGHT, WIDTH, project

LIMIT_MS = 50_000
REST = (0.0,) * 6
RAISED = (30.0, 70.0, -60.0, 20.0, 40.0, 10.0)
CORNERS_MM = np.array([[300.0, -300.0, 400.0], [300.0, 300.0, 400.0], [300.0, 300.0, 100.0]])


def path(bad_rows=frozenset()):
    """Two straight legs, slow at the beginning, fast at the end."""
    shares = np.linspace(0.0, 1.0, 50)[:, np.newaxis]
    legs = [CORNERS_MM[n] * (1 - shares) + CORNERS_MM[n + 1] * shares for n in (0, 1)]
    places = np.concatenate(legs)
    speeds = np.linspace(0.0, 250.0, len(places))
    return PathPicture(places, speeds, CORNERS_MM, (0, 1, 2), bad_rows)


def picture(scene):
    return scene.render(smooth=False).top_down()[:, :, :3].astype(int)


def changed(first, second):
    return np.abs(first - second).max(axis=2) > 8


def color_at(shown, place_mm):
    column, row = np.round(project(np.array([place_mm]) / 1000.0)[0]).astype(int)
    return shown[row, column]


def is_color(pixel, color, slack=30):
    return np.abs(pixel - np.array(rgb(color)) * 255.0).max() < slack


def test_a_path_is_a_line_coloured_by_speed(scene):
    before = picture(scene)
    scene.set_preview(Preview(path()))
    shown = picture(scene)
    slow, fast = (
        CORNERS_MM[0] * 0.9 + CORNERS_MM[1] * 0.1,
        CORNERS_MM[1] * 0.1 + CORNERS_MM[2] * 0.9,
    )
    assert is_color(color_at(shown, slow), LIGHT.speeds[0], slack=60)
    assert is_color(color_at(shown, fast), LIGHT.speeds[1], slack=60)
    scene.set_preview(NOTHING)
    assert not changed(before, picture(scene)).any()


def test_points_are_marks_and_the_selected_one_stands_out(scene):
    scene.set_preview(Preview(path(bad_rows=frozenset({2}))))
    shown = picture(scene)
    assert is_color(color_at(shown, CORNERS_MM[0]), LIGHT.accent)
    assert is_color(color_at(shown, CORNERS_MM[2]), LIGHT.fault)
    scene.set_preview(Preview(path(bad_rows=frozenset({2})), selected_row=1))
    assert is_color(color_at(picture(scene), CORNERS_MM[1]), LIGHT.text)


def test_marks_take_the_colours_of_a_theme(scene):
    scene.set_preview(Preview(path()))
    scene.set_palette(DARK)
    assert is_color(color_at(picture(scene), CORNERS_MM[0]), DARK.accent)


def test_a_ghost_shines_through_where_no_arm_is(scene):
    before = picture(scene)
    scene.set_preview(Preview(ghost_deg=RAISED))
    with_ghost = picture(scene)
    assert changed(before, with_ghost).sum() > 1000
    scene.set_preview(Preview(ghost_deg=REST))
    assert changed(with_ghost, picture(scene)).any()
    scene.set_preview(NOTHING)
    assert not changed(before, picture(scene)).any()


def test_the_ghost_shows_only_what_of_it_stands_elsewhere(scene):
    """Its base stands in the arm's: two surfaces in one place flicker."""

    def seen():
        return {link for link, actor, _ in scene._ghost._parts if actor.GetVisibility()}

    scene.set_joints(REST, 0.0)
    scene.set_preview(Preview(ghost_deg=(*REST[:4], 40.0, 0.0)))
    beyond = {"link5", "link6", "gripper_base", "finger_left", "finger_right"}
    assert seen() <= beyond
    assert {"link5", "gripper_base"} <= seen()
    scene.set_joints((10.0, *REST[1:]), 0.0)  # the arm has left all but its base
    assert {"link1", "link2", "link5"} <= seen()
    assert "base_link" not in seen()


@pytest.mark.parametrize("is_error", [True, False])
def test_the_links_that_touch_have_the_colour_of_their_finding(scene, is_error):
    color = LIGHT.fault if is_error else LIGHT.warning

    def tinted():
        shown = picture(scene)
        far = np.abs(shown - np.array(rgb(color)) * 255.0).max(axis=2)
        return int((far < 70.0).sum())

    scene.set_joints(REST, 0.0)
    scene.set_preview(Preview(ghost_deg=RAISED))
    before = tinted()
    finding = FindingMark((0.0, 0.0, 0.0), is_error, None, "", RAISED, (0, 2))
    scene.set_preview(Preview(ghost_deg=RAISED, finding=finding))
    assert tinted() > before + 500
    seen = {link for link, actor, _ in scene._ghost._parts if actor.GetVisibility()}
    assert "base_link" in seen, "where the arm's own base stands, too"
    scene.set_preview(Preview(ghost_deg=RAISED))
    assert tinted() == before


def test_a_ghost_is_no_arm_to_pick(scene):
    raised = Scene(WIDTH, HEIGHT)
    raised.load(URDF / "piper" / "piper.urdf")
    raised.set_joints(RAISED, 0.0)
    columns, rows = np.meshgrid(np.arange(0, WIDTH, 20), np.arange(0, HEIGHT, 20))
    places = [
        place
        for place in zip(columns.ravel(), rows.ravel(), strict=True)
        if raised.pick(*map(float, place)) is not None and scene.pick(*map(float, place)) is None
    ]
    raised.close()
    scene.set_preview(Preview(ghost_deg=RAISED))
    assert len(places) > 3
    assert {scene.pick(*map(float, place)) for place in places} == {None}


def test_a_mark_is_found_by_a_click_beside_it(scene):
    scene.set_preview(Preview(path()))
    for row, pixel in enumerate(project(CORNERS_MM / 1000.0)):
        assert scene.pick_mark(pixel[0] + 6.0, pixel[1] - 6.0) == row
        assert scene.pick_mark(pixel[0] + 30.0, pixel[1] + 30.0) is None
    scene.set_preview(NOTHING)
    assert scene.pick_mark(*project(CORNERS_MM[:1] / 1000.0)[0]) is None


def test_a_click_on_a_mark_tells_its_row_and_a_drag_does_not(view, qtbot):
    view.set_joints(REST, 0.0)
    view.set_preview(Preview(path()))
    view.fit()
    place = project(CORNERS_MM[1:2] / 1000.0, view.camera)[0]
    at = QPoint(*np.round(place).astype(int).tolist())
    with qtbot.waitSignal(view.mark_picked, timeout=LIMIT_MS) as picked:
        qtbot.mouseClick(view, Qt.MouseButton.LeftButton, pos=at)
    assert picked.args == [1]
    rows: list[Any] = []
    view.mark_picked.connect(rows.append)
    qtbot.mousePress(view, Qt.MouseButton.LeftButton, pos=at - QPoint(60, 0))
    qtbot.mouseRelease(view, Qt.MouseButton.LeftButton, pos=at)
    qtbot.mouseClick(view, Qt.MouseButton.LeftButton, pos=at)
    qtbot.wait_until(lambda: rows != [], timeout=LIMIT_MS)
    assert rows == [1]
    view.mark_picked.disconnect(rows.append)
