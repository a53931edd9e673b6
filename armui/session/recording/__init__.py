"""Sessions of our own, written while they happen: the ring in memory, the files, their index."""
