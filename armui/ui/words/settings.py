"""The names of settings, and what they do, as the operator reads them."""

from __future__ import annotations

from armui.setting_fields import DECLARED
from armui.ui.words.text import Text


def setting_label(name: str) -> Text:
    """Return the name of a setting by that of its field."""
    return Text("Setting", DECLARED[name].label)


def setting_tip(name: str) -> Text:
    """Return what a setting does; empty if nothing is said of it."""
    return Text("Setting", DECLARED[name].tip)
