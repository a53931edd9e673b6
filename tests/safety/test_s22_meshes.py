"""S22, S24: no mesh fills the memory; the window says why, and shows another arm or the one before.

Each file is a real one, loaded by the picture's own process; its memory is read from the system.
"""

import bz2
import io
import sys
import tarfile
import zipfile
from pathlib import Path
from typing import Any

import pytest
import trimesh

from armui.ui import words
from armui.viewport.process.frame_painter import URDF_NO_MEMORY
from armui.viewport.process.urdf_file import (
    MESH_EMPTY,
    MESH_FILE_TOO_LARGE,
    MESH_KIND_UNKNOWN,
    MESH_TOO_LARGE,
    MESH_UNREADABLE,
    URDF_BAD_JOINT,
    URDF_MALFORMED,
    URDF_TOO_DETAILED,
)
from armui.viewport.view import ArmView
from tests.viewport.bad_meshes import write_glb_of_zeros, write_stl
from tests.viewport.foreign import ARM, joint, link, mesh, write_arm
from tests.waiting import LIMIT_MS, wait_until

pytestmark = [
    pytest.mark.skipif(sys.platform != "linux", reason="reads /proc; address space is limited"),
    pytest.mark.timeout(600),
]

CORNERS_M = (0.0, 0.0, 0.0, 0.1, 0.0, 0.0, 0.0, 0.1, 0.0)
FOUR_BILLION = 0xFFFFFFFF
NOT_A_NUMBER = float("nan")
MOST_GROWN_MB = 2600
"""What loading may take, and what the libraries do that read meshes."""


@pytest.fixture(scope="module")
def shown(qapp):
    view = ArmView()
    view.resize(500, 400)
    view.set_joints((30.0, 70.0, -60.0, 20.0, 40.0, 10.0), 35.0)
    view.show()
    wait_until(lambda: view.is_settled)
    yield view
    view.shutdown()
    view.close()
    view.deleteLater()


@pytest.fixture(autouse=True)
def no_thread_outlives_the_test():
    """The view is the module's."""


def peak_mb(pid: int) -> int:
    """The most memory a process has had so far."""
    lines = Path(f"/proc/{pid}/status").read_text("ascii").splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith("VmHWM")) // 1024


def one_link(folder: Path, visual: str) -> Path:
    """An arm of which one link has a picture."""
    links = "".join(link(f"l{number}", visual if number == 3 else "") for number in range(7))
    joints = "".join(joint(f"j{each}", f"l{each - 1}", f"l{each}") for each in range(1, 7))
    path = folder / "arm.urdf"
    path.write_text(ARM.format(links=links, joints=joints, extra=""), encoding="utf-8")
    return path


def claims_four_billion(folder):
    write_stl(folder / "m.stl", claimed=FOUR_BILLION, corners_m=CORNERS_M)
    return one_link(folder, mesh("m.stl")), {MESH_UNREADABLE, MESH_EMPTY}


def claims_four_billion_and_is_as_long(folder):
    """A file with a hole in it: as long as it claims, and next to nothing on the disk."""
    write_stl(folder / "m.stl", claimed=FOUR_BILLION)
    with (folder / "m.stl").open("r+b") as file:
        file.truncate(84 + 50 * FOUR_BILLION)
    return one_link(folder, mesh("m.stl")), {MESH_FILE_TOO_LARGE}


def a_million_and_a_half(folder):
    write_stl(folder / "m.stl", claimed=1_500_000)
    with (folder / "m.stl").open("r+b") as file:
        file.truncate(84 + 50 * 1_500_000)
    return one_link(folder, mesh("m.stl")), {URDF_TOO_DETAILED}


def many_of_one(folder):
    """One mesh of half a megabyte, named two hundred times."""
    write_stl(folder / "m.stl", claimed=10_000, corners_m=CORNERS_M * 10_000)
    path = one_link(folder, mesh("m.stl") * 200)
    return path, {URDF_TOO_DETAILED}


def vertices_that_are_nowhere(folder):
    write_glb_of_zeros(folder / "m.glb", 3_000_000_000)
    return one_link(folder, mesh("m.glb")), {URDF_NO_MEMORY}


def vertices_just_within_memory(folder):
    write_glb_of_zeros(folder / "m.glb", 90_000_000)
    refused = {URDF_NO_MEMORY, MESH_EMPTY, URDF_MALFORMED}
    return one_link(folder, mesh("m.glb")), refused


def faces_of_far_vertices(folder):
    lines = ["v 0 0 0", "v 0.1 0 0", "v 0 0.1 0", "f 1 2 4000000000"]
    (folder / "m.obj").write_text("\n".join(lines), encoding="ascii")
    refused = {MESH_UNREADABLE, MESH_EMPTY, URDF_MALFORMED}
    return one_link(folder, mesh("m.obj")), refused | {URDF_NO_MEMORY}


def entities_in_entities(folder):
    """XML that is two billion characters when it is read to its end."""
    entities = ['<!ENTITY e0 "0 1 2 ">']
    entities += [f'<!ENTITY e{n} "{f"&e{n - 1};" * 10}">' for n in range(1, 10)]
    text = f"<!DOCTYPE COLLADA [{''.join(entities)}]><COLLADA><a>&e9;</a></COLLADA>"
    (folder / "m.dae").write_text(text, encoding="ascii")
    return one_link(folder, mesh("m.dae")), {MESH_UNREADABLE, MESH_EMPTY}


def archive(kind):
    """Four gigabytes of zeros, as small as they get."""

    def write(folder):
        name = f"m.{kind}"
        zeros = bytes(50_000_000)
        if kind == "bz2":
            (folder / name).write_bytes(bz2.compress(zeros) * 80)
        elif kind == "tar.gz":
            with tarfile.open(folder / name, "w:gz") as tar:
                info = tarfile.TarInfo("m.stl")
                info.size = len(zeros)
                tar.addfile(info, io.BytesIO(zeros))
        else:
            with (
                zipfile.ZipFile(folder / name, "w", zipfile.ZIP_DEFLATED) as packed,
                packed.open("m.stl", "w", force_zip64=True) as file,
            ):
                for _ in range(20):
                    file.write(zeros)
        return one_link(folder, mesh(name)), {MESH_KIND_UNKNOWN}

    write.__name__ = f"archive_{kind}"
    return write


def scaled_to_1e30(folder):
    write_stl(folder / "m.stl", claimed=1, corners_m=CORNERS_M)
    return one_link(folder, mesh("m.stl", "1e30 1e30 1e30")), {MESH_TOO_LARGE}


def scaled_by_nothing_that_is_a_number(folder):
    write_stl(folder / "m.stl", claimed=1, corners_m=CORNERS_M)
    return one_link(folder, mesh("m.stl", "nan 1 1")), {MESH_TOO_LARGE}


def corners_that_are_no_numbers(folder):
    write_stl(folder / "m.stl", claimed=1, corners_m=(NOT_A_NUMBER, *CORNERS_M[1:]))
    refused = {MESH_TOO_LARGE, MESH_EMPTY, MESH_UNREADABLE}
    return one_link(folder, mesh("m.stl")), refused | {URDF_MALFORMED}


def links_a_light_year_apart(folder):
    path = write_arm(folder)
    text = path.read_text(encoding="utf-8").replace('xyz="0 0 0.1"', 'xyz="0 0 1e16"', 1)
    path.write_text(text, encoding="utf-8")
    return path, {URDF_BAD_JOINT}


def a_box_of_1e30(folder):
    box = '<visual><geometry><box size="1e30 1 1"/></geometry></visual>'
    return one_link(folder, box), {MESH_TOO_LARGE}


@pytest.mark.parametrize(
    "write",
    [
        claims_four_billion,
        claims_four_billion_and_is_as_long,
        a_million_and_a_half,
        many_of_one,
        vertices_that_are_nowhere,
        vertices_just_within_memory,
        faces_of_far_vertices,
        entities_in_entities,
        archive("zip"),
        archive("3mf"),
        archive("zae"),
        archive("bz2"),
        archive("tar.gz"),
        scaled_to_1e30,
        scaled_by_nothing_that_is_a_number,
        corners_that_are_no_numbers,
        links_a_light_year_apart,
        a_box_of_1e30,
    ],
    ids=lambda write: write.__name__,
)
def test_what_would_fill_the_memory_is_refused_and_the_arm_before_stays(
    shown, qtbot, tmp_path, write
):
    view = shown
    path, codes = write(tmp_path)
    losses: list[Any] = []
    view._client.lost.connect(losses.append)
    pid, before = view._client.pid, view._picture.image.copy()
    peak_before_mb = peak_mb(pid)
    with qtbot.waitSignal(view.load_failed, timeout=LIMIT_MS) as failed:
        view.set_robot(path)
    wait_until(lambda: view._lost is None and view.is_settled)
    said = words.refusal(failed.args[0])
    assert failed.args[0].reason in codes, said
    assert any(word in said for word in (str(tmp_path), "m.", "joint", "l3"))
    assert not losses
    assert view._client.pid == pid
    assert peak_mb(pid) - peak_before_mb < MOST_GROWN_MB
    assert view._picture.image.copy() == before
    view._client.lost.disconnect(losses.append)


def test_two_hundred_thousand_triangles_are_shown(shown, tmp_path):
    """The limit is one for bombs, not for what makers export."""
    view = shown
    trimesh.creation.icosphere(subdivisions=7, radius=0.05).export(tmp_path / "m.stl")
    refused: list[Any] = []
    view.load_failed.connect(refused.append)
    view.set_robot(one_link(tmp_path, mesh("m.stl")))
    wait_until(lambda: refused or view.is_settled)
    assert [words.refusal(each) for each in refused] == []
    assert view._client.shape.points[3] != ()
    view.load_failed.disconnect(refused.append)
