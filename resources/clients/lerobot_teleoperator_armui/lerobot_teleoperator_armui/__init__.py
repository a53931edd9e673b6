"""A PiPER arm behind armui as a teleoperator of LeRobot: ``--teleop.type=armui``."""

from lerobot_teleoperator_armui.armui_teleoperator import ArmuiTeleoperator
from lerobot_teleoperator_armui.config import ArmuiTeleoperatorConfig

__version__ = "0.1.0"

__all__ = ["ArmuiTeleoperator", "ArmuiTeleoperatorConfig"]
