"""The teleoperator: it tells where an arm is, and asks for nothing."""

from __future__ import annotations

from typing import Any

import armui_client
from lerobot.teleoperators import Teleoperator
from lerobot.utils.errors import DeviceAlreadyConnectedError, DeviceNotConnectedError
from lerobot_robot_armui.joints import keys_of, measured

from lerobot_teleoperator_armui.config import ArmuiTeleoperatorConfig


class ArmuiTeleoperator(Teleoperator):
    """A PiPER arm behind armui that somebody leads: by hand in drag teaching, by jog, by a run.

    Its measured angles are the action. It takes no lease and moves nothing.

    Args:
        config: See :class:`ArmuiTeleoperatorConfig`.
    """

    config_class = ArmuiTeleoperatorConfig
    name = "armui"

    def __init__(self, config: ArmuiTeleoperatorConfig) -> None:
        super().__init__(config)
        self.config = config
        self._arm: armui_client.Arm | None = None

    @property
    def action_features(self) -> dict[str, Any]:
        """The measured angles in degrees, and the measured opening in mm."""
        return dict.fromkeys(keys_of(gripper=self.config.gripper), float)

    @property
    def feedback_features(self) -> dict[str, Any]:
        """Nothing: the arm is led, and gives no force back."""
        return {}

    @property
    def is_connected(self) -> bool:
        """True while armui answers."""
        return self._arm is not None and self._arm.is_connected

    @property
    def is_calibrated(self) -> bool:
        """True: the arm keeps its zeros, and armui looks after them."""
        return True

    def calibrate(self) -> None:
        """Do nothing; see :attr:`is_calibrated`."""

    def configure(self) -> None:
        """Do nothing: what is set of the arm is its operator's."""

    def connect(self, calibrate: bool = True) -> None:  # noqa: ARG002 - LeRobot's
        """Connect to armui.

        Raises:
            DeviceAlreadyConnectedError: It is connected.
            armui_client.Disconnected: armui does not run, or its interface is off.
            armui_client.Stale: The arm is not heard, or has no gripper that tells its opening.
        """
        if self.is_connected:
            raise DeviceAlreadyConnectedError(f"{self} is connected.")
        name = f"lerobot {self.id or ''}".strip()
        self._arm = arm = armui_client.connect(name, path=self.config.socket)
        try:
            measured(arm, gripper=self.config.gripper)
        except BaseException:
            self.disconnect()
            raise

    def disconnect(self) -> None:
        """Close the connection; the arm is left as it is.

        Raises:
            DeviceNotConnectedError: It is not connected.
        """
        arm, self._arm = self._arm, None
        if arm is None:
            raise DeviceNotConnectedError(f"{self} is not connected.")
        arm.close()

    def get_action(self) -> dict[str, Any]:
        """Return where the arm is, at most 0.25 s old.

        Raises:
            DeviceNotConnectedError: It is not connected.
            armui_client.Stale: The arm has told nothing for longer: nothing is made up.
        """
        if self._arm is None or not self._arm.is_connected:
            raise DeviceNotConnectedError(f"{self} is not connected.")
        return dict(measured(self._arm, gripper=self.config.gripper))

    def send_feedback(self, feedback: dict[str, Any]) -> None:
        """Do nothing; see :attr:`feedback_features`."""
