"""What is set of the teleoperator: ``--teleop.socket=…`` and so on."""

from dataclasses import dataclass

from lerobot.teleoperators import TeleoperatorConfig


@TeleoperatorConfig.register_subclass("armui")
@dataclass(kw_only=True)
class ArmuiTeleoperatorConfig(TeleoperatorConfig):
    """The arm that is led.

    Attributes:
        socket: Of the local interface of the armui that shows it; by default that of
            ``ARMUI_SOCKET``, or its usual place.
        gripper: False for an arm without a gripper.
    """

    socket: str | None = None
    gripper: bool = True
