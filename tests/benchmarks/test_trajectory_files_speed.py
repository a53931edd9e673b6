"""How long it takes to open and import 10,000 points, or half an hour recorded at 100 Hz.

Beside each: what the same data costs Python's own json or csv, or numpy's, to read into bare lists.
"""

import csv
import io
import json
import time

import numpy as np
import pytest

from armui.protocol.codes import MoveMode
from armui.trajectory import columns, files
from armui.trajectory.columns import ColumnMapping, ColumnQuantity, TableColumn
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import GripperOpening, LightAction, Trajectory, Waypoint
from armui.trajectory.samples.recording import Recording

POINTS = 10_000
SAMPLES = 180_000
ENTRIES = 300
RUNS = 4
CHANCE = np.random.default_rng(5)


def program():
    joints = np.round(CHANCE.uniform(-90, 90, (POINTS, 6)), 3).tolist()
    return Trajectory(
        "ten thousand",
        points=tuple(
            Waypoint(
                (MoveMode.MOVE_J, MoveMode.MOVE_L)[number % 2],
                tuple(values),
                speed_percent=1 + number % 100,
                dwell_s=0.5,
                gripper=GripperOpening(35.0) if number % 5 == 0 else None,
                light=LightAction(1, 255, 0, 0) if number % 7 == 0 else None,
                note="tray" if number % 3 == 0 else "",
            )
            for number, values in enumerate(joints)
        ),
    )


def recording():
    samples = np.empty((SAMPLES, 8))
    samples[:, 0] = np.arange(SAMPLES) / 100
    samples[:, 1:7] = np.round(CHANCE.uniform(-90, 90, (SAMPLES, 6)), 3)
    samples[:, 7] = 35.0
    return Recording("half an hour", samples=samples)


def seconds(call):
    took = []
    for _ in range(RUNS):
        began = time.perf_counter()
        call()
        took.append(time.perf_counter() - began)
    return min(took)  # other programs only ever add


def rows_of(text, delimiter=","):
    return [
        [float(cell) for cell in row] for row in csv.reader(io.StringIO(text), delimiter=delimiter)
    ]


@pytest.fixture
def report(capsys, benchmark):
    lines = []
    yield lambda *line: lines.append(line)
    benchmark.pedantic(lambda: None, rounds=1)
    with capsys.disabled():
        print()
        for what, ours, beside, other in lines:
            print(f"{what:44} {1e3 * ours:7.0f} ms   {beside}: {1e3 * other:.0f} ms")


def test_ten_thousand_points_from_a_file(tmp_path, report):
    content = program()
    bare = json.dumps([point.target for point in content.points])
    plain = seconds(lambda: json.loads(bare))
    for suffix in files.SUFFIXES:
        path = tmp_path / f"points{suffix}"
        path.write_bytes(files.to_bytes(content, suffix))
        ours = seconds(lambda path=path: files.load(path))
        report(f"{POINTS} points from {suffix}", ours, "json, bare angles", plain)
        assert files.load(path) == content


def test_half_an_hour_from_a_file(tmp_path, report):
    content = recording()
    text = "\n".join(",".join(map(repr, row)) for row in content.samples.tolist())
    plain = seconds(lambda: rows_of(text))
    for suffix in (".npz", *files.SUFFIXES):
        path = tmp_path / f"samples{suffix}"
        path.write_bytes(files.to_bytes(content, suffix))
        ours = seconds(lambda path=path: files.load(path))
        report(f"{SAMPLES} samples from {suffix}", ours, "csv to floats", plain)
        assert files.load(path) == content


def test_half_an_hour_by_columns(report):
    angles = recording().samples[:, :7]
    text = "\n".join(";".join(map(repr, row)) for row in np.radians(angles).tolist())
    names = [TableColumn(ColumnQuantity(f"J{joint}"), "rad") for joint in range(1, 7)]
    mapping = ColumnMapping((TableColumn(ColumnQuantity.TIME, "s"), *names))
    plain = seconds(lambda: rows_of(text, ";"))
    report(f"a sheet of {SAMPLES} rows seen", seconds(lambda: columns.sniff(text)), "csv", plain)
    sheet = columns.sniff(text)
    ours = seconds(lambda: columns.apply(text, sheet, mapping, "x"))
    report(f"{SAMPLES} rows by columns", ours, "csv to floats", plain)
    as_points = ColumnMapping((None, *names), MoveMode.MOVE_J)
    short = text[: text.index("\n", len(text) * POINTS // SAMPLES)]
    ours = seconds(lambda: columns.apply(short, sheet, as_points, "x"))
    report("10000 points by columns", ours, "csv to floats", seconds(lambda: rows_of(short, ";")))
    assert len(columns.apply(text, sheet, mapping, "x").samples) == SAMPLES


def test_the_library(tmp_path, report):
    library = Library(tmp_path)
    content, samples = program(), recording()
    short = Trajectory("short", points=content.points[:5])
    for number in range(ENTRIES):
        library.save(Trajectory(f"short {number}", points=short.points))
    names = sum(1 for _ in tmp_path.iterdir())
    plain = seconds(lambda: [path.read_bytes() for path in tmp_path.glob("*.log")])
    save = seconds(lambda: library.save(content, replacing=content.name))
    report(f"{POINTS} points saved", save, "their bytes written", written(tmp_path / "x", content))
    report(f"{POINTS} points opened", seconds(lambda: library.load(content.name)), "saved", save)
    library.save(samples)
    raw = tmp_path / "raw.npy"
    np.save(raw, samples.samples)
    bare = seconds(lambda: np.load(raw))
    report(
        f"{SAMPLES} samples opened", seconds(lambda: library.load(samples.name)), "np.load", bare
    )
    listed = seconds(lambda: Library(tmp_path).entries())
    report(f"a library of {ENTRIES + 2} listed", listed, "its short files read", plain)
    assert names == ENTRIES + 1
    assert len(library.entries()) == ENTRIES + 2


def written(path, content):
    data = files.to_bytes(content, ".log")
    return seconds(lambda: path.write_bytes(data))
