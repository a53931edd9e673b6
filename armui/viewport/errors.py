"""What can go wrong on the way to a picture."""

from __future__ import annotations

from typing import Final

from armui.arm.refusal import Refusal

LOAD_REFUSALS: Final = frozenset(
    {
        "urdf_missing",  # path
        "urdf_unreadable",  # path, text
        "urdf_not_xml",  # path, text
        "urdf_no_robot",  # path, element
        "urdf_malformed",  # path, text
        "urdf_incomplete",  # path
        "urdf_no_tree",  # path, links
        "urdf_bad_joint",  # path, joint
        "urdf_joint_count",  # path, found, wanted
        "mesh_missing",  # path, mesh
        "mesh_unreadable",  # mesh, text
        "mesh_empty",  # mesh
        "urdf_ends_view",  # path, text
        "urdf_hangs_view",  # path
    }
)
"""Every reason why a robot can't be shown; the user interface has a sentence for each."""

NO_OPENGL: Final = "no_opengl"
"""Code of the one reason the program foresees why nothing can be drawn at all."""

DRAWING_STOPPED: Final = "drawing_stopped"
"""Code of an error while drawing that nobody foresaw; its parameter is ``text``."""

PROCESS_ENDED: Final = "picture_process_ended"
"""Code of a picture's process that has ended by itself; its parameter is ``text``."""

PROCESS_HUNG: Final = "picture_process_hung"
"""Code of a picture's process that gave no sign of life, or got nowhere."""


class SceneError(Exception):
    """The 3D picture can't be made.

    Args:
        code: one of `LOAD_REFUSALS`, or `NO_OPENGL`.
        params: what the sentence names.

    Attributes:
        refusal: the reason, to be put into words by the user interface.
    """

    def __init__(self, code: str, **params: float | int | str) -> None:
        self.refusal = Refusal(code, params)
        super().__init__(str(self.refusal))
