"""Examines this computer and the bus; each probe returns facts and never raises."""
