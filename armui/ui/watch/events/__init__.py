"""The page 事件: everything that happened, searched, filtered, copied and saved."""
