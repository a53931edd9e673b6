"""Every reason why a robot description cannot be shown."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.arm.refusal_codes import RefusalCode

ROBOT_REFUSALS: Final[Mapping[RefusalCode, object]] = {
    RefusalCode.URDF_MISSING: QT_TRANSLATE_NOOP(
        "Refusal",
        "Robot description: the file {path} is not there. Choose another file, or use the "
        "built-in one.",
    ),
    RefusalCode.URDF_UNREADABLE: QT_TRANSLATE_NOOP(
        "Refusal",
        "Robot description: the file {path} cannot be read: {text}. Choose a file you may read.",
    ),
    RefusalCode.URDF_NOT_XML: QT_TRANSLATE_NOOP(
        "Refusal",
        "Robot description: {path} is not well-formed XML ({text}). Repair or export it again.",
    ),
    RefusalCode.URDF_NO_ROBOT: QT_TRANSLATE_NOOP(
        "Refusal",
        "Robot description: {path} describes no robot: its first element is “{element}”, not "
        "“robot”. Choose a URDF file.",
    ),
    RefusalCode.URDF_MALFORMED: QT_TRANSLATE_NOOP(
        "Refusal", "Robot description: {path} is not written as URDF demands: {text}. Correct it."
    ),
    RefusalCode.URDF_INCOMPLETE: QT_TRANSLATE_NOOP(
        "Refusal",
        "Robot description: in {path} an element or attribute is missing that URDF demands. Check "
        "that every link, joint and visual is complete.",
    ),
    RefusalCode.URDF_NO_TREE: QT_TRANSLATE_NOOP(
        "Refusal",
        "Robot description: in {path} these links do not hang together as one tree: {links}. Every "
        "link but the first needs exactly one joint that carries it.",
    ),
    RefusalCode.URDF_BAD_JOINT: QT_TRANSLATE_NOOP(
        "Refusal",
        "Robot description: joint “{joint}” in {path} is wrong. It needs a name of its own, a type "
        "and an axis that URDF knows and, if it mimics, a joint to mimic.",
    ),
    RefusalCode.URDF_JOINT_COUNT: QT_TRANSLATE_NOOP(
        "Refusal",
        "Robot description: {path} has {found} revolute joints in a row instead of {wanted}. "
        "Choose the description of a six-joint arm.",
    ),
    RefusalCode.MESH_MISSING: QT_TRANSLATE_NOOP(
        "Refusal",
        "Robot description: the mesh “{mesh}” that {path} names is not there. Put it where the "
        "file says, or correct its name in the file.",
    ),
    RefusalCode.MESH_UNREADABLE: QT_TRANSLATE_NOOP(
        "Refusal", "Robot description: the mesh {mesh} cannot be read: {text}. Export it again."
    ),
    RefusalCode.MESH_EMPTY: QT_TRANSLATE_NOOP(
        "Refusal", "Robot description: the mesh {mesh} holds no surface. Export it again."
    ),
    RefusalCode.URDF_ENDS_VIEW: QT_TRANSLATE_NOOP(
        "Refusal",
        "Robot description: {path} ended the 3D view while it was loaded ({text}). It is put "
        "aside; choose another one.",
    ),
    RefusalCode.URDF_HANGS_VIEW: QT_TRANSLATE_NOOP(
        "Refusal",
        "Robot description: loading {path} does not come to an end. It is put aside; choose "
        "another one.",
    ),
}
