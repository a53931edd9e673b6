"""The event log: commands and their outcomes, changes of the arm's status, faults, the bus."""
