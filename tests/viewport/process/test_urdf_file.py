"""Reading robot descriptions: ours, foreign ones, broken ones."""

import math
from typing import Any

import numpy as np
import pytest
import trimesh

from armui.arm.refusal import Reason, Refusal
from armui.system.paths import URDF
from armui.viewport.messages import URDF_MISSING, SceneError
from armui.viewport.process.robot import shape_of
from armui.viewport.process.urdf_file import (
    MESH_MISSING,
    URDF_JOINT_COUNT,
    URDF_MALFORMED,
    URDF_UNREADABLE,
    URDF_XACRO,
    load_robot,
)
from tests.viewport.foreign import joint, link, mesh, write_arm

BOX = '<visual><geometry><box size="0.1 0.2 0.3"/></geometry></visual>'


def refusal(path) -> Refusal:
    with pytest.raises(SceneError) as caught:
        load_robot(path)
    reason = caught.value.refusal
    assert reason.code.startswith(("urdf_", "mesh_"))
    return reason


def parts_of(robot, link: str) -> list[Any]:
    return [part for part in robot.parts if part.link == link]


def test_our_arm_has_its_joints_colours_and_meshes():
    robot = load_robot(URDF / "piper" / "piper.urdf")
    assert robot.root == "base_link"
    assert robot.arm_joints == tuple(f"joint{number}" for number in range(1, 7))
    shell, dark = parts_of(robot, "link2")
    committed: Any = trimesh.load(URDF / "piper" / "meshes" / "link2_shell.stl")
    np.testing.assert_allclose(shell.surface.triangles, committed.triangles)
    assert min(shell.color) > 0.9
    assert max(dark.color) < 0.3


def test_links_know_the_joint_that_moves_them():
    numbers = load_robot(URDF / "piper" / "piper.urdf").joint_numbers()
    assert "base_link" not in numbers
    assert [numbers[f"link{number}"] for number in range(1, 7)] == [1, 2, 3, 4, 5, 6]
    assert numbers["finger_left"] == 6


def test_zero_pose_of_the_flange():
    pose = load_robot(URDF / "piper" / "piper.urdf").link_poses([0.0] * 6, 0.0)["flange"]
    np.testing.assert_allclose(pose[:3, 3] * 1000.0, [56.128, 0.0, 213.266], atol=5e-4)


def test_fingers_part_by_the_opening_and_no_further_than_their_limit():
    robot = load_robot(URDF / "piper" / "piper.urdf")
    for opening_mm, expected_mm in ((0.0, 0.0), (40.0, 40.0), (90.0, 70.0)):
        poses = robot.link_poses([0.0] * 6, opening_mm)
        gap = poses["finger_left"][:3, 3] - poses["finger_right"][:3, 3]
        assert np.linalg.norm(gap) * 1000.0 == pytest.approx(expected_mm)


def test_a_slider_that_opens_downward_goes_to_its_lower_limit(tmp_path):
    slider = joint("s", "l6", "f", "prismatic", '<limit lower="-0.03" upper="0"/>')
    robot = load_robot(write_arm(tmp_path, extra=link("f") + slider))
    closed, opened = (robot.link_poses([0.0] * 6, mm)["f"][1, 3] for mm in (0.0, 40.0))
    assert (closed, opened) == pytest.approx((0.0, -0.02))


def test_materials_may_be_named(tmp_path):
    visual = BOX.replace("</visual>", '<material name="red"/></visual>')
    red = '<material name="red"><color rgba="1 0 0 1"/></material>'
    robot = load_robot(write_arm(tmp_path, visual=visual, extra=red))
    (box,) = parts_of(robot, "l3")
    assert box.color == (1, 0, 0)
    np.testing.assert_allclose(box.surface.extents, (0.1, 0.2, 0.3))


@pytest.mark.parametrize(
    ("shape", "extents"),
    [
        ('<box size="0.1 0.2 0.3"/>', (0.1, 0.2, 0.3)),
        ('<cylinder radius="0.1" length="0.5"/>', (0.2, 0.2, 0.5)),
        ('<sphere radius="0.1"/>', (0.2, 0.2, 0.2)),
    ],
)
def test_simple_solids_have_their_size_and_place(tmp_path, shape, extents):
    visual = f'<visual><origin xyz="1 2 3"/><geometry>{shape}</geometry></visual>'
    (part, *_) = load_robot(write_arm(tmp_path, visual=visual)).parts
    np.testing.assert_allclose(part.surface.extents, extents, atol=1e-6)
    np.testing.assert_allclose(part.surface.bounds.mean(axis=0), (1, 2, 3), atol=1e-6)
    assert part.color is None


@pytest.mark.parametrize("scale", ["0.001 0.002 -0.003", "0.001"])
def test_meshes_are_scaled_and_stay_turned_outward(tmp_path, scale):
    trimesh.creation.box(extents=(100, 100, 100)).export(tmp_path / "cube.stl")
    robot = load_robot(write_arm(tmp_path, visual=mesh("cube.stl", scale)))
    expected = np.broadcast_to(np.abs(np.array(scale.split(), float)) * 100, 3)
    np.testing.assert_allclose(robot.parts[0].surface.extents, expected)
    surface = robot.parts[0].surface
    assert trimesh.Trimesh(surface.vertices, surface.faces).volume > 0.0


@pytest.mark.parametrize(
    "name",
    ["package://some_robot/meshes/a.stl", "package://elsewhere/meshes/a.stl", "../meshes/a.stl"],
)
def test_meshes_of_a_package_are_found_from_its_urdf_folder(tmp_path, name):
    package = tmp_path / "some_robot"
    (package / "urdf").mkdir(parents=True)
    (package / "meshes").mkdir()
    trimesh.creation.box(extents=(1, 2, 3)).export(package / "meshes" / "a.stl")
    robot = load_robot(write_arm(package / "urdf", visual=mesh(name)))
    np.testing.assert_allclose(robot.parts[0].surface.extents, (1, 2, 3))


def test_hinges_of_fingers_are_not_the_arms(tmp_path):
    fingers = "".join(link(f) + joint(f"h{f}", "l6", f) for f in ("left", "right"))
    robot = load_robot(write_arm(tmp_path, extra=fingers))
    assert robot.arm_joints == ("j1", "j2", "j3", "j4", "j5", "j6")
    assert robot.joint_numbers()["left"] == 6


def test_a_joint_may_mimic_one_that_comes_later_in_the_file(tmp_path):
    follower = joint("a", "l6", "fa", "prismatic", '<mimic joint="b" multiplier="-2"/>')
    leader = joint("b", "l6", "fb", "prismatic", '<limit lower="0" upper="0.05"/>')
    robot = load_robot(write_arm(tmp_path, extra=link("fa") + link("fb") + follower + leader))
    poses = robot.link_poses([0.0] * 6, 40.0)
    assert poses["fa"][1, 3] == pytest.approx(-2 * poses["fb"][1, 3]) == pytest.approx(-0.04)


NEWER_GRIPPER = (
    link("measure")
    + joint("grip", "l6", "measure", "prismatic", '<limit lower="0" upper="0.1"/>')
    + link("fa", BOX)
    + joint("a", "l6", "fa", "prismatic", '<mimic joint="grip" multiplier="0.5"/>')
    + link("fb", BOX)
    + joint("b", "l6", "fb", "prismatic", '<mimic joint="grip" multiplier="-0.5" offset="0.001"/>')
)
"""As the maker's newer descriptions have it: a joint that bears nothing measures the opening."""


def in_both(robot, opening_mm, name="f"):
    """Where the fingers stand along Y in mm: in the picture, and in the window's own shape."""
    poses = robot.link_poses([0.0] * 6, opening_mm)
    names = [robot.root, *(joint.child for joint in robot.joints)]
    rows = shape_of(robot).links([0.0] * 6, opening_mm)
    drawn = {link: 1e3 * poses[link][1, 3] for link in names if link.startswith(name)}
    seen = {link: 1e3 * rows[names.index(link)][7] for link in drawn}
    assert seen == pytest.approx(drawn)
    return drawn


@pytest.mark.parametrize("opening_mm", [0.0, 40.0, 100.0, 130.0])
def test_fingers_led_by_a_joint_that_measures_the_opening_part_by_all_of_it(tmp_path, opening_mm):
    robot = load_robot(write_arm(tmp_path, extra=NEWER_GRIPPER))
    places = in_both(robot, opening_mm)
    opened_mm = min(opening_mm, 100.0)
    assert places == pytest.approx({"fa": opened_mm / 2.0, "fb": 1.0 - opened_mm / 2.0})


def test_fingers_may_be_led_in_other_shares_and_by_a_hinge(tmp_path):
    led = NEWER_GRIPPER.replace('"grip" multiplier="0.5"', '"grip" multiplier="1"')
    places = in_both(load_robot(write_arm(tmp_path, extra=led)), 60.0)
    assert places["fa"] - places["fb"] + 1.0 == pytest.approx(60.0)
    turned = NEWER_GRIPPER.replace('"grip" type="prismatic"', '"grip" type="revolute"')
    turned = turned.replace("0.5", "0.02").replace('upper="0.1"', 'upper="2.0"')
    places = in_both(load_robot(write_arm(tmp_path, extra=turned)), 60.0)
    assert places == pytest.approx({"fa": 30.0, "fb": -29.0})


def test_a_finger_that_leads_the_other_travels_half_of_the_opening(tmp_path):
    leader = '<limit lower="-0.038" upper="0"/>'
    fingers = joint("a", "l6", "fa", "prismatic", leader) + joint(
        "b", "l6", "fb", "prismatic", '<mimic joint="a" multiplier="-1"/>'
    )
    robot = load_robot(write_arm(tmp_path, extra=link("fa", BOX) + link("fb", BOX) + fingers))
    assert in_both(robot, 50.0) == pytest.approx({"fa": -25.0, "fb": 25.0})
    assert in_both(robot, 90.0) == pytest.approx({"fa": -38.0, "fb": 38.0})


XACRO = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'


@pytest.mark.parametrize(
    ("head", "extra", "word"),
    [
        (XACRO, '<xacro:include filename="$(find arm)/arm.urdf"/>', "$(find arm)/arm.urdf"),
        (XACRO, '<xacro:macro name="m" params="p"><link name="a"/></xacro:macro>', "xacro:macro"),
        (XACRO, '<xacro:property name="r" value="0.1"/>', "xacro:property"),
        ('xmlns:x="http://wiki.ros.org/xacro"', "<x:finger/>", "xacro:finger"),
        ("", '<link name="${side}_finger"/>', "${side}_finger"),
        ("", "<xacro:finger/>", "xacro:finger"),  # a namespace that only an including file has
    ],
)
def test_words_of_xacro_are_named_with_the_command_that_expands_them(tmp_path, head, extra, word):
    path = write_arm(tmp_path, extra=extra, name="arm.urdf.xacro")
    path.write_text(path.read_text().replace("<robot", f"<robot {head}"), encoding="utf-8")
    reason = refusal(path)
    assert reason.reason == URDF_XACRO
    assert reason.params == {"path": "arm.urdf.xacro", "word": word, "expanded": "arm.urdf"}


def test_a_command_for_xacro_never_writes_over_the_file_itself(tmp_path):
    reason = refusal(write_arm(tmp_path, extra='<link name="${a}"/>'))
    assert reason.params["expanded"] == "arm_expanded.urdf"


def test_a_description_that_only_names_xacro_is_read(tmp_path):
    path = write_arm(tmp_path, name="arm.xacro")
    path.write_text(path.read_text().replace("<robot", f"<robot {XACRO}"), encoding="utf-8")
    assert len(load_robot(path).arm_joints) == 6


def test_origin_turns_in_the_order_of_the_format(tmp_path):
    path = write_arm(tmp_path)
    text = path.read_text().replace('<origin xyz="0 0 0.1"/>', '<origin rpy="0.1 0.2 0.3"/>', 1)
    path.write_text(text)
    pose = load_robot(path).link_poses([0.0] * 6, 0.0)["l1"]
    cr, cp, cy = (math.cos(a) for a in (0.1, 0.2, 0.3))
    sr, sp, sy = (math.sin(a) for a in (0.1, 0.2, 0.3))
    # Rz(yaw) Ry(pitch) Rx(roll), written out
    expected = [
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ]
    np.testing.assert_allclose(pose[:3, :3], expected, atol=1e-12)


def test_a_missing_file_is_named(tmp_path):
    path = tmp_path / "none.urdf"
    assert refusal(path) == URDF_MISSING(path=str(path))


def test_a_folder_is_no_file(tmp_path):
    assert refusal(tmp_path).reason == URDF_UNREADABLE


@pytest.mark.parametrize(
    ("text", "code", "params"),
    [
        (
            "<robot>\n<link></robot>",
            "urdf_not_xml",
            {"text": "mismatched tag: line 2, column 8"},
        ),
        (
            '<?xml version="1.0" encoding="klingon"?><robot/>',
            "urdf_not_xml",
            {"text": "unknown encoding: klingon"},
        ),
        ("<html/>", "urdf_no_robot", {"element": "html"}),
        ("<robot/>", "urdf_incomplete", {}),
        ('<robot name="r"/>', "urdf_joint_count", {"found": 0, "wanted": 6}),
    ],
)
def test_what_is_no_robot_description_is_told(tmp_path, text, code, params):
    path = tmp_path / "x.urdf"
    path.write_text(text)
    assert refusal(path) == Refusal(Reason(code), {"path": str(path), **params})


@pytest.mark.parametrize("hinges", [5, 7])
def test_another_number_of_joints_is_refused(tmp_path, hinges):
    path = write_arm(tmp_path, hinges=hinges)
    expected = {"path": str(path), "found": hinges, "wanted": 6}
    assert refusal(path) == URDF_JOINT_COUNT(**expected)


@pytest.mark.parametrize("name", ["meshes/gone.stl", "package://gone/a.stl", "package://gone", ""])
def test_a_missing_mesh_is_named(tmp_path, name):
    path = write_arm(tmp_path, visual=mesh(name))
    assert refusal(path) == MESH_MISSING(path=str(path), mesh=name)


@pytest.mark.parametrize(
    ("name", "content", "code"),
    [
        ("bad.stl", "solid nothing\nendsolid nothing\n", "mesh_empty"),
        ("empty.stl", "", "mesh_empty"),
        ("bad.dae", "<junk", "mesh_unreadable"),
        ("bad.xyzzy", "junk", "mesh_kind_unknown"),
    ],
)
def test_a_mesh_that_shows_nothing_is_named(tmp_path, name, content, code):
    (tmp_path / name).write_text(content)
    reason = refusal(write_arm(tmp_path, visual=mesh(name)))
    assert (reason.code, reason.params["mesh"]) == (code, str(tmp_path / name))


def hinge(old: str = "", new: str = "") -> str:
    """A link more, and the joint that carries it, changed."""
    return link("a") + joint("x", "l6", "a").replace(old, new)


def picture(visual: str) -> str:
    """A link more, with a picture."""
    return link("a", visual) + joint("x", "l6", "a", "fixed")


@pytest.mark.parametrize(
    ("extra", "code", "params"),
    [
        (joint("x", "l6", "nowhere"), "urdf_no_tree", {"links": "nowhere"}),
        (link("alone"), "urdf_no_tree", {"links": "alone"}),
        (joint("x", "l6", "l3"), "urdf_no_tree", {"links": "l3"}),
        (link("l3"), "urdf_no_tree", {"links": "l3"}),
        (
            link("a") + link("b") + joint("x", "a", "b") + joint("y", "b", "a"),
            "urdf_no_tree",
            {"links": "a, b"},
        ),
        (hinge("revolute", "screw"), "urdf_bad_joint", {"joint": "x"}),
        (hinge('"x"', '"j3"'), "urdf_bad_joint", {"joint": "j3"}),
        (hinge("<axis", '<mimic joint="ghost"/><axis'), "urdf_bad_joint", {"joint": "x"}),
        (hinge("<axis", '<mimic joint="x"/><axis'), "urdf_bad_joint", {"joint": "x"}),
        (hinge("0 1 0", "0 0 0"), "urdf_bad_joint", {"joint": "x"}),
        (hinge("0 1 0", "0 1"), "urdf_bad_joint", {"joint": "x"}),
        (hinge("0 0 0.1", "0 nan 0"), "urdf_bad_joint", {"joint": "x"}),
        (hinge('<parent link="l6"/>'), "urdf_incomplete", {}),
        ("<link/>", "urdf_incomplete", {}),
        (picture("<visual/>"), "urdf_incomplete", {}),
    ],
)
def test_mistakes_are_named(tmp_path, extra, code, params):
    path = write_arm(tmp_path, extra=extra)
    assert refusal(path) == Refusal(Reason(code), {"path": str(path), **params})


@pytest.mark.parametrize(
    ("visual", "said"),
    [
        (BOX.replace("0.3", "wide"), "wide"),
        (BOX.replace("0.3", ""), "a: "),
        (BOX.replace("box", "torus"), "torus"),
        (BOX.replace("</v", '<material name="m"><color rgba="1 0 0"/></material></v'), "a: "),
    ],
)
def test_shapes_that_cannot_be_are_told(tmp_path, visual, said):
    reason = refusal(write_arm(tmp_path, extra=picture(visual)))
    assert reason.reason == URDF_MALFORMED
    assert said in str(reason.params["text"])
