"""What is set of the robot: ``--robot.max_speed_percent=50`` and so on."""

from dataclasses import dataclass, field

from lerobot.cameras import CameraConfig
from lerobot.robots import RobotConfig


@RobotConfig.register_subclass("armui")
@dataclass(kw_only=True)
class ArmuiRobotConfig(RobotConfig):
    """The arm, and what LeRobot asks its operator for.

    Attributes:
        socket: Of armui's local interface; by default that of ``ARMUI_SOCKET``, or its usual place.
        purpose: What the operator reads when LeRobot asks for the arm.
        moves: False to only observe, while the operator moves the arm in armui or by hand: no lease
            is asked for, and actions go nowhere.
        max_speed_percent: The highest speed asked for, 1 to 100; the operator may grant less.
        gripper: False for an arm without a gripper.
        gripper_torque_nm: The torque with which it closes.
        give_up_after_s: An action that armui refuses is told in the log with its reason, and the
            arm rests. Where none was followed for this time, it is raised; 0: at the first.
        cameras: As of any robot of LeRobot.
    """

    socket: str | None = None
    purpose: str = "LeRobot"
    moves: bool = True
    max_speed_percent: int = 30
    gripper: bool = True
    gripper_torque_nm: float = 1.0
    give_up_after_s: float = 1.0
    cameras: dict[str, CameraConfig] = field(default_factory=dict)

    def __post_init__(self) -> None:
        """Check what can be checked without an arm.

        Raises:
            ValueError: A value is outside its range; the text says which.
        """
        super().__post_init__()
        if not 1 <= self.max_speed_percent <= 100:
            text = f"max_speed_percent is {self.max_speed_percent}; it may be 1 to 100."
            raise ValueError(text)
        if not self.give_up_after_s >= 0.0:
            raise ValueError(f"give_up_after_s is {self.give_up_after_s}; it may be 0 or more.")
