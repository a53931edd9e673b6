"""Random actions of an operator with company on the bus, and what must hold after each of them.

``python -m tests.safety.fuzz --seed 7 --actions 100`` replays what one seed does.
"""
