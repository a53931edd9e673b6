"""What happens about the model of the arm, as sentences."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.control.events import EventCode

MODEL_NOTICES: Final[Mapping[str, object]] = {
    EventCode.MODEL_OTHER: QT_TRANSLATE_NOOP(
        "Notice",
        "Connected as a {chosen}, but the pose it reports is that of a {fits}. Connect it as a "
        "{fits}.",
    ),
    EventCode.MODEL_NONE: QT_TRANSLATE_NOOP(
        "Notice",
        "The pose the arm reports fits its angles in no model of the family, {chosen} included.",
    ),
    EventCode.MODEL_RECALLED: QT_TRANSLATE_NOOP(
        "Notice",
        "This arm (node {node}) was a {before} the last time: taken instead of {chosen}, which was "
        "only offered.",
    ),
    EventCode.MODEL_WAS_OTHER: QT_TRANSLATE_NOOP(
        "Notice",
        "Connected as a {chosen}, but this arm (node {node}) was a {before} the last time. If it "
        "is one, connect it as that.",
    ),
}
