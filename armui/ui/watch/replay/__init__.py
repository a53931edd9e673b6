"""回放: a log shown as if it were live, but clearly marked as a replay."""
