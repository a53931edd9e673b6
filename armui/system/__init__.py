"""What the program needs of the computer: paths, files, clock, log, helper processes."""
