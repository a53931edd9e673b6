"""When the program ends with an arm, the memory of its curves goes back to the system."""

from __future__ import annotations

import numpy as np

from armui.telemetry.memory import zeros
from armui.telemetry.quantities import RECORDS
from armui.telemetry.series import Series


def test_a_series_gives_its_memory_back_and_can_begin_anew():
    shape = RECORDS[0].shape
    series = Series(shape)
    row = (1,) * (len(shape.figures) + len(shape.codes))
    for k in range(100):
        series.write(float(k), row)
    assert series.bytes_kept > 0
    series.release()
    assert series.bytes_kept == 0
    assert series.latest(next(iter((*shape.figures, *shape.codes)))) is None
    series.write(1000.0, row)
    assert series.bytes_kept > 0


def test_an_ended_controller_keeps_no_samples(rig):
    rig.ready()
    rig.run(0.5)
    assert rig.controller.telemetry.bytes_kept > 0
    rig.controller.shutdown()
    assert rig.controller.telemetry.bytes_kept == 0


def test_large_and_small_arrays_are_zero_and_can_be_written():
    for count in (10, 1_000_000):
        array = zeros((2, count), "f4")
        assert array.shape == (2, count)
        assert not array.any()
        array[1, -1] = 3.0
        assert np.count_nonzero(array) == 1
