"""What happened: commands and what became of them, changes of the arm's status, faults, the bus."""
