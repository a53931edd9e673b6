"""Nods for five seconds as LeRobot's loop would have it, at 30 Hz; ends where it began."""

import math
import time

from lerobot_robot_armui import ArmuiRobot, ArmuiRobotConfig

FPS = 30
DURATION_S = 5.0
AMPLITUDE_DEG = 10.0


def main() -> None:
    """Observe, act, observe."""
    with ArmuiRobot(ArmuiRobotConfig(purpose="nodding", max_speed_percent=50)) as robot:
        first = robot.get_observation()
        for step in range(round(FPS * DURATION_S) + 1):
            turned = AMPLITUDE_DEG * math.sin(math.tau * step / (FPS * DURATION_S))
            robot.send_action({**first, "joint_5.pos": first["joint_5.pos"] + turned})
            time.sleep(1.0 / FPS)
        print({name: round(value, 1) for name, value in robot.get_observation().items()})


if __name__ == "__main__":
    main()
