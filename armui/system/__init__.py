"""The program's access to the computer: paths, files, clock, log, helper processes."""
