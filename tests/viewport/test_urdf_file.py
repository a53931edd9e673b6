"""Reading robot descriptions: ours, foreign ones, broken ones."""

import math

import numpy as np
import pytest

from armui.paths import URDF
from armui.viewport.errors import SceneError
from armui.viewport.urdf_file import load_robot
from tests.viewport.foreign import ARM, joint, link, mesh, write_arm

BOX = '<visual><geometry><box size="0.1 0.2 0.3"/></geometry></visual>'


def refusal(path) -> str:
    with pytest.raises(SceneError) as caught:
        load_robot(path)
    return str(caught.value)


def test_our_arm_has_its_joints_colours_and_meshes():
    robot = load_robot(URDF / "piper.urdf")
    assert robot.root == "base_link"
    assert robot.arm_joints == tuple(f"joint{number}" for number in range(1, 7))
    shell, dark = robot.visuals["link2"]
    assert shell.mesh == (URDF / "meshes" / "link2_shell.stl").resolve()
    assert min(shell.color) > 0.9
    assert max(dark.color) < 0.3


def test_links_know_the_joint_that_moves_them():
    numbers = load_robot(URDF / "piper.urdf").joint_number_of_link
    assert "base_link" not in numbers
    assert [numbers[f"link{number}"] for number in range(1, 7)] == [1, 2, 3, 4, 5, 6]
    assert numbers["finger_left"] == 6


def test_zero_pose_of_the_flange():
    pose = load_robot(URDF / "piper.urdf").link_poses([0.0] * 6, 0.0)["flange"]
    np.testing.assert_allclose(pose[:3, 3] * 1000.0, [56.128, 0.0, 213.266], atol=5e-4)


def test_fingers_part_by_the_opening_and_no_further_than_their_limit():
    robot = load_robot(URDF / "piper.urdf")
    for opening_mm, expected_mm in ((0.0, 0.0), (40.0, 40.0), (90.0, 70.0)):
        poses = robot.link_poses([0.0] * 6, opening_mm)
        gap = poses["finger_left"][:3, 3] - poses["finger_right"][:3, 3]
        assert np.linalg.norm(gap) * 1000.0 == pytest.approx(expected_mm)


def test_a_slider_that_opens_downward_goes_to_its_lower_limit(tmp_path):
    slider = joint("s", "l6", "f", "prismatic", '<limit lower="-0.03" upper="0"/>')
    robot = load_robot(write_arm(tmp_path, extra=link("f") + slider))
    closed, opened = (robot.link_poses([0.0] * 6, mm)["f"][1, 3] for mm in (0.0, 40.0))
    assert (closed, opened) == pytest.approx((0.0, -0.02))


def test_simple_solids_and_named_materials(tmp_path):
    visual = BOX.replace("</visual>", '<material name="red"/></visual>')
    red = '<material name="red"><color rgba="1 0 0 1"/></material>'
    robot = load_robot(write_arm(tmp_path, visual=visual, extra=red))
    (box,) = robot.visuals["l3"]
    assert (box.kind, box.size, box.mesh, box.color) == ("box", (0.1, 0.2, 0.3), None, (1, 0, 0))


@pytest.mark.parametrize(
    "name",
    ["package://some_robot/meshes/a.stl", "package://elsewhere/meshes/a.stl", "../meshes/a.stl"],
)
def test_meshes_of_a_package_are_found_from_its_urdf_folder(tmp_path, name):
    package = tmp_path / "some_robot"
    (package / "urdf").mkdir(parents=True)
    (package / "meshes").mkdir()
    (package / "meshes" / "a.stl").write_bytes(b"")
    robot = load_robot(write_arm(package / "urdf", visual=mesh(name)))
    assert robot.visuals["l0"][0].mesh.samefile(package / "meshes" / "a.stl")


def test_hinges_of_fingers_are_not_the_arms(tmp_path):
    fingers = "".join(link(f) + joint(f"h{f}", "l6", f) for f in ("left", "right"))
    robot = load_robot(write_arm(tmp_path, extra=fingers))
    assert robot.arm_joints == ("j1", "j2", "j3", "j4", "j5", "j6")
    assert robot.joint_number_of_link["left"] == 6


def test_a_joint_may_mimic_one_that_comes_later_in_the_file(tmp_path):
    follower = joint("a", "l6", "fa", "prismatic", '<mimic joint="b" multiplier="-2"/>')
    leader = joint("b", "l6", "fb", "prismatic", '<limit lower="0" upper="0.05"/>')
    robot = load_robot(write_arm(tmp_path, extra=link("fa") + link("fb") + follower + leader))
    poses = robot.link_poses([0.0] * 6, 40.0)
    assert poses["fa"][1, 3] == pytest.approx(-2 * poses["fb"][1, 3]) == pytest.approx(-0.04)


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
    text = refusal(tmp_path / "none.urdf")
    assert "none.urdf" in text
    assert "choose" in text


def test_broken_xml_is_named_with_its_line(tmp_path):
    path = tmp_path / "broken.urdf"
    path.write_text("<robot>\n<link></robot>")
    text = refusal(path)
    assert "broken.urdf" in text
    assert "line 2" in text


def test_other_xml_is_refused(tmp_path):
    path = tmp_path / "page.urdf"
    path.write_text("<html/>")
    assert "<html>" in refusal(path)


@pytest.mark.parametrize(("hinges", "said"), [(5, "5 revolute"), (7, "7 revolute")])
def test_another_number_of_joints_is_refused(tmp_path, hinges, said):
    text = refusal(write_arm(tmp_path, hinges=hinges))
    assert said in text
    assert "six-joint arm" in text


def test_a_missing_mesh_is_named(tmp_path):
    text = refusal(write_arm(tmp_path, visual=mesh("meshes/gone.stl")))
    assert "meshes/gone.stl" in text
    assert "arm.urdf" in text


@pytest.mark.parametrize(
    ("extra", "said"),
    [
        (joint("x", "l6", "nowhere"), "nowhere"),
        (link("alone"), "2 links without a parent"),
        (link("a") + joint("x", "l6", "a", "screw"), "“x”"),
        (link("a") + joint("x", "l6", "a", inside='<mimic joint="ghost"/>'), "mimic no joint: x"),
        (link("a", "<visual/>") + joint("x", "l6", "a"), "no shape"),
        (link("a", BOX.replace("0.3", "wide")) + joint("x", "l6", "a"), "0.1 0.2 wide"),
        (link("a", BOX.replace("box", "torus")) + joint("x", "l6", "a"), "<torus>"),
        (joint("x", "l6", "l3"), "more than one parent has link “l3”"),
        (link("a") + joint("j3", "l6", "a"), "more than one joint is called “j3”"),
        ("<link/>", "“name”"),
    ],
)
def test_mistakes_are_named(tmp_path, extra, said):
    assert said in refusal(write_arm(tmp_path, extra=extra))


def test_joints_in_a_circle_are_refused(tmp_path):
    path = tmp_path / "loop.urdf"
    joints = joint("x", "a", "b") + joint("y", "b", "a")
    path.write_text(ARM.format(links=link("root") + link("a") + link("b"), joints=joints, extra=""))
    assert "loop" in refusal(path)
