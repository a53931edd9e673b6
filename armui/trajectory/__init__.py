"""Programs of motion: points, recordings, files, library, planning, checks; no Qt, no bus."""
