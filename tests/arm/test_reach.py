"""Where no way leads."""

from armui.arm.reach import POSE_OUT_OF_REACH, led_joints
from armui.arm.refusal import Refusal
from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.poses import pose_to_matrix
from armui.kinematics.tool_path import Line
from tests.family import PIPER


def test_a_line_to_where_no_way_leads_says_so_and_advises_no_other_move():
    kinematics = Kinematics(PIPER)
    start_deg = (0.0, 60.0, -60.0, 0.0, 30.0, 0.0)
    here = kinematics.forward(start_deg)

    def line(along_mm):
        end = here._replace(x_mm=here.x_mm + along_mm)
        return Line(pose_to_matrix(here), pose_to_matrix(end))

    far = led_joints(kinematics, line(900.0), start_deg)
    assert isinstance(far, Refusal)
    assert far.reason is POSE_OUT_OF_REACH
    assert float(far.params["missing"]) > 100.0
    assert not isinstance(led_joints(kinematics, line(20.0), start_deg), Refusal)
