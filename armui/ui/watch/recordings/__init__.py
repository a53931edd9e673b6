"""The page 日志: the log being recorded, and the stored ones."""
