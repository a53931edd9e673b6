"""Recordings of our own, written during a session: the ring in memory, the files, their index."""
