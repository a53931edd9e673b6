"""The window 会话记录: recording the session, and what was recorded."""
