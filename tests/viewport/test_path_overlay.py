"""Numbers of points and signs of findings, and the tool's way, pixel by pixel."""

import dataclasses
import time
from array import array
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt

from armui.viewport.camera import HOME_CAMERA, OrbitCamera
from armui.viewport.palette import LIGHT, rgb
from armui.viewport.path_overlay import finding_at, signs, tags
from armui.viewport.path_picture import NOTHING, FindingMark, PathPicture, Preview, Trail
from armui.viewport.projection import Projection
from tests.viewport.pinhole import HEIGHT, WIDTH, project
from tests.viewport.test_views import pixels

LIMIT_MS = 50_000
CORNERS_MM = np.array([[300.0, -300.0, 400.0], [300.0, 300.0, 400.0], [300.0, 300.0, 100.0]])
ERROR = FindingMark((250.0, 150.0, 300.0), True, 1, "too far")
WARNING = FindingMark((250.0, -150.0, 300.0), False, 2, "fast")
PROJECTION = Projection(HOME_CAMERA, WIDTH, HEIGHT)
REST = (0.0,) * 6


def path(marks_mm=CORNERS_MM, findings=(), bad_rows=frozenset(), numbered=True):
    marks = np.asarray(marks_mm, float)
    rows = tuple(range(len(marks)))
    return PathPicture(marks, np.ones(len(marks)), marks, rows, bad_rows, findings, numbered)


@pytest.mark.parametrize("orthographic", [False, True])
def test_a_number_stands_at_its_point(orthographic):
    camera = OrbitCamera(HOME_CAMERA.focus_m, 1.7, orthographic=orthographic)
    projection = Projection(camera, WIDTH, HEIGHT)
    for tag, corner in zip(tags(path(), projection), CORNERS_MM, strict=True):
        x, y, z = corner / 1000.0
        assert (tag.x_px, tag.y_px) == pytest.approx(projection.pixel((x, y, z)))


def test_numbers_that_cannot_be_read_are_left_out_but_never_those_that_matter():
    crowd = np.array([300.0, 0.0, 300.0]) + np.linspace(0.0, 30.0, 500)[:, None]
    few = tags(path(crowd), PROJECTION)
    assert 1 <= len(few) < 12
    chosen = tags(path(crowd, bad_rows=frozenset({250})), PROJECTION, frozenset({251}))
    assert {250} <= {tag.row for tag in chosen} or {251} <= {tag.row for tag in chosen}


def test_samples_of_a_recording_have_no_numbers():
    assert tags(path(numbered=False), PROJECTION) == []


def test_ten_thousand_points_are_numbered_in_the_time_of_a_picture():
    rng = np.random.default_rng(2)
    many = path(rng.uniform(-600.0, 600.0, (10_000, 3)))
    tags(many, PROJECTION)
    began_s = time.process_time()
    found = tags(many, PROJECTION)
    assert time.process_time() - began_s < 0.1  # some 5 ms here; a loop would take seconds
    assert 10 < len(found) <= 120


def test_the_sign_of_a_finding_is_found_where_it_happens():
    shown = path(findings=(ERROR, WARNING))
    assert [sign.finding for sign in signs(shown, PROJECTION)] == [WARNING, ERROR]
    for mark in (ERROR, WARNING):
        x, y = project(np.array([mark.place_mm]) / 1000.0)[0]
        assert finding_at(shown, PROJECTION, x + 8.0, y - 8.0) == mark
        assert finding_at(shown, PROJECTION, x + 40.0, y) is None


def test_what_happens_outside_of_the_picture_has_its_sign_at_the_rim():
    far = FindingMark((1200.0, 900.0, 300.0), True, 1, "too far")
    shown = path(findings=(far, WARNING))
    inside, outside = signs(shown, PROJECTION)
    assert inside.beyond is None
    x, y = project(np.array([far.place_mm]) / 1000.0)[0]
    assert not (0.0 < x < WIDTH and 0.0 < y < HEIGHT)
    assert 0.0 < outside.x_px < WIDTH
    assert 0.0 < outside.y_px < HEIGHT
    assert outside.beyond is not None
    way = np.array([x - outside.x_px, y - outside.y_px])
    assert outside.beyond == pytest.approx(tuple(way / np.linalg.norm(way)))
    assert finding_at(shown, PROJECTION, outside.x_px, outside.y_px) == far


def test_what_happens_behind_the_eye_has_its_sign_at_the_rim_too():
    behind = FindingMark((2500.0, -900.0, 300.0), True, 1, "too far")
    (sign,) = signs(path(findings=(behind,)), PROJECTION)
    assert PROJECTION.pixel((2.5, -0.9, 0.3)) is None
    assert sign.beyond is not None
    across, _, _ = PROJECTION.relative((2.5, -0.9, 0.3))
    assert sign.beyond[0] * across > 0.0


def test_what_cannot_be_reached_makes_the_arm_no_smaller():
    marks = np.vstack((CORNERS_MM, [[2000.0, 0.0, 100.0]]))
    shown = path(marks, findings=(FindingMark((3000.0, 0.0, 0.0), True, 3, ""),))
    shown = dataclasses.replace(shown, places_mm=CORNERS_MM, bad_rows=frozenset({3}))
    assert np.abs(shown.outermost_m()).max() == pytest.approx(0.4)


def test_of_two_findings_at_a_place_the_error_is_on_top():
    warning = FindingMark(ERROR.place_mm, False, 4, "also")
    x, y = project(np.array([ERROR.place_mm]) / 1000.0)[0]
    assert finding_at(path(findings=(ERROR, warning)), PROJECTION, x, y) == ERROR


def test_a_click_on_a_sign_tells_the_finding_and_asks_the_process_nothing(view, qtbot):
    view.set_joints(REST, 0.0)
    view.set_preview(Preview(path(findings=(ERROR, WARNING))))
    view.fit()
    qtbot.wait_until(lambda: view.is_settled, timeout=LIMIT_MS)
    marks: list[Any] = []
    view.mark_picked.connect(marks.append)
    for mark in (ERROR, WARNING):
        x, y = project(np.array([mark.place_mm]) / 1000.0, view.camera)[0]
        asked = view._state.mark_pick
        with qtbot.waitSignal(view.finding_picked, timeout=LIMIT_MS) as picked:
            qtbot.mouseClick(view, Qt.MouseButton.LeftButton, pos=QPoint(round(x), round(y)))
        assert picked.args == [mark]
        assert view._state.mark_pick is asked
    assert marks == []
    view.mark_picked.disconnect(marks.append)


def test_signs_and_numbers_are_painted_where_they_are_and_go_with_the_path(view, qtbot):
    view.set_joints(REST, 0.0)
    view.set_preview(Preview(path(findings=(ERROR,), numbered=False)))
    view.fit()
    qtbot.wait_until(lambda: view.is_settled, timeout=LIMIT_MS)
    shown = pixels(view.grab().toImage())
    x, y = project(np.array([ERROR.place_mm]) / 1000.0, view.camera)[0]
    red = np.array(rgb(LIGHT.fault)) * 255.0

    def around(image):
        return np.abs(image[round(y) - 9 : round(y) + 10, round(x) - 9 : round(x) + 10] - red)

    assert (around(shown).max(axis=2) < 30).mean() > 0.3
    camera = view.camera
    view._look_through(camera.zoom(0.001))  # the picture stays, with the path and without it
    view.set_preview(NOTHING)
    qtbot.wait_until(lambda: view.is_settled, timeout=LIMIT_MS)
    assert view.camera.distance_m == pytest.approx(camera.distance_m, rel=1e-3)
    assert not (around(pixels(view.grab().toImage())).max(axis=2) < 30).any()


def color_at(scene, place_mm):
    shown = scene.render(smooth=False).top_down()[:, :, :3].astype(int)
    column, row = np.round(project(np.array([place_mm]) / 1000.0)[0]).astype(int)
    return shown[row, column]


def packed(*places):
    return array("f", [figure for place in places for figure in place]).tobytes()


def test_the_trail_is_a_line_that_fades_towards_its_old_end(scene):
    places = [(300.0, y, 400.0) for y in np.linspace(-300.0, 300.0, 60)]
    scene._trail.show(Trail(packed(*places), b""), LIGHT, 1.0)
    ground = np.array(rgb(LIGHT.background)) * 255.0
    old, new = (np.abs(color_at(scene, places[at]) - ground).sum() for at in (4, 56))
    assert new > 2.0 * old > 10.0
    assert np.abs(color_at(scene, places[57]) - np.array(rgb(LIGHT.driven)) * 255.0).max() < 40
    scene._trail.show(None, LIGHT, 1.0)
    assert np.abs(color_at(scene, places[56]) - ground).max() < 20


def test_what_was_commanded_has_a_line_of_its_own(scene):
    places = [(300.0, y, 400.0) for y in np.linspace(-300.0, 300.0, 60)]
    scene._trail.show(Trail(b"", packed(*places)), LIGHT, 2.0)
    assert np.abs(color_at(scene, places[58]) - np.array(rgb(LIGHT.commanded)) * 255.0).max() < 60


def test_the_point_under_way_is_lit_and_no_other(scene):
    shown = Preview(path())
    scene.set_preview(shown)
    assert np.abs(color_at(scene, CORNERS_MM[1]) - np.array(rgb(LIGHT.accent)) * 255.0).max() < 30
    scene.set_preview(Preview(shown.path, current_row=1))
    ring = CORNERS_MM[1] + np.array([0.0, 0.0, 22.0])  # beside the mark, within its ring
    assert np.abs(color_at(scene, ring) - np.array(rgb(LIGHT.current)) * 255.0).max() < 60
    scene.set_preview(shown)
    ground = np.array(rgb(LIGHT.background)) * 255.0
    assert np.abs(color_at(scene, ring) - ground).max() < 60


def test_the_gravest_of_many_findings_have_their_signs_on_top():
    """They come gravest first: a contact before other warnings."""
    contacts = [FindingMark((300.0 + at, 0.0, 300.0), False, at, "contact") for at in range(100)]
    others = [FindingMark((300.0 + at, 50.0, 300.0), False, at, "other") for at in range(100)]
    found = signs(path(findings=(*contacts, *others)), PROJECTION)
    assert sum(each.finding.text == "contact" for each in found) == 100
    one, other = contacts[0], FindingMark(contacts[0].place_mm, False, 6, "other")
    at = signs(path(findings=(one, other)), PROJECTION)[0]
    assert finding_at(path(findings=(one, other)), PROJECTION, at.x_px, at.y_px) is one
