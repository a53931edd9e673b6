"""Looks at this computer and at the bus; each probe returns facts and never raises."""
