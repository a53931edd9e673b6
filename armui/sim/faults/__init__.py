"""Faults that can be injected into a simulated arm and its cable, and the arm's own protection."""
