"""Enables the arm if it is not, moves its joints there and back, and prints what is refused."""

import armui_client


def main() -> None:
    """Move twice, and ask for something impossible."""
    with (
        armui_client.connect("move.py") as arm,
        arm.lease("there and back", max_speed_percent=30),
    ):
        if not arm.is_enabled():
            arm.enable()
        arm.set_speed(30)
        arm.move_joints([0, 30, -40, 0, 20, 0])
        print("There:", arm.state().joints_deg.get())
        try:
            arm.step_joint(1, 400)
        except armui_client.Refused as refused:
            print("Refused, as it should be:", refused, refused.reason, dict(refused.figures))
        arm.home()
        print("Back:", arm.state().joints_deg.get())


if __name__ == "__main__":
    main()
