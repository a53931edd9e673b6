"""Import of unknown tables: dialect, columns and units."""
