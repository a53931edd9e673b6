"""Monitoring the arm over time: curves, events, the bus; recordings, their replay and exports."""
