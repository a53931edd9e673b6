"""Recordings of whole sessions: read here, by decode, replay and exports alike. No Qt."""
