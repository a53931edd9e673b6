"""The loads on the joints: the arm's masses, its payload, its mounting, pushes from outside."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from math import radians
from typing import Final

from armui.protocol.codes import EndLoad, Mounting
from armui.sim.mechanics.rigid_body import DOWN, RigidBody, RigidLink, piper_links

PAYLOADS_KG: Final = {EndLoad.EMPTY: 0.0, EndLoad.HALF: 0.75, EndLoad.FULL: 1.5}
"""The masses for the words of 0x477 byte 4; 1.5 kg is the arm's payload, half of it is half."""

DOWN_BY_MOUNTING: Final = {
    Mounting.LEVEL: DOWN,
    Mounting.ON_THE_LEFT_SIDE: (0.0, 1.0, 0.0),
    Mounting.ON_THE_RIGHT_SIDE: (0.0, -1.0, 0.0),
    Mounting.UPSIDE_DOWN: (0.0, 0.0, 1.0),
}
"""The direction of gravity in the base frame; for an arm on its left side it is the Y axis."""


@dataclass(slots=True)
class Weight:
    """The loads on the joints: zeros, payload, mounting, and pushes from outside.

    Attributes:
        links: The arm's links and their masses.
        zeros_deg: Each joint's zero, counted from the factory's.
        payload_kg: Mass at the flange.
        told_kg: Mass at the flange as set by the host; the arm's own gravity model uses it.
        down: The direction of gravity in the base frame.
        pushes_nm: The torque added to each joint from outside.
    """

    links: tuple[RigidLink, ...] = field(default_factory=piper_links)
    zeros_deg: Sequence[float] = field(default_factory=lambda: (0.0,) * 6)
    payload_kg: float = 0.0
    told_kg: float = 0.0
    down: tuple[float, float, float] = DOWN
    pushes_nm: tuple[float, ...] = (0.0,) * 6
    _bodies: dict[float, RigidBody] = field(
        default_factory=dict, init=False, repr=False, compare=False
    )

    @property
    def body(self) -> RigidBody:
        """The arm with the load at its flange."""
        return self._body(self.payload_kg)

    def true_deg(self, joints_deg: Sequence[float]) -> list[float]:
        """Return joint angles counted from the factory's zeros."""
        return [angle + zero for angle, zero in zip(joints_deg, self.zeros_deg, strict=True)]

    def torques_nm(self, joints_deg: Sequence[float]) -> tuple[float, ...]:
        """Return the torque of gravity and pushes on each joint; positive: to larger angles."""
        torques_nm = self._gravity_nm(self.payload_kg, joints_deg)
        if not any(self.pushes_nm):
            return torques_nm
        return tuple(a + b for a, b in zip(torques_nm, self.pushes_nm, strict=True))

    def expected_nm(self, joints_deg: Sequence[float]) -> tuple[float, ...]:
        """Return the torques by the arm's own model: the payload set by the host, no pushes."""
        return self._gravity_nm(self.told_kg, joints_deg)

    def _gravity_nm(self, payload_kg: float, joints_deg: Sequence[float]) -> tuple[float, ...]:
        joints_rad = tuple(map(radians, self.true_deg(joints_deg)))
        return self._body(payload_kg).gravity_torques_nm(joints_rad, self.down)

    def _body(self, payload_kg: float) -> RigidBody:
        """Return the arm with a load; kept by load, as hashing the links takes too long."""
        body = self._bodies.get(payload_kg)
        if body is None:
            body = self._bodies[payload_kg] = _body(self.links, payload_kg)
        return body


@lru_cache(maxsize=64)
def _body(links: tuple[RigidLink, ...], payload_kg: float) -> RigidBody:
    return RigidBody(links, payload_kg)
