"""The cell in force: chosen, confirmed at each connection, changed and kept."""
