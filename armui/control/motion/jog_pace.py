"""The limits of a jog's speed and of the lead of its setpoints, so that it ends in time.

A jog is a stream of joint setpoints. Whatever ends the stream, the arm goes on to the last one and
rests there; no further word is needed. A joint with the acceleration ``a`` that is never asked to
go further than ``v·τ`` ahead of where it is needs at most ``τ + v/a`` to come to rest there:

- from a standstill, reaching ``v``, going on with it and braking takes ``D/v + v/a`` for a way
  ``D``, and a faster joint or a shorter way takes less;
- a joint that is already on its way to a setpoint ahead of it is nearer to the end still.

With ``τ`` = 45 ms and ``v ≤ a·45 ms`` that is 90 ms. The last 10 ms of the promised 100 ms belong
to the way of a frame through the program and over the bus. At the factory's 5 rad/s² a joint is
jogged at up to 12.9 °/s. To go on evenly the lead must also cover braking, ``v/(2a)``, and the time
between two setpoints: 22.5 ms are left for that one, and a stream that is later only goes slower.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from armui.arm.limits import JointLimits
from armui.arm.state import Reading

HORIZON_S: Final = 0.045
"""τ: a setpoint leads by at most the way a joint goes in this time."""

BRAKING_S: Final = 0.045
"""A joint is jogged at most as fast as it can brake from in this time."""

REST_S: Final = HORIZON_S + BRAKING_S
"""The arm rests within this time after the last setpoint was heard."""

_LEAST_SHARE: Final = 0.1
"""The smallest share of the lead, whatever the speed: it must span some protocol steps."""


@dataclass(frozen=True, slots=True)
class Pace:
    """The present limits of a jog, joint 1 first.

    Attributes:
        share: The share of the highest jog speed that the speed percentage allows, 0–1.
        speeds_deg_s: The greatest speed of each joint's setpoint.
        leads_deg: The greatest lead of each setpoint over the joint.
        arm_percent: The speed percentage the arm is given (0x151 byte 2): its own limit, just
            above the jog's, so that it runs evenly from setpoint to setpoint.
    """

    share: float
    speeds_deg_s: tuple[float, ...]
    leads_deg: tuple[float, ...]
    arm_percent: int


def pace(
    percent: float, limits: Sequence[JointLimits], accelerations_deg_s2: Sequence[float]
) -> Pace:
    """Return the pace at a speed percentage.

    Args:
        percent: 0–100, of the highest jog speed.
        limits: The limits of the six joints.
        accelerations_deg_s2: Highest acceleration of the six joints; see :func:`accelerations`.
    """
    share = percent / 100.0
    caps_deg_s = [
        min(each.max_speed_deg_s, acceleration * BRAKING_S)
        for each, acceleration in zip(limits, accelerations_deg_s2, strict=True)
    ]
    lead_share = max(share, _LEAST_SHARE)
    arm_percent = max(
        math.ceil(100.0 * lead_share * cap / each.max_speed_deg_s)
        for each, cap in zip(limits, caps_deg_s, strict=True)
    )
    return Pace(
        share=share,
        speeds_deg_s=tuple(share * cap for cap in caps_deg_s),
        leads_deg=tuple(lead_share * cap * HORIZON_S for cap in caps_deg_s),
        arm_percent=min(arm_percent, 100),
    )


def accelerations(
    heard: Sequence[Reading[float] | None], factory: Sequence[float]
) -> tuple[float, ...]:
    """Return the accelerations to plan braking with: as read, but at most the factory's.

    A corrupted flash reports far too high values; an arm that brakes harder than this only rests
    sooner.

    Args:
        heard: The accelerations read from the arm, of the six joints, in °/s².
        factory: Those of the arm's model.
    """
    return tuple(
        most if each is None or each.value <= 0.0 else min(each.value, most)
        for each, most in zip(heard, factory, strict=True)
    )
