"""Emergency stop, interlocks, commands of other hosts, speed supervision and guided recovery."""
