"""The settings of the program, each declared once: what it means, its default, what it may be.

A new setting is a field of :class:`Settings`: the file (`armui.settings`), the check of a value,
the sentences about it and the window 设置 read it there.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from types import NoneType
from typing import Annotated, Any, Final, Literal, get_args, get_origin, get_type_hints

from armui.arm.json_fields import finite
from armui.arm.refusal import Refusal
from armui.protocol.generation import PiperModel
from armui.setting_checks import (
    JOG_STEP_NOT_A_NUMBER,
    JOG_STEP_OUT_OF_RANGE,
    LONGEST_NAME,
    SETTING_BAD,
    AnyOf,
    GamepadButtons,
    GamepadMode,
    Language,
    MountingName,
    OfEach,
    OrNone,
    PictureDirection,
    Possible,
    SessionFormat,
    ThemeName,
    Whole,
    Within,
    are_buttons,
    is_bool,
    is_name,
    is_path,
    is_pose,
    is_reference,
    is_tool,
    never,
    shown,
    why_no_tool,
)

JOG_STEP_DEG: Final = Within(0.001, 30.0)
"""The steps of a jog, from the resolution of an angle on the bus on."""
JOG_FLOOR_MM: Final = Whole(-500, 500)
ROTATE_MB: Final = Whole(1, 4000)
"""The sizes of a file of a session, up to one that every file system supports."""
LIVE_PORT: Final = Whole(1024, 65_535)


def why_no_jog_step(value: object) -> Refusal:
    """Return why a jog step is not possible."""
    figure = finite(value)
    if figure is None:
        return JOG_STEP_NOT_A_NUMBER(value=shown(value))
    bounds = {"minimum": JOG_STEP_DEG.least, "maximum": JOG_STEP_DEG.most}
    return JOG_STEP_OUT_OF_RANGE(value=figure, **bounds)


@dataclass(frozen=True, slots=True)
class Setting:
    """The label, tip and check of a setting, held by its annotation beside its type.

    ``python -m tests.translations`` collects the texts, in the context "Setting".

    Attributes:
        label: Its name in English, in sentences and in the window 设置.
        possible: Accepts its values; not needed for truth values and choices, whose type says it.
            ``None`` is accepted besides if the type has it.
        tip: What it does, in English, for the window 设置.
        own_reason: Returns its own reason against a value that is not possible, if it has one.
    """

    label: str
    possible: Possible = never
    tip: str = ""
    own_reason: Callable[[object], Refusal] | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Settings:
    """The settings of the program, each with its label and check in its annotation."""

    language: Annotated[Language, Setting("Language")] = "zh"
    """The language of the windows."""

    theme: Annotated[ThemeName, Setting("Theme")] = "light"
    """Light, dark, or as the system."""

    jog_step_deg: Annotated[
        float, Setting("Jog step", JOG_STEP_DEG, own_reason=why_no_jog_step)
    ] = 1.0
    """The step of − and + for a joint."""

    urdf_path: Annotated[str | None, Setting("Robot description (URDF)", is_path)] = None
    """The robot description in the 3D picture; ``None`` for the built-in one."""

    tool: Annotated[
        tuple[float, ...], Setting("Tool centre point", is_tool, own_reason=why_no_tool)
    ] = (0.0,) * 6
    """The tool centre point in the flange: X, Y, Z in mm, RX, RY, RZ in degrees."""

    mountings: Annotated[
        Mapping[str, MountingName],
        Setting("Mounting of each arm", OfEach(AnyOf(get_args(MountingName)))),
    ] = field(default_factory=dict)
    """The mounting last set for each arm, by the adapter's serial number with the arm's node
    number.
    """

    home_poses: Annotated[
        Mapping[str, Sequence[float]], Setting("Park position of each arm", OfEach(is_pose))
    ] = field(default_factory=dict)
    """The operator's own home pose of each arm, six angles in degrees, by the same key."""

    stop_again: Annotated[
        bool,
        Setting(
            "Stop again if another host undoes an emergency stop",
            tip="This is always reported as a fault. With this setting the stop is also sent again "
            "by itself.",
        ),
    ] = False
    """True if an emergency stop that another host undoes is sent again automatically."""

    jog_floor_mm: Annotated[
        int | None,
        Setting(
            "Motions end at a lowest height of the fingertip",
            JOG_FLOOR_MM,
            "Above the floor: the plane the arm stands on, or the room's floor where the cell says "
            "under Base how the arm stands. 0 mm is the floor, negative is below it. "
            "Every motion keeps to it: jogs, steps, single motions, runs and replays. An arm that "
            "is lower may only go up.",
        ),
    ] = None
    """The lowest height of the fingertip over the base plane; ``None`` for any."""

    session_folder: Annotated[str | None, Setting("Folder of the logs", is_path)] = None
    """The folder for recordings of sessions; ``None`` for the user's folder for data."""

    session_format: Annotated[SessionFormat, Setting("Format of the logs")] = ".blf"
    """The suffix of their files."""

    session_rotate_mb: Annotated[int, Setting("Size at which a new file is begun", ROTATE_MB)] = 100
    """A file that has reached this size is followed by another."""

    session_save_at_faults: Annotated[bool, Setting("Saving at faults and stops")] = False
    """True if the last minutes are saved automatically at a fault or a stop."""

    picture_direction: Annotated[PictureDirection, Setting("View of the 3D picture")] = "iso"
    """The first direction of the 3D picture."""

    picture_orthographic: Annotated[bool, Setting("3D picture without perspective")] = False
    """True if it is drawn without perspective."""

    picture_tool_frame: Annotated[bool, Setting("Tool frame in the 3D picture")] = True
    """True if it shows the axes of the tool centre point."""

    picture_trail_s: Annotated[int, Setting("Tool trail in the 3D picture", Whole(0, 600))] = 15
    """The seconds of the tool's way that it shows; 0 for none."""

    gamepad: Annotated[bool, Setting("Jogging by gamepad")] = False
    """True if a gamepad or SpaceMouse may jog the arm."""

    gamepad_mode: Annotated[GamepadMode, Setting("What a gamepad moves")] = "joint"
    """The mode of its axes."""

    gamepad_one_axis: Annotated[bool, Setting("One axis at a time by gamepad")] = True
    """True if only one of them moves at a time."""

    gamepad_buttons: Annotated[
        GamepadButtons,
        Setting("Buttons of the gamepads", OfEach(are_buttons, longest_key=LONGEST_NAME)),
    ] = field(default_factory=dict)
    """The operator's own assignments of its buttons, by device."""

    interface: Annotated[
        bool,
        Setting(
            "Local interface",
            tip="Scripts and other programs of yours may read the arm, and ask you for it. Other "
            "users of this computer and other computers cannot.",
        ),
    ] = False
    """True if the local interface is served."""

    live: Annotated[
        bool,
        Setting(
            "Live stream for Foxglove, on port",
            tip="Shows what is measured, live, in Foxglove and other programs that speak its "
            "WebSocket protocol. They only watch. Every program, web page and user of this "
            "computer can.",
        ),
    ] = False
    """True if the live stream is served."""

    live_port: Annotated[int, Setting("Port of the live stream", LIVE_PORT)] = 8766
    """Its TCP port; 8765, Foxglove's own, is left to other programs."""

    live_for_others: Annotated[
        bool,
        Setting(
            "Live stream for other computers, too",
            tip="Everybody in the network can watch then, without a password and unencrypted.",
        ),
    ] = False
    """True if it is served to other computers, too."""

    models: Annotated[
        Mapping[str, str], Setting("Models of the arms", OfEach(AnyOf(tuple(PiperModel))))
    ] = field(default_factory=dict)
    """The chosen model by the adapter's serial number, with the node number if known; the last
    choice last.
    """

    references: Annotated[
        Mapping[str, Mapping[str, object]],
        Setting("References of the arms", OfEach(is_reference, kept=1000)),
    ] = field(default_factory=dict)
    """What is known of each arm's reference, by the key of `home_poses`; see
    `armui.arm.reference_record`. A doubt that is forgotten may cost an arm: many are kept.
    """

    cells: Annotated[Mapping[str, str], Setting("Cells of the arms", OfEach(is_name))] = field(
        default_factory=dict
    )
    """The name of each arm's cell, by the adapter's serial number; the last choice last."""


def _declared(kind: Any) -> Setting:
    """Return what the annotation of a field says, with the values its type makes possible."""
    base: Any
    said: Setting
    base, said = get_args(kind)
    possible = said.possible
    if base is bool:
        possible = is_bool
    elif get_origin(base) is Literal:
        possible = AnyOf(get_args(base))
    elif NoneType in get_args(base):
        possible = OrNone(possible)
    return replace(said, possible=possible)


DECLARED: Final[Mapping[str, Setting]] = {
    name: _declared(kind) for name, kind in get_type_hints(Settings, include_extras=True).items()
}
"""What is said of each setting, by its name."""

OF_EACH: Final[Mapping[str, OfEach]] = {
    name: each.possible for name, each in DECLARED.items() if isinstance(each.possible, OfEach)
}
"""The settings with an entry for each arm or device, by name."""


def check(name: str, value: object) -> Refusal | None:
    """Return why a setting may not have a value, or ``None`` if it may."""
    declared = DECLARED.get(name)
    if declared is not None and declared.possible(value):
        return None
    if declared is not None and declared.own_reason is not None:
        return declared.own_reason(value)
    return SETTING_BAD(field=name, value=shown(value))
