"""Streams a sine to all six joints at 50 Hz for five seconds, ends where it began."""

import math

import armui_client

RATE_HZ = 50
DURATION_S = 5.0
PERIOD_S = 2.5
START_DEG = (0.0, 40.0, -50.0, 0.0, 20.0, 0.0)
AMPLITUDE_DEG = 5.0


def main() -> None:
    """Move to the middle, then stream."""
    with (
        armui_client.connect("sine.py") as arm,
        arm.lease("a sine on all joints", max_speed_percent=50),
    ):
        if not arm.is_enabled():
            arm.enable()
        arm.move_joints(START_DEG)
        with arm.stream(rate_hz=RATE_HZ) as stream:
            for step in range(round(RATE_HZ * DURATION_S)):
                turned = AMPLITUDE_DEG * math.sin(math.tau * step / RATE_HZ / PERIOD_S)
                stream.target([each + turned for each in START_DEG])
            stream.hold(START_DEG, 0.4)
        print("Ended at", arm.state().joints_deg.get())


if __name__ == "__main__":
    main()
