"""录制: the window that records, trims and keeps."""
