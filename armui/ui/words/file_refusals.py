"""Every reason against reading, changing or saving something kept: parameters, files, points."""

from __future__ import annotations

from typing import Final

from armui.arm.parameters import KINDS, Parameter
from armui.arm.refusal_codes import RefusalCode
from armui.ui.words.parameters import full_name, value_text
from armui.ui.words.text import Texts

FILE_REFUSALS: Final = Texts("Refusal") | {
    # Parameters of the arm
    RefusalCode.GENERATION_UNKNOWN: (
        "The program is still finding out which protocol the arm speaks. Wait a second."
    ),
    RefusalCode.SETTING_OUT_OF_RANGE: (
        "{parameter}: {value} is out of range. Enter a value from {minimum} to {maximum}."
    ),
    RefusalCode.SETTING_NOT_A_NUMBER: (
        "{parameter}: “{value}” is not a number. Enter a value from {minimum} to {maximum}."
    ),
    RefusalCode.SETTING_NO_CHOICE: "{parameter}: {value} is not possible. Choose one of {choices}.",
    RefusalCode.SETTING_NOT_KEPT: (
        "This arm's protocol (generation {generation}) has no such settings; generation 2 has."
    ),
    RefusalCode.NEEDS_FIRMWARE: (
        "The arm's firmware {firmware} does not have this: it came with {since}. Updates come from "
        "the maker's support."
    ),
    RefusalCode.FIRMWARE_UNKNOWN: (
        "The arm has not named its firmware, and only {since} and later have this. Connect again "
        "to ask for it."
    ),
    RefusalCode.MODE_UNKNOWN: (
        "The arm's control mode is not known, or another one has the command: it would be changed "
        "along with this. Bring the arm to standby or CAN control first."
    ),
    RefusalCode.SETTING_UNKNOWN: (
        "{parameter} would have to be sent along unchanged and has not been read from the arm. "
        "Read it first."
    ),
    RefusalCode.SETTING_CORRUPT: (
        "{parameter} would have to be sent along, and what the arm holds there is corrupt. Enter "
        "a value for it as well."
    ),
    RefusalCode.LIMITS_CROSSED: (
        "Joint {joint}: the min. angle {minimum}° must be below the max. angle {maximum}°. Change "
        "one of them."
    ),
    RefusalCode.SETTING_UNANSWERED: (
        "The arm did not answer (0x476). Nothing says that it took this over: read the values "
        "again, then save once more."
    ),
    RefusalCode.ORDER_TOO_LATE: (
        "Nothing was sent: the arm was still being set or asked something a second after the "
        "press. Try again."
    ),
    RefusalCode.ARM_CHANGED: (
        "The arm was silent meanwhile, or another arm answers: nothing more was sent. See that it "
        "is the right arm, then try again."
    ),
    RefusalCode.SETTING_NOT_READ_BACK: (
        "The arm did not answer when asked for the value: what it holds is not known. Read again."
    ),
    RefusalCode.SETTING_NOT_TAKEN: (
        "{parameter}: {value} was sent and answered, but the arm holds {held}. It did not take "
        "this value; try another one."
    ),
    # Files of 参数备份
    RefusalCode.BACKUP_NO_JSON: (
        "The file is broken or cut short: line {line}, column {column} is no JSON. Nothing was "
        "changed; choose another file, or mend that line."
    ),
    RefusalCode.BACKUP_FOREIGN: (
        "This is not a parameter backup of this program. Nothing was changed; choose another file."
    ),
    RefusalCode.BACKUP_VERSION: (
        "The file has format version {version}; this program reads version {known}. Open it with "
        "the program that wrote it, or update this one."
    ),
    RefusalCode.BACKUP_FIELD_MISSING: (
        "The file lacks the field “{field}”. Nothing was changed; choose another file, or add the "
        "field."
    ),
    RefusalCode.BACKUP_FIELD_BAD: (
        "The file says “{value}” in the field “{field}”, which is not possible. Nothing was "
        "changed; choose another file, or mend the field."
    ),
    RefusalCode.BACKUP_TWICE: (
        "The file names {parameter} a second time, in “{field}”. Nothing was changed; take one of "
        "the two away."
    ),
    RefusalCode.BACKUP_EMPTY: (
        "The file holds no parameter. Nothing was changed; choose another file."
    ),
    RefusalCode.BACKUP_UNREADABLE: "The file {path} cannot be read: {text}. Choose another one.",
    RefusalCode.BACKUP_NOT_WRITTEN: (
        "The backup could not be written to {path}: {text}. Choose another folder."
    ),
    RefusalCode.BACKUP_NOTHING_READ: "Nothing has been read from the arm. Press Read first.",
    # Robot descriptions
    RefusalCode.URDF_MISSING: (
        "Robot description: the file {path} is not there. Choose another file, or use the "
        "built-in one."
    ),
    RefusalCode.URDF_UNREADABLE: (
        "Robot description: the file {path} cannot be read: {text}. Choose a file you may read."
    ),
    RefusalCode.URDF_NOT_XML: (
        "Robot description: {path} is not well-formed XML ({text}). Repair or export it again."
    ),
    RefusalCode.URDF_NO_ROBOT: (
        "Robot description: {path} describes no robot: its first element is “{element}”, not "
        "“robot”. Choose a URDF file."
    ),
    RefusalCode.URDF_MALFORMED: (
        "Robot description: {path} is not written as URDF demands: {text}. Correct it."
    ),
    RefusalCode.URDF_INCOMPLETE: (
        "Robot description: in {path} an element or attribute is missing that URDF demands. Check "
        "that every link, joint and visual is complete."
    ),
    RefusalCode.URDF_NO_TREE: (
        "Robot description: in {path} these links do not hang together as one tree: {links}. Every "
        "link but the first needs exactly one joint that carries it."
    ),
    RefusalCode.URDF_BAD_JOINT: (
        "Robot description: joint “{joint}” in {path} is wrong. It needs a name of its own, a type "
        "and an axis that URDF knows and, if it mimics, a joint to mimic."
    ),
    RefusalCode.URDF_JOINT_COUNT: (
        "Robot description: {path} has {found} revolute joints in a row instead of {wanted}. "
        "Choose the description of a six-joint arm."
    ),
    RefusalCode.MESH_MISSING: (
        "Robot description: the mesh “{mesh}” that {path} names is not there. Put it where the "
        "file says, or correct its name in the file."
    ),
    RefusalCode.MESH_UNREADABLE: (
        "Robot description: the mesh {mesh} cannot be read: {text}. Export it again."
    ),
    RefusalCode.MESH_EMPTY: "Robot description: the mesh {mesh} holds no surface. Export it again.",
    RefusalCode.MESH_KIND_UNKNOWN: (
        "Robot description: the mesh {mesh} is of a kind that is not read. These are: {kinds}."
    ),
    RefusalCode.MESH_FILE_TOO_LARGE: (
        "Robot description: the mesh {mesh} has {size} MB; {most} MB are read at most. Export it "
        "with fewer triangles."
    ),
    RefusalCode.MESH_TOO_LARGE: (
        "Robot description: the mesh {mesh} reaches farther than {most} m, or nowhere. A mesh in "
        "millimetres needs scale 0.001."
    ),
    RefusalCode.URDF_TOO_DETAILED: (
        "Robot description: the meshes of {path} have more than {most} triangles together. Export "
        "them with fewer."
    ),
    RefusalCode.URDF_NO_MEMORY: (
        "Robot description: {path} takes more than {most} MB of memory to load. Export its meshes "
        "with fewer triangles."
    ),
    RefusalCode.URDF_ENDS_VIEW: (
        "Robot description: {path} ended the 3D view while it was loaded ({text}). It is put "
        "aside; choose another one."
    ),
    RefusalCode.URDF_HANGS_VIEW: (
        "Robot description: loading {path} does not come to an end. It is put aside; choose "
        "another one."
    ),
    # Logs to replay
    RefusalCode.REPLAYED_LOG: (
        "This is a recording that is replayed: nothing can be sent. Whatever is to reach an arm is "
        "done in the main window."
    ),
    RefusalCode.REPLAY_EMPTY: (
        "{name} is a log without a single frame: there is nothing to replay. Record again, with "
        "the arm switched on."
    ),
    RefusalCode.REPLAY_NO_LOG: (
        "Nothing in {name} reads as a frame of a CAN log ({text}). Choose the file that the "
        "recording program has written, with its own ending."
    ),
    RefusalCode.REPLAY_NOTHING_READ: (
        "Nothing in {name} reads as a frame of a CAN log of its ending. Choose the file that the "
        "recording program has written, with its own ending."
    ),
    RefusalCode.REPLAY_ARCHIVE: (
        "{name} is a packed archive, whatever its ending says. Unpack it, and open the log that "
        "was in it."
    ),
    RefusalCode.REPLAY_UNKNOWN_KIND: (
        "By its name {name} is no CAN log. Known endings: {known}, most of them also with .gz "
        "behind. Rename the file, or choose another."
    ),
    RefusalCode.REPLAY_UNREADABLE: (
        "{name} cannot be opened: {text}. Look whether it is still there and may be read."
    ),
    RefusalCode.REPLAY_NO_DISK: (
        "The log is read into temporary files, and these cannot be written: {text}. Make room on "
        "the disk, or set TMPDIR to a folder with more."
    ),
    RefusalCode.REPLAY_FAILED: (
        "{name} can be read no further: {text}. Open it again; if that does not help, copy it to "
        "another disk first."
    ),
    # Recordings of the session
    RefusalCode.SESSION_RECORDED: (
        "The session is being recorded already. Stop that recording first."
    ),
    RefusalCode.SESSION_NONE: "The session is not being recorded: there is nothing to stop.",
    RefusalCode.SESSION_NO_MF4: "MF4 needs the package asammdf (pip install asammdf).",
    RefusalCode.SESSION_MF4_CALLED_OFF: (
        "You called it off. The recording itself is whole, as .blf."
    ),
    RefusalCode.SESSION_SAVING: "The last minutes are being saved already. Wait a moment.",
    RefusalCode.SESSION_RING_EMPTY: (
        "Nothing has been heard on the bus yet: there is nothing to save."
    ),
    RefusalCode.SESSION_DISK_FULL: (
        "The disk of {folder} is full. What was written before can be read. Free some room or "
        "choose another folder, then record again."
    ),
    RefusalCode.SESSION_READ_ONLY: (
        "The folder {folder} cannot be written. Choose another folder for the session recordings, "
        "or allow this one to be written."
    ),
    RefusalCode.SESSION_FOLDER_GONE: (
        "The folder {folder}, or its disk, is gone. Plug it in again or choose another folder, "
        "then record again."
    ),
    RefusalCode.SESSION_FAILED: (
        "The session could not be recorded in {folder}: {text}. What was written before can be "
        "read. Choose another folder, or try again."
    ),
    RefusalCode.SESSION_NAME_BAD: (
        '“{name}” cannot be the name of a recording. Leave out / \\ : * ? " < > | and a dot at '
        "the beginning or the end; 120 characters at most."
    ),
    RefusalCode.SESSION_NAME_TAKEN: (
        "There is a file called “{name}” in the folder already. Choose another name."
    ),
    RefusalCode.SESSION_GONE: (
        "The recording “{name}” is not in the folder any more, or cannot be read: {text}."
    ),
    RefusalCode.SESSION_IN_USE: "“{name}” is still being written. Stop the recording first.",
    # Files of trajectories
    RefusalCode.FILE_GONE: "It is not in the library any more.",
    RefusalCode.FILE_UNREADABLE: "The file cannot be read: {text}.",
    RefusalCode.FILE_TOO_LARGE: "The file has {value} MB; files up to {maximum} MB are read.",
    RefusalCode.FILE_NOT_TEXT: "This is no text in UTF-8 or GBK. Save it as a text file in UTF-8.",
    RefusalCode.FILE_NOT_ENCODING: "This is no text in {value}. Choose another encoding.",
    RefusalCode.FILE_KIND_UNKNOWN: (
        "This is no trajectory file the program knows. Import it by columns."
    ),
    RefusalCode.FILE_NO_TABLE: (
        "No rows of numbers are found here. Choose a file with one point a row."
    ),
    RefusalCode.FILE_VERSION: (
        "The file is of version {value}; this program reads up to version {maximum}. Update the "
        "program."
    ),
    RefusalCode.FILE_EMPTY: "The file holds nothing.",
    RefusalCode.FILE_CUT_OFF: "The file ends too early.",
    RefusalCode.FILE_DAMAGED: "The file is damaged: {text}.",
    RefusalCode.LINE_UNKNOWN: "“{value}” is no kind of line. A line begins with J, P, L, C or #.",
    RefusalCode.HEADER_UNKNOWN: "“{value}” is no entry of the header; name, note and modified are.",
    RefusalCode.OPTION_UNKNOWN: (
        "“{value}” is no option of a point; speed, dwell, gripper, light and note are."
    ),
    RefusalCode.OPTION_TWICE: "“{value}” is given twice. Leave one.",
    RefusalCode.OPTION_BAD: "“{value}” is no {field}. Write it as {example}.",
    RefusalCode.NUMBER_BAD: "“{value}” is not a number.",
    RefusalCode.VALUES_COUNT: "{value} numbers where {expected} belong.",
    RefusalCode.TEXT_UNCLOSED: "The closing quotation mark is missing.",
    RefusalCode.COLUMN_MISSING: "The column “{field}” is missing.",
    RefusalCode.COLUMN_UNKNOWN: "The column “{value}” is unknown.",
    RefusalCode.COLUMN_TWICE: "The column “{field}” is there twice.",
    RefusalCode.CELLS_COUNT: "{value} cells where there are {expected} columns.",
    RefusalCode.TIME_BAD: "“{value}” is no date and time. Write it as 2026-01-31T12:00:00.",
    RefusalCode.JSON_BAD: "This is not valid JSON: {text}.",
    RefusalCode.JSON_FIELD_MISSING: "“{field}” is missing.",
    RefusalCode.JSON_FIELD_UNKNOWN: "“{value}” is unknown.",
    RefusalCode.JSON_FIELD_BAD: "“{field}” is not what it should be: {expected}.",
    # Points of trajectories
    RefusalCode.POINT_OUT_OF_RANGE: (
        "{field}: {value}{unit} is out of range. Enter a value from {minimum}{unit} to "
        "{maximum}{unit}."
    ),
    RefusalCode.POINT_NOT_A_NUMBER: "{field}: “{value}” is not a number.",
    RefusalCode.POINT_NOT_WHOLE: "{field}: {value} is not a whole number.",
    RefusalCode.POINT_INCOMPLETE: (
        "{field}: {value} values; six belong there, and a middle only to MOVE C."
    ),
    RefusalCode.POINT_MOVE_UNKNOWN: (
        "“{value}” is no kind of motion. MOVE J, MOVE P, MOVE L and MOVE C are."
    ),
    RefusalCode.SAMPLE_BACK_IN_TIME: "The time {value} s is before the one above, {minimum} s.",
    RefusalCode.TEXT_TOO_LONG: "{field}: {value} characters; up to {maximum} are kept. Shorten it.",
    RefusalCode.TEXT_BAD: "{field}: holds a character that cannot be kept. Remove it.",
    RefusalCode.CONVERT_NEEDS_MIDDLE: (
        "An arc needs a middle pose, which no conversion can know. Enter it by hand."
    ),
    RefusalCode.CONVERT_OUT_OF_REACH: (
        "The arm cannot bring its flange to X {x}  Y {y}  Z {z} mm with this orientation: no joint "
        "angles belong to it. Change the pose."
    ),
    # The library of trajectories
    RefusalCode.NAME_EMPTY: "A trajectory needs a name. Enter one.",
    RefusalCode.NAME_TOO_LONG: (
        "The name has {value} characters; up to {maximum} are kept. Shorten it."
    ),
    RefusalCode.NAME_TAKEN: "There is a “{name}” already. Choose another name.",
    RefusalCode.CHANGED_SINCE: (
        "“{name}” has been changed since it was made, and is kept. Delete it if you do not want it."
    ),
    RefusalCode.DELETED_GONE: (
        "“{name}” is no longer among what was deleted. It has been brought back already, or its "
        "time was up."
    ),
    RefusalCode.LIBRARY_DAMAGED: (
        "The file of “{name}” is damaged and is not written over. Save under another name."
    ),
    RefusalCode.LIBRARY_NOT_SAVED: (
        "“{name}” was not saved: {text}. What was kept before is unchanged. Check the disk, then "
        "save again."
    ),
    RefusalCode.LIBRARY_NOT_DELETED: (
        "Not deleted: {name}: {text}. Check the rights to the library's folder."
    ),
    RefusalCode.LIBRARY_NOT_RESTORED: (
        "Not brought back: {name}: {text}. Check the rights to the library's folder."
    ),
    RefusalCode.LIBRARY_UNREADABLE: (
        "The library cannot be read: {name}: {text}. Check the rights to this folder."
    ),
    # Tables imported by columns
    RefusalCode.COLUMNS_TWICE: (
        "Columns {first} and {second} are both {field}. Leave one of them out."
    ),
    RefusalCode.COLUMNS_MISSING: "Still missing: {missing}. Say which columns hold them.",
    RefusalCode.COLUMNS_UNIT: (
        "Column {column}: {field} is not given in “{value}”. Choose one of {choices}."
    ),
}

SETTING_NAMES: Final = Texts("SettingName") | {
    "language": "language",
    "theme": "theme",
    "jog_step_deg": "jog step",
    "jog_floor_mm": "lowest height for jogs",
    "models": "models of the arms",
    "urdf_path": "robot description",
    "tool": "tool centre point",
    "gamepad": "jogging by gamepad",
    "gamepad_mode": "what a gamepad moves",
    "gamepad_one_axis": "one axis at a time by gamepad",
    "gamepad_buttons": "buttons of the gamepads",
    "session_folder": "folder of the session recordings",
    "session_format": "format of the session recordings",
    "session_rotate_mb": "size at which a new file is begun",
    "picture_direction": "view of the 3D picture",
    "picture_orthographic": "3D picture without perspective",
    "picture_tool_frame": "tool frame in the 3D picture",
    "picture_trail_s": "way of the tool in the 3D picture",
    "session_save_at_faults": "saving at faults and stops",
}
"""By the field of `armui.settings.Settings`."""

_FIGURES: Final = Texts("PointFigure") | {
    "speed": "Speed",
    "dwell": "Dwell",
    "opening": "Gripper opening",
    "torque": "Gripper torque",
    "gripper": "Gripper opening",
    "gripper angle": "Gripper angle",
    "gripper speed": "Gripper speed",
    "light joint": "Light, joint",
    "lamp": "Light, lamp",
    "red": "Light, R",
    "green": "Light, G",
    "blue": "Light, B",
    "target": "Target",
    "middle": "Middle pose",
    "t": "Time",
    "time": "Time",
    "wait": "Time since the row before",
    "note": "Note",
    "name": "Name",
    "comment": "Comment",
    "taught_on": "Arm it was taught on",
}
_OF_FIGURES: Final = ("point_", "text_", "columns_")
"""How the codes begin whose field is a figure of a point, and not a word of a file."""
_CLOSE_UNITS: Final = ("", "°", "%")


def point_figure(name: str) -> str:
    """What a figure of a point is called: a key of ``program.RANGES``, or a text of it."""
    return _FIGURES.word(name)


def with_figures(code: str, params: dict[str, object]) -> dict[str, object]:
    """The figures of a sentence about a point, as the operator reads them."""
    if not code.startswith(_OF_FIGURES):
        return params
    words = dict(params)
    if isinstance(field := params.get("field"), str):
        words["field"] = point_figure(field)
    if isinstance(unit := params.get("unit"), str):
        words["unit"] = unit if unit in _CLOSE_UNITS else f" {unit}"
    if isinstance(missing := params.get("missing"), str):
        words["missing"] = ", ".join(map(point_figure, missing.split(", ")))
    return words


def with_units(params: dict[str, object]) -> dict[str, object]:
    """Figures of a sentence about a parameter, as the operator reads them."""
    name = params.get("parameter")
    if name is None:
        return params
    if not isinstance(name, str) or name not in KINDS:
        return params
    joint = params.get("joint")
    words = dict(params)
    words["parameter"] = full_name(Parameter(name, joint if isinstance(joint, int) else 0))
    for key in ("value", "held", "minimum", "maximum"):
        value = params.get(key)
        if isinstance(value, int | float):
            words[key] = value_text(name, value)
    return words
