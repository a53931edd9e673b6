"""One file for each promise about safety, named by its number: it fails where the code does."""
