"""Interim."""

import numpy as np


class OwnBody:
    def __init__(self, *a, **k):
        self.pairs = ()
        self.reaches_mm = (900.0,) * 6

    def gaps(self, joints):
        return np.zeros((len(joints), 0))

    def breach(self, *a):
        return None
