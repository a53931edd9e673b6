"""Recordings of whole sessions, read here for decode, replay and exports alike. No Qt."""
