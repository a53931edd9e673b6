"""The window 会话记录: recording of the session, and the recordings."""
