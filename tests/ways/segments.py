"""How far apart two segments are."""

import numpy as np

from armui.ways.own_body import _apart


def segment_distances(a, b, c, d):
    """(n,) of the segments a–b and c–d, all (n, 3)."""
    return np.linalg.norm(_apart(a, b, c, d), axis=1)
