"""Any point, trajectory and recording there can be, for property tests."""

from __future__ import annotations

from datetime import UTC

import numpy as np
from hypothesis import strategies as st

from armui.protocol.codes import MoveMode
from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.points.program import (
    JOINT_NAMES,
    LONGEST_NAME,
    POSE_NAMES,
    RANGES,
    WHOLE,
    GripperAngle,
    GripperOpening,
    LightAction,
    Trajectory,
    Waypoint,
)
from armui.trajectory.samples.recording import Recording


def outcome(call, *arguments):
    """What a call returns, or the error it may raise."""
    try:
        return call(*arguments)
    except TrajectoryFileError as error:
        return error


def figure(name: str) -> st.SearchStrategy[float]:
    low, high, _ = RANGES[name]
    if name in WHOLE:
        return st.integers(int(low), int(high))
    return st.floats(low, high) | st.integers(int(low), int(high)).map(float)


TEXT = st.text(st.characters(codec="utf-8", exclude_characters="\0"), max_size=30)
LINE = st.text(st.characters(codec="utf-8", exclude_characters="\0\r\n"), max_size=20)
NAME = st.text(
    st.characters(codec="utf-8", exclude_characters="\0\r\n"), min_size=1, max_size=LONGEST_NAME
).filter(str.strip)
COMMENTS = st.lists(LINE, max_size=2).map(tuple)
JOINTS = st.tuples(*(figure(name) for name in JOINT_NAMES))
POSE = st.tuples(*(figure(name) for name in POSE_NAMES))
GRIPPER = st.one_of(
    st.none(),
    st.builds(GripperOpening, figure("opening"), figure("torque")),
    st.builds(GripperAngle, figure("gripper angle"), figure("gripper speed")),
)
LIGHT = st.none() | st.builds(
    LightAction,
    joint=figure("light joint"),
    red=figure("red"),
    green=figure("green"),
    blue=figure("blue"),
    lamp=figure("lamp"),
)

IN_CELL = st.sampled_from(["Table", "工作台", "a b", "x=1, 2;3", "-", "@"])


def _points(move: MoveMode) -> st.SearchStrategy[Waypoint]:
    return st.builds(
        Waypoint,
        move=st.just(move),
        target=JOINTS if move is MoveMode.MOVE_J else POSE,
        middle=POSE if move is MoveMode.MOVE_C else st.none(),
        speed_percent=figure("speed"),
        dwell_s=figure("dwell"),
        gripper=GRIPPER,
        light=LIGHT,
        note=TEXT,
        comments=COMMENTS,
        frame=st.just("") if move is MoveMode.MOVE_J else st.just("") | IN_CELL,
        holds=st.none() | st.just("") | IN_CELL,
    )


POINTS = st.one_of(
    *(
        _points(move)
        for move in (MoveMode.MOVE_J, MoveMode.MOVE_P, MoveMode.MOVE_L, MoveMode.MOVE_C)
    )
)
MODIFIED = st.datetimes(timezones=st.just(UTC))
TRAJECTORIES = st.builds(
    Trajectory,
    name=NAME,
    note=TEXT,
    points=st.lists(POINTS, max_size=5).map(tuple),
    modified=MODIFIED,
    closing=COMMENTS,
)


@st.composite
def _samples(draw: st.DrawFn) -> np.ndarray:
    rows = draw(
        st.lists(
            st.tuples(
                st.floats(0.0, 1000.0),
                *[figure("J1")] * 6,
                figure("opening") | st.just(float("nan")),
            ),
            max_size=6,
        )
    )
    return np.array(sorted(rows, key=lambda row: row[0]), dtype=np.float64).reshape(-1, 8)


RECORDINGS = st.builds(Recording, name=NAME, note=TEXT, samples=_samples(), modified=MODIFIED)
