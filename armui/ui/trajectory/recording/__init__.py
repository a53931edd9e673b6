"""录制: the page that records, trims and keeps."""
