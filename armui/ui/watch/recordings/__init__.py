"""The page 日志: the log in the making, and those that were kept."""
