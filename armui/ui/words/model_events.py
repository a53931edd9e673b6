"""What happens about the model of the arm, as sentences."""

from __future__ import annotations

from typing import Final

from armui.control.events import EventCode
from armui.ui.words.text import Texts

MODEL_NOTICES: Final[Texts[str]] = Texts("Notice") | {
    EventCode.MODEL_OTHER: (
        "Connected as a {chosen}, but the pose it reports is that of a {fits}. Connect it as a "
        "{fits}."
    ),
    EventCode.MODEL_NONE: (
        "The pose the arm reports fits its angles in no model of the family, {chosen} included."
    ),
    EventCode.MODEL_RECALLED: (
        "This arm (node {node}) was a {before} the last time: taken instead of {chosen}, which was "
        "only offered."
    ),
    EventCode.MODEL_WAS_OTHER: (
        "Connected as a {chosen}, but this arm (node {node}) was a {before} the last time. If it "
        "is one, connect it as that."
    ),
}
