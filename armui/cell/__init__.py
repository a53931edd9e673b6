"""The cell around the arm: tools, and what else is fixed to it or stands around it: pure."""
