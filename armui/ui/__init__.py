"""The windows: they show the state they are given and call the controller, never the bus."""

from armui.ui.override_guard import guard_overrides

guard_overrides()  # before the first widget class is defined: only later classes are guarded
