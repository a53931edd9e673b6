"""回放: a log shown as if it were live, and unmistakably not."""
