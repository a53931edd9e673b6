"""The operator's view: jog, run and stop stay; settings, editing and deleting are taken away.

It is a comfort and never safety: what stops the arm or brings it to rest is never taken away.
"""

from __future__ import annotations

from fnmatch import fnmatchcase
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QCoreApplication, QEvent

if TYPE_CHECKING:
    from armui.control.operations.operation import Operation

_PROPERTY: Final = "operator_view"
_LEFT: Final = (
    *("jog.*", "motion.*", "tool.*", "run.*", "replay.*", "recorder.*", "planned.*"),
    *("teaching.*", "motors.*", "reference.*", "joints.clear_error"),
    *("gripper.move", "gripper.enable", "gripper.disable", "gripper.clear_error"),
    *("cell.confirm", "cell.hold", "episode.*", "linkage_back_button"),
)
"""The only operations left, and the button that makes the arm obey the stop again."""
_TAKEN: Final = (
    *(
        "window.settings",
        "settings.*",
        "interface.switch",
        "window.backup",
        "*_backup_button",
        "editor.*",
    ),
    *("motion.set_own_home*", "cell.compare", "cell.frame_by_points", "cell.tool_by_points"),
    *("library.import", "library.create", "library.edit", "library.delete", "library.duplicate"),
    *("library.move", "library.rename", "library.by_columns", "library.undo", "library.bin"),
    *("library.folder_menu", "sessions.rename", "sessions.delete", "bus.unlock", "bus.send"),
    *("bin_back", "teaching.assistance"),
    *(f"{panel}.open" for panel in ("light", "joint_settings", "end_limits")),
    *(f"{panel}.open" for panel in ("collision", "motor", "gripper_settings", "end_load")),
)
"""The acts and commands without an operation that are disabled; not the page of that button."""


def operator_view() -> bool:
    """Return whether the program shows the operator's view."""
    app = QCoreApplication.instance()
    return app is not None and app.property(_PROPERTY) is True


def set_operator_view(*, wanted: bool) -> None:
    """Enter or leave the operator's view; every window shows its acts anew."""
    app = QCoreApplication.instance()
    if app is not None and operator_view() != wanted:
        app.setProperty(_PROPERTY, wanted)
        QCoreApplication.postEvent(app, QEvent(QEvent.Type.LanguageChange))


def why_taken(name: str, operation: Operation | None = None) -> str:
    """Return the sentence that the operator's view does not allow something; "" if it does.

    Args:
        name: The name of the command, or of the button of an act without one.
        operation: The operation that it carries out.
    """
    if operation is None:
        taken = any(fnmatchcase(name, each) for each in _TAKEN)
    else:
        names = (name, operation.id)
        taken = not any(fnmatchcase(it, each) for it in names for each in _LEFT)
    if not (taken and operator_view()):
        return ""
    return QCoreApplication.translate("Action", "Operator's view: hold Unlock to change this.")
