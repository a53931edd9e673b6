"""What can be done in the pages, the drawer and the windows beside them, seen or not."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

# fmt: off
_IN_PLACE: Final = (
    ("library.import", "LibraryBar", QT_TRANSLATE_NOOP("LibraryBar", "Import files"),
     "library_import"),
    ("library.create", "LibraryBar", QT_TRANSLATE_NOOP("LibraryBar", "Create"), "library_create"),
    ("library.record", "LibraryBar", QT_TRANSLATE_NOOP("LibraryBar", "Record"), "library_record"),
    ("library.delete", "LibraryBar", QT_TRANSLATE_NOOP("LibraryBar", "Delete"), "library_delete"),
    ("library.duplicate", "LibraryBar", QT_TRANSLATE_NOOP("LibraryBar", "Duplicate"),
     "library_duplicate"),
    ("library.rename", "LibraryBar", QT_TRANSLATE_NOOP("LibraryBar", "Rename"), "library_rename"),
    ("library.export", "LibraryBar", QT_TRANSLATE_NOOP("LibraryBar", "Export files"),
     "library_export"),
    ("library.bin", "BinButton", QT_TRANSLATE_NOOP("BinButton", "Recently deleted…"),
     "library_bin"),
    ("library.find", "LibraryBar", QT_TRANSLATE_NOOP("LibraryBar", "Search"), "library_search"),
    ("library.undo", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Undo"), "library_undo"),
    ("library.by_columns", "ColumnsOffer", QT_TRANSLATE_NOOP("ColumnsOffer", "Import by columns…"),
     "library_by_columns"),
    ("library.report", "ReportButton", QT_TRANSLATE_NOOP("ReportButton", "Results…"),
     "library_report"),
    ("editor.save", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Save"), "editor_save"),
    ("editor.undo", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Undo"), "editor_undo"),
    ("editor.redo", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Redo"), "editor_redo"),
    ("editor.insert_measured", "EditorAction",
     QT_TRANSLATE_NOOP("EditorAction", "Insert current pose"), "editor_insert_measured"),
    ("editor.jog", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Jog"), "editor_jog"),
    ("editor.go_to", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Go to this point"),
     "editor_go_to"),
    ("editor.find", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Find and replace"),
     "editor_find"),
    ("editor.check", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Check"), "editor_check"),
    ("editor.insert_before", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Insert before"),
     "action_insert_before"),
    ("editor.insert_after", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Insert after"),
     "action_insert_after"),
    ("editor.replace_by_measured", "EditorAction",
     QT_TRANSLATE_NOOP("EditorAction", "Replace by current pose"), "action_replace_by_measured"),
    ("editor.duplicate", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Duplicate"),
     "action_duplicate"),
    ("editor.delete", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Delete"),
     "action_delete"),
    ("editor.cut", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Cut"), "action_cut"),
    ("editor.copy", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Copy"), "action_copy"),
    ("editor.paste", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Paste"), "action_paste"),
    ("editor.move_up", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Move up"),
     "action_move_up"),
    ("editor.move_down", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Move down"),
     "action_move_down"),
    ("editor.convert", "EditorAction",
     QT_TRANSLATE_NOOP("EditorAction", "Convert joint angles ↔ pose"), "action_convert"),
    ("recording.record", "RecordingPage", QT_TRANSLATE_NOOP("RecordingPage", "Record"), "record"),
    ("recording.preview", "RecordingPage", QT_TRANSLATE_NOOP("RecordingPage", "Preview"),
     "record_preview"),
    ("recording.points", "RecordingPage", QT_TRANSLATE_NOOP("RecordingPage", "Save as points"),
     "save_points"),
    ("recording.samples", "RecordingPage", QT_TRANSLATE_NOOP("RecordingPage", "Save as recording"),
     "save_recording"),
    ("plots.pause", "PlotBar", QT_TRANSLATE_NOOP("PlotBar", "Pause"), "plot_pause"),
    ("plots.undo", "PlotBar", QT_TRANSLATE_NOOP("PlotBar", "Undo zoom"), "plot_undo"),
    ("plots.cursors", "PlotBar", QT_TRANSLATE_NOOP("PlotBar", "Cursors"), "plot_cursors"),
    ("plots.save", "PlotBar", QT_TRANSLATE_NOOP("PlotBar", "Save"), "plot_save"),
    ("plots.csv", "PlotBar", QT_TRANSLATE_NOOP("PlotBar", "Values as CSV…"), "plot_csv"),
    ("plots.png", "PlotBar", QT_TRANSLATE_NOOP("PlotBar", "Picture as PNG…"), "plot_png"),
    ("plots.svg", "PlotBar", QT_TRANSLATE_NOOP("PlotBar", "Picture as SVG…"), "plot_svg"),
    ("plots.copy_picture", "PlotBar", QT_TRANSLATE_NOOP("PlotBar", "Copy picture"),
     "plot_copy_picture"),
    ("plots.copy_values", "PlotBar", QT_TRANSLATE_NOOP("PlotBar", "Copy values at the cursors"),
     "plot_copy_values"),
    ("events.follow", "EventBar", QT_TRANSLATE_NOOP("EventBar", "Follow"), "event_follow"),
    ("events.save", "EventBar", QT_TRANSLATE_NOOP("EventBar", "Save"), "event_save"),
    ("events.csv", "EventBar", QT_TRANSLATE_NOOP("EventBar", "Shown events as CSV…"), "event_csv"),
    ("events.json", "EventBar", QT_TRANSLATE_NOOP("EventBar", "Shown events as JSON…"),
     "event_json"),
    ("events.txt", "EventBar", QT_TRANSLATE_NOOP("EventBar", "Shown events as text…"),
     "event_txt"),
    ("events.copy", "EventBar", QT_TRANSLATE_NOOP("EventBar", "Copy shown events"), "event_copy"),
    ("events.commands", "EventKind", QT_TRANSLATE_NOOP("EventKind", "Command"),
     "event_kind_command"),
    ("events.results", "EventKind", QT_TRANSLATE_NOOP("EventKind", "Result"),
     "event_kind_result"),
    ("events.status", "EventKind", QT_TRANSLATE_NOOP("EventKind", "Status"),
     "event_kind_status"),
    ("events.faults", "EventKind", QT_TRANSLATE_NOOP("EventKind", "Fault"), "event_kind_fault"),
    ("events.link", "EventKind", QT_TRANSLATE_NOOP("EventKind", "Connection"), "event_kind_link"),
    ("events.other_host", "EventKind", QT_TRANSLATE_NOOP("EventKind", "Other host"),
     "event_kind_other_host"),
    ("events.bus", "EventKind", QT_TRANSLATE_NOOP("EventKind", "Bus"), "event_kind_oddity"),
    ("events.program", "EventKind", QT_TRANSLATE_NOOP("EventKind", "Program"),
     "event_kind_program"),
    ("bus.by_id", "FilterBar", QT_TRANSLATE_NOOP("FilterBar", "By identifier"), "bus_by_id"),
    ("bus.in_order", "FilterBar", QT_TRANSLATE_NOOP("FilterBar", "In order of time"),
     "bus_in_order"),
    ("bus.pause", "FilterBar", QT_TRANSLATE_NOOP("FilterBar", "Pause"), "bus_pause"),
    ("bus.clear", "FilterBar", QT_TRANSLATE_NOOP("FilterBar", "Clear"), "bus_clear"),
    ("bus.only_changed", "FilterBar", QT_TRANSLATE_NOOP("FilterBar", "Only changed"),
     "bus_only_changed"),
    ("bus.only_unknown", "FilterBar", QT_TRANSLATE_NOOP("FilterBar", "Only unknown or malformed"),
     "bus_only_unknown"),
    ("bus.unlock", "SendBox", QT_TRANSLATE_NOOP("SendBox", "Hold to send frames by hand"),
     "bus_unlock"),
    ("bus.send", "SendBox", QT_TRANSLATE_NOOP("SendBox", "Send"), "bus_send"),
    ("bus.lock", "SendBox", QT_TRANSLATE_NOOP("SendBox", "Lock"), "bus_lock"),
    ("sessions.record", "RecordingCard", QT_TRANSLATE_NOOP("RecordingCard", "Record"),
     "session_record"),
    ("sessions.folder", "Action", QT_TRANSLATE_NOOP("Action", "Folder of the recordings"),
     "session_choose_folder"),
    ("sessions.ring", "RingCard", QT_TRANSLATE_NOOP("RingCard", "Save what just happened"),
     "ring_save"),
    ("sessions.ring_at_faults", "RingCard",
     QT_TRANSLATE_NOOP("RingCard", "Save by itself at a fault or a stop"), "ring_save_at_faults"),
    ("sessions.replay", "SessionsWindow", QT_TRANSLATE_NOOP("SessionsWindow", "Replay"),
     "session_open"),
    ("sessions.export", "SessionsWindow", QT_TRANSLATE_NOOP("SessionsWindow", "Export…"),
     "session_export"),
    ("sessions.rename", "SessionsWindow", QT_TRANSLATE_NOOP("SessionsWindow", "Rename"),
     "session_rename"),
    ("sessions.delete", "SessionsWindow", QT_TRANSLATE_NOOP("SessionsWindow", "Delete"),
     "session_delete"),
    ("sessions.other", "SessionsWindow", QT_TRANSLATE_NOOP("SessionsWindow", "Replay another log…"),
     "session_open_other"),
    ("sessions.show_folder", "SessionsWindow",
     QT_TRANSLATE_NOOP("SessionsWindow", "Show in the file manager"), "session_show_folder"),
    ("connect.model", "Action", QT_TRANSLATE_NOOP("Action", "Model of the arm"), "model_box"),
    ("connect.listen_only", "ConnectDialog", QT_TRANSLATE_NOOP("ConnectDialog", "Listen only"),
     "listen_only_box"),
    ("settings.gamepad", "SettingsDialog", QT_TRANSLATE_NOOP("SettingsDialog", "Gamepad…"),
     "gamepad_button"),
    ("settings.stop_again", "SettingsDialog",
     QT_TRANSLATE_NOOP("SettingsDialog", "Stop again if another host undoes an emergency stop"),
     "stop_again_box"),
    ("view.trail_off", "Action", QT_TRANSLATE_NOOP("Action", "Way of the tool: off"), "trail_0"),
    ("view.trail_5", "Action", QT_TRANSLATE_NOOP("Action", "Way of the tool: last 5 s of motion"),
     "trail_5"),
    ("view.trail_15", "Action",
     QT_TRANSLATE_NOOP("Action", "Way of the tool: last 15 s of motion"), "trail_15"),
    ("view.trail_60", "Action",
     QT_TRANSLATE_NOOP("Action", "Way of the tool: last 60 s of motion"), "trail_60"),
    ("view.no_handles", "ViewBar", QT_TRANSLATE_NOOP("ViewBar", "No handles"), "handles_none"),
    ("view.handles_base", "Action",
     QT_TRANSLATE_NOOP("Action", "Handles at the tool, along the axes of the base"),
     "handles_tool"),
    ("view.handles_tool", "Action",
     QT_TRANSLATE_NOOP("Action", "Handles at the tool, along its own axes"), "handles_tool_frame"),
    ("view.handles_joints", "Action", QT_TRANSLATE_NOOP("Action", "Handles at the joints"),
     "handles_joints"),
    ("view.close_preview", "PreviewBar", QT_TRANSLATE_NOOP("PreviewBar", "Close preview"),
     "preview_close"),
)

_RUNNING: Final = (
    ("send", "RunBar", QT_TRANSLATE_NOOP("RunBar", "Send"), "run_send"),
    ("cycles", "RunBar", QT_TRANSLATE_NOOP("RunBar", "How often"), "run_cycles"),
    ("speed", "Action", QT_TRANSLATE_NOOP("Action", "Speed of the run"), "run_speed"),
    ("first", "RunBar", QT_TRANSLATE_NOOP("RunBar", "From row"), "run_first"),
    ("steps", "RunBar", QT_TRANSLATE_NOOP("RunBar", "Step by step"), "run_steps"),
)
"""In the library and in the editor."""
_RUNNERS: Final = ("library", "editor")

MOVABLE: Final = ("library", "editor", "recording", "plots", "events", "bus")
"""The pages that can be taken out into a window, by their keys."""

_MOVES: Final = (
    ("take_out", "PageBar", QT_TRANSLATE_NOOP("PageBar", "Own window")),
    ("put_back", "PageWindow", QT_TRANSLATE_NOOP("PageWindow", "Put back")),
)
# fmt: on


def rows() -> Iterator[tuple[str, str, str, str]]:
    """Of each command its name, the context and the English text of its title, its target."""
    for name, context, source, target in _IN_PLACE:
        yield name, context, str(source), target
    for place in _RUNNERS:
        for act, context, source, target in _RUNNING:
            yield f"{place}.{act}", context, str(source), target
    for key in MOVABLE:
        for act, context, source in _MOVES:
            yield f"{key}.{act}", context, str(source), ""
    yield "drawer.fold", "Drawer", str(QT_TRANSLATE_NOOP("Drawer", "Fold away")), ""
