"""The page 事件: all events, searched, filtered, copied and saved."""
