"""What can be done in the pages, the drawer and the windows beside them, seen or not."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from armui.control.operations.operation import operation_of
from armui.control.run.player import Player
from armui.ui.actions.command import Command, always
from armui.ui.actions.places import MOVABLE
from armui.ui.words.text import Text

# fmt: off
_IN_PLACE: Final = (
    Command("library.import", target="library_import"),
    Command("library.create", target="library_create"),
    Command("library.record", target="library_record"),
    Command("library.delete", target="library_delete"),
    Command("library.duplicate", target="library_duplicate"),
    Command("library.rename", target="library_rename"),
    Command("library.export", Text("LibraryBar", "Export files"), "library_export"),
    Command("library.bin", Text("BinButton", "Recently deleted…"), "library_bin"),
    Command("library.find", target="library_search"),
    Command("library.undo", target="library_undo"),
    Command("library.by_columns", Text("ColumnsOffer", "Import by columns…"), "library_by_columns"),
    Command("library.report", Text("ReportButton", "Results…"), "library_report"),
    Command("editor.save", target="editor_save"),
    Command("editor.undo", target="editor_undo"),
    Command("editor.redo", target="editor_redo"),
    Command("editor.insert_measured", target="editor_insert_measured"),
    Command("editor.jog", target="editor_jog"),
    Command("editor.go_to", target="editor_go_to", leads=True),
    Command("editor.find", target="editor_find"),
    Command("editor.check", target="editor_check"),
    Command("editor.insert_before", target="action_insert_before"),
    Command("editor.insert_after", target="action_insert_after"),
    Command("editor.replace_by_measured", target="action_replace_by_measured"),
    Command("editor.duplicate", target="action_duplicate"),
    Command("editor.delete", target="action_delete"),
    Command("editor.cut", target="action_cut"),
    Command("editor.copy", target="action_copy"),
    Command("editor.paste", target="action_paste"),
    Command("editor.move_up", target="action_move_up"),
    Command("editor.move_down", target="action_move_down"),
    Command("editor.convert", target="action_convert"),
    Command("recording.record", Text("RecordingPage", "Record"), "record"),
    Command("recording.preview", Text("RecordingPage", "Preview"), "record_preview", leads=True),
    Command("recording.points", Text("RecordingPage", "Save as points"), "save_points"),
    Command("recording.samples", Text("RecordingPage", "Save as recording"), "save_recording"),
    Command("plots.pause", Text("PlotBar", "Pause"), "plot_pause"),
    Command("plots.undo", target="plot_undo"),
    Command("plots.cursors", Text("PlotBar", "Cursors"), "plot_cursors"),
    Command("plots.save", Text("PlotBar", "Save"), "plot_save"),
    Command("plots.csv", Text("PlotBar", "Values as CSV…"), "plot_csv"),
    Command("plots.png", Text("PlotBar", "Picture as PNG…"), "plot_png"),
    Command("plots.svg", Text("PlotBar", "Picture as SVG…"), "plot_svg"),
    Command("plots.copy_picture", Text("PlotBar", "Copy picture"), "plot_copy_picture"),
    Command("plots.copy_values", Text("PlotBar", "Copy values at the cursors"), "plot_copy_values"),
    Command("events.follow", Text("EventBar", "Follow"), "event_follow"),
    Command("events.save", Text("EventBar", "Save"), "event_save"),
    Command("events.csv", Text("EventBar", "Shown events as CSV…"), "event_csv"),
    Command("events.json", Text("EventBar", "Shown events as JSON…"), "event_json"),
    Command("events.txt", Text("EventBar", "Shown events as text…"), "event_txt"),
    Command("events.copy", Text("EventBar", "Copy shown events"), "event_copy"),
    Command("events.commands", Text("EventKind", "Command"), "event_kind_command"),
    Command("events.results", Text("EventKind", "Result"), "event_kind_result"),
    Command("events.status", Text("EventKind", "Status"), "event_kind_status"),
    Command("events.faults", Text("EventKind", "Fault"), "event_kind_fault"),
    Command("events.link", Text("EventKind", "Connection"), "event_kind_link"),
    Command("events.other_host", Text("EventKind", "Other host"), "event_kind_other_host"),
    Command("events.bus", Text("EventKind", "Bus"), "event_kind_oddity"),
    Command("events.program", Text("EventKind", "Program"), "event_kind_program"),
    Command("bus.by_id", Text("FilterBar", "By identifier"), "bus_by_id"),
    Command("bus.in_order", Text("FilterBar", "In order of time"), "bus_in_order"),
    Command("bus.pause", Text("FilterBar", "Pause"), "bus_pause"),
    Command("bus.clear", Text("FilterBar", "Clear"), "bus_clear"),
    Command("bus.only_changed", Text("FilterBar", "Only changed"), "bus_only_changed"),
    Command("bus.only_unknown", Text("FilterBar", "Only unknown or malformed"), "bus_only_unknown"),
    Command("bus.unlock", Text("SendBox", "Hold to send frames by hand"), "bus_unlock",
            risky=True),
    Command("bus.send", Text("SendBox", "Send"), "bus_send", leads=True),
    Command("bus.lock", Text("SendBox", "Lock"), "bus_lock"),
    Command("sessions.record", Text("RecordingCard", "Record"), "session_record"),
    Command("sessions.folder", Text("Action", "Folder of the recordings"), "session_choose_folder"),
    Command("sessions.ring", Text("RingCard", "Save what just happened"), "ring_save"),
    Command("sessions.ring_at_faults", Text("RingCard", "Save by itself at a fault or a stop"),
            "ring_save_at_faults"),
    Command("sessions.replay", Text("SessionsWindow", "Replay"), "session_open"),
    Command("sessions.export", Text("SessionsWindow", "Export…"), "session_export"),
    Command("sessions.rename", Text("SessionsWindow", "Rename"), "session_rename"),
    Command("sessions.delete", Text("SessionsWindow", "Delete"), "session_delete"),
    Command("sessions.other", Text("SessionsWindow", "Replay another log…"), "session_open_other"),
    Command("sessions.show_folder", Text("SessionsWindow", "Show in the file manager"),
            "session_show_folder"),
    Command("connect.model", Text("Action", "Model of the arm"), "model_box"),
    Command("connect.listen_only", Text("ConnectDialog", "Listen only"), "listen_only_box"),
    Command("settings.gamepad", Text("SettingsDialog", "Gamepad…"), "gamepad_button"),
    Command("settings.stop_again",
            Text("SettingsDialog", "Stop again if another host undoes an emergency stop"),
            "stop_again_box"),
    Command("settings.jog_floor",
            Text("SettingsDialog", "Jogs end at a lowest height of the fingertip"),
            "jog_floor_box"),
    Command("view.trail_off", Text("Action", "Way of the tool: off"), "trail_0"),
    Command("view.trail_5", Text("Action", "Way of the tool: last 5 s of motion"), "trail_5"),
    Command("view.trail_15", Text("Action", "Way of the tool: last 15 s of motion"), "trail_15"),
    Command("view.trail_60", Text("Action", "Way of the tool: last 60 s of motion"), "trail_60"),
    Command("view.no_handles", Text("ViewBar", "No handles"), "handles_none"),
    Command("view.handles_base", Text("Action", "Handles at the tool, along the axes of the base"),
            "handles_tool"),
    Command("view.handles_tool", Text("Action", "Handles at the tool, along its own axes"),
            "handles_tool_frame"),
    Command("view.handles_joints", Text("Action", "Handles at the joints"), "handles_joints"),
    Command("view.close_preview", Text("PreviewBar", "Close preview"), "preview_close"),
)

_RUNNING: Final = (
    ("send", Text("RunBar", "Send"), "run_send"),
    ("cycles", Text("RunBar", "How often"), "run_cycles"),
    ("speed", Text("Action", "Speed of the run"), "run_speed"),
    ("first", Text("RunBar", "From row"), "run_first"),
    ("steps", Text("RunBar", "Step by step"), "run_steps"),
)
"""In the library and in the editor."""
_RUNNERS: Final = ("library", "editor")

_MOVES: Final = (
    ("take_out", Text("PageBar", "Own window")),
    ("put_back", Text("PageWindow", "Put back")),
)
# fmt: on


def commands() -> Iterator[Command]:
    """All of them, in the order in which they are listed."""
    yield from _IN_PLACE
    for place in _RUNNERS:
        for act, title, target in _RUNNING:
            does = operation_of(Player.start) if act == "send" else always
            yield Command(f"{place}.{act}", title, target, does)
    for key in MOVABLE:
        for act, title in _MOVES:
            yield Command(f"{key}.{act}", title)
    yield Command("drawer.fold", Text("Drawer", "Fold away"))
