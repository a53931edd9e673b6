"""The robot: armui keeps the checks, the stop and the record; LeRobot observes and asks."""

from __future__ import annotations

import contextlib
import logging
import time
from typing import Any

import armui_client
from lerobot.cameras import make_cameras_from_configs
from lerobot.robots import Robot
from lerobot.utils.errors import DeviceAlreadyConnectedError, DeviceNotConnectedError

from lerobot_robot_armui.config import ArmuiRobotConfig
from lerobot_robot_armui.joints import keys_of, measured, wanted

_LOG = logging.getLogger(__name__)
_STREAM_HZ = 100.0
"""The highest rate of a stream: LeRobot keeps the pace, and a faster one is refused nothing."""
_GRIPPER_STEP_MM = 0.5
"""The gripper is asked again once its target differs by this."""


class ArmuiRobot(Robot):
    """A PiPER arm behind armui.

    Connecting asks the operator for the lease, and does nothing else: no motor is switched on, and
    nothing moves. Each action is a target of a stream, followed on a path of armui's or refused,
    never changed. Disconnecting halts the arm and gives the lease back; its motors stay on.

    Args:
        config: See :class:`ArmuiRobotConfig`.
    """

    config_class = ArmuiRobotConfig
    name = "armui"

    def __init__(self, config: ArmuiRobotConfig) -> None:
        super().__init__(config)
        self.config = config
        self.cameras: dict[str, Any] = make_cameras_from_configs(config.cameras)
        self._arm: armui_client.Arm | None = None
        self._lease: armui_client.Lease | None = None
        self._stream: armui_client.Stream | None = None
        self._gripper_mm: float | None = None
        self._followed = 0
        self._refused_since_s: float | None = None

    # What it is -------------------------------------------------------------------------------

    @property
    def observation_features(self) -> dict[str, Any]:
        """The measured angles in degrees and the opening in mm, then the images."""
        images = {name: (each.height, each.width, 3) for name, each in self.config.cameras.items()}
        return {**self.action_features, **images}

    @property
    def action_features(self) -> dict[str, Any]:
        """The wanted angles in degrees, and the wanted opening in mm."""
        return dict.fromkeys(keys_of(gripper=self.config.gripper), float)

    @property
    def is_connected(self) -> bool:
        """True while armui answers, and each camera is connected."""
        arm_is = self._arm is not None and self._arm.is_connected
        return arm_is and all(each.is_connected for each in self.cameras.values())

    @property
    def is_calibrated(self) -> bool:
        """True: the arm keeps its zeros, and armui looks after them."""
        return True

    def calibrate(self) -> None:
        """Do nothing; see :attr:`is_calibrated`."""

    def configure(self) -> None:
        """Do nothing: what is set of the arm is the operator's."""

    # Connecting -------------------------------------------------------------------------------

    def connect(self, calibrate: bool = True) -> None:  # noqa: ARG002 - LeRobot's
        """Connect to armui, ask the operator for the lease, and wait up to 30 s for his press.

        Raises:
            DeviceAlreadyConnectedError: It is connected.
            armui_client.Disconnected: armui does not run, or its interface is off.
            armui_client.Refused: The operator has declined, or was not there.
            armui_client.Stale: The arm is not heard, or has no gripper that tells its opening.
        """
        if self.is_connected:
            raise DeviceAlreadyConnectedError(f"{self} is connected.")
        self._close()
        config = self.config
        self._arm = arm = armui_client.connect(
            f"lerobot {self.id or ''}".strip(), path=config.socket
        )
        try:
            measured(arm, gripper=config.gripper)
            for each in self.cameras.values():
                each.connect()
            if config.moves:
                percent = config.max_speed_percent
                self._lease = arm.lease(config.purpose, max_speed_percent=percent).take()
                self._stream = arm.stream(_STREAM_HZ, raises=False)
        except BaseException:
            self._close()
            raise

    def disconnect(self) -> None:
        """Halt what moves, give the lease back, and leave the motors on.

        Raises:
            DeviceNotConnectedError: It is not connected.
        """
        if self._arm is None:
            raise DeviceNotConnectedError(f"{self} is not connected.")
        self._close()

    def _close(self) -> None:
        stream, self._stream = self._stream, None
        lease, self._lease = self._lease, None
        arm, self._arm = self._arm, None
        self._gripper_mm = self._refused_since_s = None
        self._followed = 0
        with contextlib.suppress(armui_client.ArmuiError):
            if stream is not None:
                stream.end()
        if lease is not None:
            lease.release()
        if arm is not None:
            arm.close()
        for each in self.cameras.values():
            if each.is_connected:
                each.disconnect()

    # At each step -----------------------------------------------------------------------------

    def get_observation(self) -> dict[str, Any]:
        """Return what is measured, at most 0.25 s old, and the newest images.

        Raises:
            DeviceNotConnectedError: It is not connected.
            armui_client.Stale: The arm has told nothing for longer: nothing is made up.
        """
        values: dict[str, Any] = dict(measured(self._connected(), gripper=self.config.gripper))
        return {**values, **{name: each.read_latest() for name, each in self.cameras.items()}}

    def send_action(self, action: dict[str, Any]) -> dict[str, Any]:
        """Have the arm follow the action, as a target of the stream; return it as it was asked.

        It waits for no operator, some milliseconds at most.

        Args:
            action: See :attr:`action_features`.

        Raises:
            DeviceNotConnectedError: It is not connected.
            ValueError: A key is missing.
            armui_client.LeaseLost: The operator has taken the arm back, or it has stopped.
            armui_client.Refused: Actions were refused for ``give_up_after_s``; the last reason.
        """
        arm = self._connected()
        joints_deg, opening_mm = wanted(action, gripper=self.config.gripper)
        if self._stream is None:
            return action
        self._take(self._stream.target(joints_deg), self._stream.followed)
        if opening_mm is not None:
            self._move_gripper(arm, opening_mm)
        return action

    def _move_gripper(self, arm: armui_client.Arm, opening_mm: float) -> None:
        last_mm, torque_nm = self._gripper_mm, self.config.gripper_torque_nm
        if last_mm is not None and abs(opening_mm - last_mm) < _GRIPPER_STEP_MM:
            return
        self._gripper_mm = opening_mm
        try:
            arm.gripper(opening_mm, torque_nm=torque_nm, wait=False)
        except armui_client.Refused as refused:
            _LOG.warning("armui does not move the gripper (%s): %s", refused.reason, refused)

    def _take(self, refused: armui_client.Refused | None, followed: int) -> None:
        """Tell the first refusal of a row in the log; raise one once nothing was followed for long.

        Args:
            refused: Why a target is not followed, if one is not.
            followed: How many have been.
        """
        if followed != self._followed:
            self._followed, self._refused_since_s = followed, None
        if refused is None:
            return
        now_s = time.monotonic()
        if self._refused_since_s is None:
            self._refused_since_s = now_s
            _LOG.warning("armui does not follow (%s): %s", refused.reason, refused)
        if now_s - self._refused_since_s >= self.config.give_up_after_s:
            self._refused_since_s = None
            raise refused

    def _connected(self) -> armui_client.Arm:
        if self._arm is None or not self._arm.is_connected:
            raise DeviceNotConnectedError(f"{self} is not connected.")
        return self._arm
