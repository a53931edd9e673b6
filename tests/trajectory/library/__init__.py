"""The library: what it lists, keeps, deletes and brings back, whatever others do to its files."""
