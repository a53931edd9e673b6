"""Every reason why a robot description cannot be shown."""

from __future__ import annotations

from typing import Final

from armui.arm.refusal_codes import RefusalCode
from armui.ui.words.text import Texts

ROBOT_REFUSALS: Final = Texts("Refusal") | {
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
}
