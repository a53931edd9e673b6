"""Reads and sets the values an arm keeps, as a host requests over the bus."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from armui.arm.limits import JOINTS, JointLimits
from armui.arm.models import model_data
from armui.arm.state import JointNumber
from armui.protocol.codec import Codec, InvalidFrame
from armui.protocol.codes import (
    ALL_JOINTS,
    DEGREES_PER,
    VALID,
    EndLoad,
    FactoryReset,
    LimitQuery,
    ParameterQuery,
    SettingIndex,
)
from armui.protocol.frame import Frame
from armui.protocol.generation import PiperModel
from armui.protocol.message_fields import record_reader, signal_names
from armui.sim.parameters.settings import ArmSettingsRecord, HandleSettings, Light

if TYPE_CHECKING:
    from armui.sim.parameters.settings_applier import SettingsApplier


Signals = dict[str, float]

_END_LIMIT_NAMES: Final = (
    "MaxLinearSpeed",
    "MaxAngularSpeed",
    "MaxLinearAcceleration",
    "MaxAngularAcceleration",
)
_ROUNDING_GRACE: Final = 1.02
"""29 RPM on the bus are 28.65 RPM in the arm: a value read back may be written again."""

_HANDLE_SIGNALS: Final = signal_names(HandleSettings)
_read_handle: Final = record_reader(HandleSettings)
_JOINT_NAMES: Final = tuple(f"J{joint}" for joint in JOINTS)
_ON_OFF: Final = ("On", "Off")
_READS_ONLY: Final = frozenset({"LimitQuery", "LightControl"})

_REQUEST: Final = 1
_FRAME_LENGTH: Final = 8
_LENGTH: Final = 11 * _FRAME_LENGTH

_HARDWARE: Final = (0, "H-V1.2-1")
_BATCH: Final = (16, "10")
_NODE_TYPE_AT: Final = 32
_SOFTWARE_AT: Final = 60
_SOFTWARE_LENGTH: Final = 8
"""The length of the version's text. The date follows at once: a longer version shifts it."""
_DATE: Final = "250925"
_NODE_NUMBER: Final = (76, "15")
_NODE_TYPE: Final = "ARM_MC"


class ParameterServer:
    """Answers questions about the settings, and changes them.

    Every setting is answered with 0x476. A value no motor could follow (a range without extent,
    more speed or acceleration than the motors have) is answered like any other and not stored: only
    the value read back proves that it was stored.
    """

    def __init__(self, codec: Codec, settings: ArmSettingsRecord, arm: SettingsApplier) -> None:
        self._codec = codec
        self._arm = arm
        self.settings = settings
        self._handlers: dict[str, Callable[[Signals], list[Frame]]] = {
            "LimitQuery": self._limit_query,
            "LimitSetting": self._limit_setting,
            "JointSetting": self._joint_setting,
            "ParameterCommand": self._parameter_command,
            "EndLimitSetting": self._end_limit_setting,
            "CollisionSetting": self._collision_setting,
            "TeachingSetting": self._teaching_setting,
            "DragAssistanceSetting": self._drag_assistance_setting,
            "LightControl": self._light_control,
        }

    def handle(self, name: str, signals: Signals) -> list[Frame] | None:
        """Return the answers to a message, or None if it is not about settings."""
        handler = self._handlers.get(name)
        if handler is None:
            return None
        answers = handler(signals)
        if name not in _READS_ONLY:
            self._arm.settings_changed()
        return answers

    def answer(self, index: SettingIndex, *, zero_set: bool = False) -> Frame:
        """Return the answer to a setting, which also says whether a zero was set."""
        return self._codec.encode("SettingResponse", Index=index, ZeroSet=zero_set)

    def corrupt_limits(self, index: int) -> None:
        """Makes one joint's limits (0–5) read back as 0xFFFF in every field."""
        joint = bytes((index + 1,))
        limits = self._read(0x473, joint + b"\xff" * 6 + b"\0")
        acceleration = self._read(0x47C, joint + b"\xff" * 2 + bytes(5))
        self.settings.limits[index] = JointLimits(
            limits["MinAngle"],
            limits["MaxAngle"],
            limits["MaxSpeed"] * self._degrees_per("LimitFeedback", "MaxSpeed"),
        )
        unit_deg = self._degrees_per("AccelerationFeedback", "MaxAcceleration")
        self.settings.accelerations_deg_s2[index] = acceleration["MaxAcceleration"] * unit_deg
        self._arm.settings_changed()

    def _read(self, arbitration_id: int, data: bytes) -> Signals:
        message = self._codec.decode(Frame(arbitration_id, data))
        if isinstance(message, InvalidFrame):
            raise TypeError(message.detail)
        return message.signals

    def _limit_query(self, signals: Signals) -> list[Frame]:
        joint = JointNumber(signals["Joint"])
        if signals["Query"] == LimitQuery.ACCELERATION_LIMIT:
            acceleration = self._outward(
                "AccelerationFeedback",
                "MaxAcceleration",
                self.settings.accelerations_deg_s2[joint - 1],
            )
            return [
                self._codec.encode(
                    "AccelerationFeedback", Joint=joint, MaxAcceleration=acceleration
                )
            ]
        limits = self.settings.limits[joint - 1]
        return [
            self._codec.encode(
                "LimitFeedback",
                Joint=joint,
                MaxAngle=limits.max_deg,
                MinAngle=limits.min_deg,
                MaxSpeed=self._outward("LimitFeedback", "MaxSpeed", limits.max_speed_deg_s),
            )
        ]

    def _limit_setting(self, signals: Signals) -> list[Frame]:
        name, index = "LimitSetting", JointNumber(signals["Joint"]) - 1
        limits = self.settings.limits[index]
        if not self._unchanged(name, "MaxAngle", signals):
            limits = limits._replace(max_deg=signals["MaxAngle"])
        if not self._unchanged(name, "MinAngle", signals):
            limits = limits._replace(min_deg=signals["MinAngle"])
        if not self._unchanged(name, "MaxSpeed", signals):
            speed = self._inward(
                name, "MaxSpeed", signals, most=self._arm.model.limits[index].max_speed_deg_s
            )
            limits = limits._replace(max_speed_deg_s=speed)
        if limits.min_deg < limits.max_deg and limits.max_speed_deg_s > 0.0:
            self.settings.limits[index] = limits
        return [self.answer(SettingIndex.LIMIT_SETTING)]

    def _joint_setting(self, signals: Signals) -> list[Frame]:
        name, joint = "JointSetting", int(signals["Joint"])
        indices = range(len(JOINTS)) if joint == ALL_JOINTS else (JointNumber(joint) - 1,)
        if signals["ClearError"] == VALID:
            self._arm.clear_joint_errors(indices)
        zero_set = signals["SetZero"] == VALID and self._arm.set_zero(indices)
        if signals["AccelerationValid"] == VALID and not self._unchanged(
            name, "MaxAcceleration", signals
        ):
            acceleration = self._inward(
                name, "MaxAcceleration", signals, most=max(self._arm.model.accelerations_deg_s2)
            )
            if acceleration > 0.0:
                for index in indices:
                    self.settings.accelerations_deg_s2[index] = acceleration
        return [self.answer(SettingIndex.JOINT_SETTING, zero_set=zero_set)]

    def _parameter_command(self, signals: Signals) -> list[Frame]:
        settings = self.settings
        reset = signals["Reset"]
        if reset == FactoryReset.END_LIMITS_TO_FACTORY:
            settings.end_limits = ArmSettingsRecord().end_limits
        elif reset == FactoryReset.JOINT_LIMITS_TO_FACTORY:
            settings.limits[:] = self._arm.model.limits
            settings.accelerations_deg_s2[:] = self._arm.model.accelerations_deg_s2
        feedback = self._codec.word("ParameterCommand", "EndFeedback", int(signals["EndFeedback"]))
        if feedback in _ON_OFF:
            self._arm.report_end_motion(on=feedback == "On")
        loads = signals["LoadValid"] == VALID and signals["Load"] != EndLoad.NOT_GIVEN
        if loads:
            settings.load = EndLoad(int(signals["Load"]))
        frames = self._parameters(ParameterQuery(int(signals["Query"])))
        asks_only = frames and not (reset or loads or signals["EndFeedback"])
        return frames if asks_only else [*frames, self.answer(SettingIndex.PARAMETER_COMMAND)]

    def _parameters(self, query: ParameterQuery) -> list[Frame]:
        settings = self.settings
        if query is ParameterQuery.END_LIMITS:
            signals = dict(zip(_END_LIMIT_NAMES, settings.end_limits, strict=True))
            return [self._codec.encode("EndLimitFeedback", **signals)]
        if query is ParameterQuery.COLLISION_LEVELS:
            levels = dict(zip(_JOINT_NAMES, settings.collision_levels, strict=True))
            return [self._codec.encode("CollisionFeedback", **levels)]
        if query is ParameterQuery.TEACHING_SETTING:
            kept = settings.teaching._asdict()
            values = {_HANDLE_SIGNALS[field]: value for field, value in kept.items()}
            return [self._codec.encode("TeachingFeedback", **values)]
        if query is ParameterQuery.DRAG_ASSISTANCE and self._codec.quirks.has_drag_assistance:
            levels = dict(zip(_JOINT_NAMES, settings.drag_assistance, strict=True))
            return [self._codec.encode("DragAssistanceFeedback", **levels)]
        return []

    def _end_limit_setting(self, signals: Signals) -> list[Frame]:
        self.settings.end_limits = tuple(
            old if self._unchanged("EndLimitSetting", name, signals) else signals[name]
            for name, old in zip(_END_LIMIT_NAMES, self.settings.end_limits, strict=True)
        )
        return [self.answer(SettingIndex.END_LIMIT_SETTING)]

    def _collision_setting(self, signals: Signals) -> list[Frame]:
        self.settings.collision_levels = tuple(int(signals[name]) for name in _JOINT_NAMES)
        return [self.answer(SettingIndex.COLLISION_SETTING)]

    def _teaching_setting(self, signals: Signals) -> list[Frame]:
        whole = {name: int(value) for name, value in signals.items()}
        self.settings.teaching = _read_handle(whole)
        return [self.answer(SettingIndex.TEACHING_SETTING)]

    def _drag_assistance_setting(self, signals: Signals) -> list[Frame]:
        """Set and answer the drag assistance, which firmware before S-V1.8-1 does not know."""
        if not self._codec.quirks.has_drag_assistance:
            return []
        self.settings.drag_assistance = tuple(
            old if self._unchanged("DragAssistanceSetting", name, signals) else int(signals[name])
            for name, old in zip(_JOINT_NAMES, self.settings.drag_assistance, strict=True)
        )
        return [self.answer(SettingIndex.DRAG_ASSISTANCE_SETTING)]

    def _light_control(self, signals: Signals) -> list[Frame]:
        if signals["Enable"]:
            self.settings.lights[JointNumber(signals["Joint"])] = Light(
                *(int(signals[name]) for name in ("Lamp", "Red", "Green", "Blue", "Counter"))
            )
        return []

    def _unchanged(self, message: str, signal: str, signals: Signals) -> bool:
        """Return whether a field asks to leave its value: the only word in its value table."""
        return self._codec.word(message, signal, signals[signal]) is not None

    def _outward(self, message: str, signal: str, value_deg: float) -> float:
        return value_deg / self._degrees_per(message, signal)

    def _degrees_per(self, message: str, signal: str) -> float:
        return DEGREES_PER[self._codec.unit(message, signal)]

    def _inward(self, message: str, signal: str, signals: Signals, *, most: float) -> float:
        """Return a speed or acceleration in degrees; 0 when it is more than the motors can do."""
        value_deg = signals[signal] * self._degrees_per(message, signal)
        return min(value_deg, most) if value_deg <= most * _ROUNDING_GRACE else 0.0


def identity_text(version: str, model: PiperModel) -> bytes:
    """Return the 88 bytes of the answer to 0x4AF, padded with zeros."""
    text = bytearray(_LENGTH)
    types = model_data(model).node_types
    software = version.ljust(_SOFTWARE_LENGTH, "\0") + _DATE
    for at, words in (
        _HARDWARE,
        _BATCH,
        (_NODE_TYPE_AT, types[0] if types else _NODE_TYPE),
        _NODE_NUMBER,
        (_SOFTWARE_AT, software),
    ):
        raw = words.encode("ascii", "replace")
        text[at : at + len(raw)] = raw
    return bytes(text[:_LENGTH])


def version_frames(
    codec: Codec, signals: dict[str, float], version: str, model: PiperModel = PiperModel.PIPER
) -> list[Frame]:
    """Return the frames of the answer to a 0x4AF; another arm's answer is not taken as a question.

    Args:
        codec: The arm's codec.
        signals: The signals of the received 0x4AF.
        version: The version, as `S-V1.8-9`.
        model: The arm.
    """
    if signals["Byte0"] != _REQUEST:
        return []
    text = identity_text(version, model)
    chunks = [text[start : start + _FRAME_LENGTH] for start in range(0, len(text), _FRAME_LENGTH)]
    return [
        codec.encode("FirmwareVersion", **{f"Byte{i}": byte for i, byte in enumerate(chunk)})
        for chunk in chunks
    ]
