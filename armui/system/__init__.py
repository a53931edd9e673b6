"""What the program needs of the computer: files, clock, log, helper processes."""
