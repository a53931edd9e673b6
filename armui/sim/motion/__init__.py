"""Carries out motion commands in the simulated arm: MOVE J, P, L, C, MIT, drag teaching."""
