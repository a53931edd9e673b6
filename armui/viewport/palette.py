"""The colours of the 3D picture, one small set for each theme."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class ScenePalette:
    """Colours as "#rrggbb".

    Attributes:
        background: the background; floor lines fade into it, and an arm without measured angles is
            mixed with it.
        grid: floor lines.
        text: figures over the picture.
        muted: figures that are stale or not heard.
        accent: the highlighted link, the focus frame.
        axes: X, Y and Z.
        speeds: the slow and the fast parts of a path.
        fault: marks of points that cannot be reached.
        warning: marks of a check's warnings.
        current: the point being approached.
        driven: the measured way of the tool.
        commanded: the commanded way of the tool.
        plate: behind a figure at a point.
    """

    background: str
    grid: str
    text: str
    muted: str
    accent: str
    axes: tuple[str, str, str]
    speeds: tuple[str, str]
    fault: str
    warning: str
    current: str
    driven: str
    commanded: str
    plate: str


LIGHT = ScenePalette(
    background="#f4f6f8",
    grid="#c3cad3",
    text="#1f2733",
    muted="#8a94a2",
    accent="#2f6fde",
    axes=("#d04848", "#3f9a4b", "#3b6fd4"),
    speeds=("#2f6fde", "#e08a1e"),
    fault="#c62828",
    warning="#a15c00",
    current="#1f9d55",
    driven="#0b7a75",
    commanded="#8a4fc7",
    plate="#ffffff",
)

DARK = ScenePalette(
    background="#1d2127",
    grid="#454d58",
    text="#e6e9ee",
    muted="#808a97",
    accent="#5b93f5",
    axes=("#e06c6c", "#62bd6e", "#6a96ee"),
    speeds=("#5b93f5", "#f0a848"),
    fault="#ef5350",
    warning="#f0b35a",
    current="#5fd08d",
    driven="#4fd1c5",
    commanded="#c79bf2",
    plate="#2a3039",
)


def rgb(color: str) -> tuple[float, float, float]:
    """Return red, green and blue in 0–1 of "#rrggbb"."""
    red, green, blue = (int(color[at : at + 2], 16) / 255.0 for at in (1, 3, 5))
    return red, green, blue


def mix(
    first: tuple[float, float, float], second: tuple[float, float, float], share: float
) -> tuple[float, float, float]:
    """Return the colour between two; `share` 0 is the first, 1 the second."""
    red, green, blue = (a + (b - a) * share for a, b in zip(first, second, strict=True))
    return red, green, blue
