"""The editor of one trajectory: its table of points, search, findings and drafts."""
