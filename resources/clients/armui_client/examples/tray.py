"""Visits the places of a tray, row by row, each from above; leaves out what cannot be reached."""

import armui_client

CORNER_MM = (280.0, -60.0, 180.0)
ROWS, COLUMNS = 2, 3
PITCH_MM = 60.0
ABOVE_MM = 40.0
DOWN_DEG = (180.0, 0.0, 180.0)


def places() -> list[tuple[float, float, float]]:
    """Return the places, row by row."""
    x, y, z = CORNER_MM
    return [
        (x + row * PITCH_MM, y + column * PITCH_MM, z)
        for row in range(ROWS)
        for column in range(COLUMNS)
    ]


def visit(arm: armui_client.Arm, place_mm: tuple[float, float, float]) -> str:
    """Visit a place from above; return what became of it."""
    x, y, z = place_mm
    try:
        arm.move_pose((x, y, z + ABOVE_MM, *DOWN_DEG))
        arm.move_line((x, y, z, *DOWN_DEG))
        arm.move_line((x, y, z + ABOVE_MM, *DOWN_DEG))
    except armui_client.Refused as refused:
        return f"left out: {refused}"
    return "visited"


def main() -> None:
    """Visit each place."""
    with (
        armui_client.connect("tray.py") as arm,
        arm.lease("a tray", max_speed_percent=50),
    ):
        if not arm.is_enabled():
            arm.enable()
        for number, place_mm in enumerate(places(), start=1):
            print(f"Place {number}: {visit(arm, place_mm)}")


if __name__ == "__main__":
    main()
