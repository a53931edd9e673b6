"""Gaps between an arm's capsules and planes or boxes, one after the other, to compare with."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from armui.cell.clearance import segment_box_supports
from armui.cell.enclosure import Body
from armui.kinematics.forward import link_frames

Array = npt.NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Capsules:
    """The capsules of an arm at some poses, in the base frame, in mm.

    Attributes:
        parts: The part of each of k.
        starts, ends: (n, k, 3).
        radii: (k,).
    """

    parts: tuple[str, ...]
    starts: Array
    ends: Array
    radii: Array


def plane_gaps(capsules: Capsules, frames: Array) -> Array:
    """Return (n, k, p) the gaps between n × k capsules and p planes.

    Args:
        capsules: The capsules.
        frames: (p, 4, 4) a frame on each plane, in mm; its Z axis points to the free side.
    """
    normals, places = frames[:, :3, 2], frames[:, :3, 3]
    heights = np.einsum("pi,pi->p", normals, places)
    nearest = np.minimum(capsules.starts @ normals.T, capsules.ends @ normals.T)
    gaps: Array = nearest - heights - capsules.radii[:, None]
    return gaps


def box_gaps(capsules: Capsules, frames: Array, sizes_mm: Array) -> Array:
    """Return (n, k, b) the gaps between n × k capsules and b boxes.

    Args:
        capsules: The capsules.
        frames: (b, 4, 4) the frame of each box's centre, in mm.
        sizes_mm: (b, 3) its edges along the axes of that frame.
    """
    gaps = np.empty((*capsules.starts.shape[:2], len(frames)))
    for index, (frame, size) in enumerate(zip(frames, sizes_mm, strict=True)):
        begin = (capsules.starts - frame[:3, 3]) @ frame[:3, :3]
        along = (capsules.ends - capsules.starts) @ frame[:3, :3]
        found = segment_box_supports(begin.reshape(-1, 3), along.reshape(-1, 3), size / 2.0)[:, 0]
        gaps[..., index] = found.reshape(begin.shape[:2]) - capsules.radii
    return gaps


def enclose(body: Body, joints_deg: Array) -> Capsules:
    """Return where the capsules of an arm are at (n, 6) joint angles."""
    frames = link_frames(body.geometry, joints_deg)
    of_link = np.array([each.link for each in body.capsules], dtype=np.int64)
    ends = np.array([(each.start_mm, each.end_mm) for each in body.capsules])
    shape = (len(joints_deg), len(body.capsules), 2, 3)
    placed = np.empty(shape)
    for link in np.unique(of_link).tolist():
        which = of_link == link
        turned = ends[which].reshape(-1, 3) @ frames[:, link, :3, :3].swapaxes(-1, -2)
        turned += frames[:, link, None, :3, 3]
        placed[:, which] = turned.reshape(len(joints_deg), -1, 2, 3)
    radii = np.array([each.radius_mm for each in body.capsules])
    parts = tuple(each.part for each in body.capsules)
    return Capsules(parts, placed[:, :, 0], placed[:, :, 1], radii)
