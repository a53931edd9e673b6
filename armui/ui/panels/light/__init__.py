"""灯光控制: the lamps of the joints."""
