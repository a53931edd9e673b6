"""One command's life: sent, answered, read back, refused or timed out."""
