"""The arm fills the room it has, and stands neither outside nor behind the figures."""

import numpy as np
import pytest

from armui.system.paths import URDF
from armui.viewport.area_picture import AreaShape, corners
from armui.viewport.camera import HOME_CAMERA, OrbitCamera, ViewDirection
from armui.viewport.fitting import (
    MARGIN_PX,
    Box,
    Room,
    ball_around,
    fitted,
    is_ball_clear,
    is_clear,
)
from armui.viewport.process.robot import shape_of
from armui.viewport.process.urdf_file import load_robot
from armui.viewport.projection import Projection
from armui.viewport.viewpoint import ViewMode, Viewpoint

FIGURES = Box(0.0, 0.0, 260.0, 160.0)
REST, UPRIGHT = (0.0,) * 6, (0.0, 90.0, -88.0, 0.0, -70.0, 0.0)
STRETCHED = (0.0, 95.0, -95.0, 0.0, 0.0, 0.0)
SIZES = [(840, 660), (420, 760), (1300, 500), (560, 560), (300, 420)]


@pytest.fixture(scope="module")
def shape():
    return shape_of(load_robot(URDF / "piper" / "piper.urdf"))


def room_of(size):
    width, height = size
    return Room(width, height, FIGURES, 44.0)


def extent(camera, groups, room):
    """The box of everything, in pixels."""
    projection = Projection(camera, room.width_px, room.height_px)
    xs, ys = zip(*(projection.pixel(place) for group in groups for place in group), strict=True)
    return Box(min(xs), min(ys), max(xs), max(ys))


@pytest.mark.each_pair(full="all directions, poses and sizes together")
@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("pose", [REST, UPRIGHT, STRETCHED])
@pytest.mark.parametrize("direction", ViewDirection)
@pytest.mark.parametrize("orthographic", [False, True])
def test_the_whole_arm_is_in_the_room_and_touches_its_edge(
    shape, size, pose, direction, orthographic
):
    room = room_of(size)
    groups = shape.outline(shape.links(pose))
    looking = OrbitCamera((0.0, 0.0, 0.0), 1.0, orthographic=orthographic).turned_to(direction)
    camera = fitted(looking, groups, room)
    assert is_clear(camera, groups, room, slack_px=1.5)
    box, inside = extent(camera, groups, room), room.inside
    # as near as it can be: in one direction nothing is left, of the room or of what is beside
    # the figures
    left_over = (
        min(inside.right - inside.left, inside.right - FIGURES.right) - (box.right - box.left),
        min(inside.bottom - inside.top, inside.bottom - FIGURES.bottom) - (box.bottom - box.top),
    )
    assert min(left_over) < 12.0  # some air


def test_half_of_the_picture_and_more_is_the_arm_s(shape):
    """It was a third of the height."""
    room = room_of((840, 660))
    groups = shape.outline(shape.links(STRETCHED))
    box = extent(fitted(HOME_CAMERA, groups, room), groups, room)
    assert box.bottom - box.top > 0.55 * room.height_px or box.right - box.left > 0.55 * 840


def test_something_that_is_nowhere_moves_no_camera():
    assert fitted(HOME_CAMERA, [], room_of((800, 600))) == HOME_CAMERA


class Looking:
    """A viewpoint before the program's arm."""

    def __init__(self, shape):
        self.viewpoint = Viewpoint()
        self.viewpoint.set_shape(shape)
        self.room = room_of((840, 660))
        self.viewpoint.set_room(self.room)
        self.shape = shape

    def move(self, pose):
        self.viewpoint.set_arm(pose, 0.0, None)
        return self.viewpoint.camera

    def sees(self, pose):
        groups = self.shape.outline(self.shape.links(pose))
        return is_clear(self.viewpoint.camera, groups, self.room, MARGIN_PX)


@pytest.fixture
def looking(shape):
    return Looking(shape)


@pytest.mark.parametrize("size", SIZES)
def test_the_letters_of_the_base_are_in_the_room_too(looking, size):
    """They stand 165 mm out, 1.1 times as far as the arrows go, and are 30 mm wide."""
    room = room_of(size)
    looking.viewpoint.set_room(room)
    letters = [[(0.18, 0.0, 0.0)], [(0.0, 0.18, 0.0)]]
    assert is_clear(looking.viewpoint.camera, letters, room, slack_px=1.5)


def test_the_camera_rests_while_the_arm_is_in_the_picture_and_steps_back_when_it_leaves(looking):
    at_rest = looking.move(REST)
    assert looking.move((1.0, *REST[1:])) == at_rest
    looking.move(STRETCHED)
    assert looking.viewpoint.camera != at_rest
    assert looking.sees(STRETCHED)
    back = looking.viewpoint.camera
    assert looking.move(REST) == back  # not to and fro with each motion
    looking.viewpoint.come_to_rest()
    assert looking.viewpoint.camera.distance_m < back.distance_m
    assert looking.sees(REST)


@pytest.mark.parametrize(
    "by_hand",
    [
        lambda camera: camera.orbit(70.0, 60.0),
        lambda camera: camera.pan(40.0, 10.0, 500.0),
        lambda camera: camera.zoom(3.0),
    ],
)
def test_what_the_operator_has_moved_stays_until_a_view_is_chosen(looking, by_hand):
    moved = by_hand(looking.viewpoint.camera)
    looking.viewpoint.hold(held=True)
    looking.viewpoint.move_by_hand(moved)
    looking.viewpoint.hold(held=False)
    assert looking.move(STRETCHED) == moved
    looking.viewpoint.come_to_rest()
    looking.viewpoint.set_room(room_of((500, 500)))
    assert looking.viewpoint.camera == moved
    looking.viewpoint.look_from(ViewDirection.SIDE)
    looking.room = room_of((500, 500))
    assert looking.sees(STRETCHED)


def test_nothing_moves_the_camera_under_the_operator_s_hand(looking):
    held = looking.viewpoint.camera
    looking.viewpoint.hold(held=True)
    assert looking.move(STRETCHED) == held
    looking.viewpoint.hold(held=False)
    assert looking.sees(STRETCHED)


def test_a_ghost_and_a_path_are_shown_with_the_arm(looking):
    looking.viewpoint.set_arm(REST, 0.0, STRETCHED)
    assert looking.sees(STRETCHED)
    looking.viewpoint.set_places(((0.0, 0.9, 0.1),))
    pixel = Projection(looking.viewpoint.camera, 840, 660).pixel((0.0, 0.9, 0.1))
    assert pixel is not None
    assert 0.0 < pixel[0] < 840.0
    assert 0.0 < pixel[1] < 660.0


def test_a_forbidden_box_is_shown_with_the_arm(looking):
    rows = (1.0, 0.0, 0.0, -0.2, 0.0, 1.0, 0.0, 0.9, 0.0, 0.0, 1.0, 0.1)
    held, plane = AreaShape(rows, (90.0,) * 3, held=True), AreaShape(rows)
    assert list(corners((held, plane))) == []
    box = AreaShape(rows, (200.0, 300.0, 200.0))
    at_m = tuple(corners((box,)))
    assert len(set(at_m)) == 8
    assert (-0.1, 1.05, 0.2) in [tuple(round(each, 6) for each in place) for place in at_m]
    before = looking.viewpoint.camera
    looking.viewpoint.set_boxes(at_m)
    assert looking.viewpoint.camera == before, "the arm stays large until it is asked for"
    looking.viewpoint.fit()
    assert is_clear(looking.viewpoint.camera, [[place] for place in at_m], looking.room, 1.5)
    assert looking.sees(REST)
    endless = tuple(corners((AreaShape(rows, (200.0, 20_000.0, 200.0)),)))
    looking.viewpoint.set_boxes(endless)
    assert looking.viewpoint.camera.distance_m < 4.0 * before.distance_m
    looking.viewpoint.reset()
    assert looking.viewpoint.camera == before
    looking.viewpoint.set_boxes(at_m)
    looking.viewpoint.bring_in(at_m)
    assert is_clear(looking.viewpoint.camera, [[place] for place in at_m], looking.room, 1.5)
    seen = looking.viewpoint.camera
    looking.viewpoint.set_boxes(endless)
    assert looking.viewpoint.camera == seen, "no jump while one types or drags"


def test_following_keeps_the_tool_in_the_middle(looking, shape):
    looking.viewpoint.follow(wanted=True)
    for pose in (REST, STRETCHED):
        looking.move(pose)
        rows = shape.flange(shape.links(pose))
        assert looking.viewpoint.camera.focus_m == pytest.approx((rows[3], rows[7], rows[11]))
    looking.viewpoint.move_by_hand(looking.viewpoint.camera.orbit(30.0, 0.0))
    modes = [looking.viewpoint.mode]
    panned = looking.viewpoint.camera.pan(30.0, 0.0, 500.0)
    looking.viewpoint.move_by_hand(panned)
    modes.append(looking.viewpoint.mode)
    assert modes == [ViewMode.FOLLOW, ViewMode.FREE]


def test_a_press_that_moves_nothing_leaves_the_picture_fitting_the_arm(looking):
    looking.viewpoint.move_by_hand(looking.viewpoint.camera)
    assert looking.viewpoint.mode is ViewMode.FIT


def test_a_ball_that_is_clear_has_nothing_in_it_that_is_not():
    rng = np.random.default_rng(3)
    room, found = room_of((840, 660)), [0, 0]
    for _ in range(1500):
        away, turn, height = rng.uniform((0.4, -180.0, -89.0), (3.0, 180.0, 89.0))
        looking = OrbitCamera((0.0, 0.0, 0.2), away, turn, height, bool(rng.integers(2)))
        places = rng.uniform(-0.6, 0.6, 3) + rng.uniform(-0.2, 0.2, (12, 3))
        group = [(x, y, z) for x, y, z in places.tolist()]
        ball = ball_around(group)
        assert all(np.linalg.norm(places - ball.centre, axis=1) <= ball.radius_m + 1e-9)
        projection = Projection(looking, room.width_px, room.height_px)
        is_all_clear = is_clear(looking, [group], room)
        if is_ball_clear(projection, ball, room, 0.0):
            assert is_all_clear
            found[0] += 1
        found[1] += is_all_clear
    assert found[0] > 0.3 * found[1] > 30  # and it is of use


def test_whether_the_arm_is_in_the_picture_is_told_as_point_by_point(shape):
    looking = Viewpoint()
    looking.set_shape(shape)
    looking.set_room(room_of((840, 660)))
    rng = np.random.default_rng(4)
    told = []
    for angles in rng.uniform((-150, 0, -170, -90, -70, -90), (150, 180, 0, 90, 70, 90), (150, 6)):
        looking._poses = [(tuple(angles), 20.0)]
        told.append(looking._is_all_clear(shape))
        assert told[-1] == is_clear(looking.camera, looking._groups(), looking._room, 10.0)
    assert any(told)
    assert not all(told)
