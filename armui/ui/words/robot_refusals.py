"""Every reason why a robot description cannot be shown."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

ROBOT_REFUSALS: Final[Mapping[str, object]] = {
    "urdf_missing": QT_TRANSLATE_NOOP(
        "Refusal",
        "Robot description: the file {path} is not there. Choose another file, or use the "
        "built-in one.",
    ),
    "urdf_unreadable": QT_TRANSLATE_NOOP(
        "Refusal",
        "Robot description: the file {path} cannot be read: {text}. Choose a file you may read.",
    ),
    "urdf_not_xml": QT_TRANSLATE_NOOP(
        "Refusal",
        "Robot description: {path} is not well-formed XML ({text}). Repair or export it again.",
    ),
    "urdf_no_robot": QT_TRANSLATE_NOOP(
        "Refusal",
        "Robot description: {path} describes no robot: its first element is “{element}”, not "
        "“robot”. Choose a URDF file.",
    ),
    "urdf_malformed": QT_TRANSLATE_NOOP(
        "Refusal",
        "Robot description: {path} is not written as URDF demands: {text}. Correct it.",
    ),
    "urdf_incomplete": QT_TRANSLATE_NOOP(
        "Refusal",
        "Robot description: in {path} an element or attribute is missing that URDF demands. Check "
        "that every link, joint and visual is complete.",
    ),
    "urdf_no_tree": QT_TRANSLATE_NOOP(
        "Refusal",
        "Robot description: in {path} these links do not hang together as one tree: {links}. Every "
        "link but the first needs exactly one joint that carries it.",
    ),
    "urdf_bad_joint": QT_TRANSLATE_NOOP(
        "Refusal",
        "Robot description: joint “{joint}” in {path} is wrong. It needs a name of its own, a type "
        "and an axis that URDF knows and, if it mimics, a joint to mimic.",
    ),
    "urdf_joint_count": QT_TRANSLATE_NOOP(
        "Refusal",
        "Robot description: {path} has {found} revolute joints in a row instead of {wanted}. "
        "Choose the description of a six-joint arm.",
    ),
    "mesh_missing": QT_TRANSLATE_NOOP(
        "Refusal",
        "Robot description: the mesh “{mesh}” that {path} names is not there. Put it where the "
        "file says, or correct its name in the file.",
    ),
    "mesh_unreadable": QT_TRANSLATE_NOOP(
        "Refusal",
        "Robot description: the mesh {mesh} cannot be read: {text}. Export it again.",
    ),
    "mesh_empty": QT_TRANSLATE_NOOP(
        "Refusal",
        "Robot description: the mesh {mesh} holds no surface. Export it again.",
    ),
    "urdf_ends_view": QT_TRANSLATE_NOOP(
        "Refusal",
        "Robot description: {path} ended the 3D view while it was loaded ({text}). It is put "
        "aside; choose another one.",
    ),
    "urdf_hangs_view": QT_TRANSLATE_NOOP(
        "Refusal",
        "Robot description: loading {path} does not come to an end. It is put aside; choose "
        "another one.",
    ),
}
