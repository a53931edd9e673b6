"""The reasons why a cell is not in force, or cannot be changed now."""

from __future__ import annotations

from armui.arm.refusal import Reason

CELL_NOT_CONFIRMED = Reason(
    "cell_not_confirmed",
    "This adapter was last used with the cell “{name}”. See that it is the arm in front of you, "
    "then confirm the cell, or choose another one under Cell.",
)
CELL_HOLDING_NOT_CONFIRMED = Reason(
    "cell_holding_not_confirmed",
    "This adapter was last used with the cell “{name}”, and the gripper held “{held}”. Confirm "
    "both if they are there; if the gripper is empty, let go under Cell, Held first.",
)
CELL_NOT_READ = Reason(
    "cell_not_read",
    "The cell “{name}” of this adapter could not be read. Choose another one under Cell, or none.",
)
CAPTURE_MOVING = Reason(
    "capture_moving",
    "The arm is not at rest: a pose that is taken now would be wrong. Wait until it stands still.",
)
CAPTURED_OF_ANOTHER = Reason(
    "captured_of_another",
    "The arm was silent or exchanged meanwhile, and may be another one: the points taken before "
    "were dropped. Take them anew.",
)
CAPTURE_STALE = Reason(
    "capture_stale",
    "The pose is not heard any more: nothing was taken. Wait until the arm reports it again.",
)
CELL_NONE = Reason(
    "cell_none", "No cell is chosen. Choose one in the list, or enter a name and press New."
)
CELL_GONE = Reason("cell_gone", "There is no cell “{name}”. Choose one of those in the list.")
CELL_WHILE_MOVING = Reason(
    "cell_while_moving",
    "The arm moves: what its motion was checked with stays until it rests. Wait, or halt it.",
)
HELD_IN_HAND = Reason(
    "held_in_hand",
    "“{name}” is marked as held; this would drop the mark. Let go of it under Held first.",
)
CELL_ALREADY_CONFIRMED = Reason(
    "cell_already_confirmed", "Nothing is to be confirmed: the cell is in force, or there is none."
)
