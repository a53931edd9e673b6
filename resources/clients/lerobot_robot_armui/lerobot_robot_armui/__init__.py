"""The PiPER arm behind armui as a robot of LeRobot: ``--robot.type=armui``."""

from lerobot_robot_armui.armui_robot import ArmuiRobot
from lerobot_robot_armui.config import ArmuiRobotConfig

__version__ = "0.1.0"

__all__ = ["ArmuiRobot", "ArmuiRobotConfig"]
