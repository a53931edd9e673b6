"""Picks something up with the gripper and places it elsewhere: above, down, grip, up."""

import armui_client

PICK_MM_DEG = (320.0, 100.0, 150.0, 180.0, 0.0, 180.0)
PLACE_MM_DEG = (320.0, -100.0, 150.0, 180.0, 0.0, 180.0)
ABOVE_MM = 60.0
OPEN_MM, CLOSED_MM = 60.0, 20.0


def above(pose_mm_deg: tuple[float, ...]) -> tuple[float, ...]:
    """Return the pose straight above another."""
    x, y, z, *angles = pose_mm_deg
    return (x, y, z + ABOVE_MM, *angles)


def main() -> None:
    """Pick and place once."""
    with (
        armui_client.connect("pick_and_place.py") as arm,
        arm.lease("pick and place", max_speed_percent=50),
    ):
        if not arm.is_enabled():
            arm.enable()
        for pose_mm_deg, opening_mm in ((PICK_MM_DEG, CLOSED_MM), (PLACE_MM_DEG, OPEN_MM)):
            if opening_mm == CLOSED_MM:
                arm.gripper(OPEN_MM)
            arm.move_pose(above(pose_mm_deg))
            arm.move_line(pose_mm_deg)
            arm.gripper(opening_mm, torque_nm=1.0)
            arm.move_line(above(pose_mm_deg))
            print(f"At {pose_mm_deg[:2]}: opening {arm.state().gripper_mm.get():.0f} mm")


if __name__ == "__main__":
    main()
