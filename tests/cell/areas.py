"""Work areas for tests, and how deep an arm is in one."""

from armui.arm.models import model_data
from armui.cell.area_check import AreaCheck, carried_body
from armui.cell.cell import Cell
from armui.cell.work_area import Area, AreaBox, AreaPlane
from armui.protocol.generation import PiperModel
from tests.accepted import accepted

TABLE = AreaPlane("table")
"""The arm stays above the plane that it stands on."""


def wall(x_mm):
    """Nothing may be beyond this X."""
    return AreaPlane("wall", (x_mm, 0.0, 0.0, 0.0, -90.0, 0.0))


def area_of(*zones, margin_mm=10.0):
    planes = tuple(zone for zone in zones if isinstance(zone, AreaPlane))
    boxes = tuple(zone for zone in zones if isinstance(zone, AreaBox))
    return Area(planes, boxes, margin_mm)


def check_of(*zones, margin_mm=10.0, model=PiperModel.PIPER):
    geometry = model_data(model).geometry
    body = carried_body(model, geometry, (0.0,) * 6, None)
    return AreaCheck(area_of(*zones, margin_mm=margin_mm), body)


def put(controller, *zones, margin_mm=10.0):
    """Put a work area in force, as the operator does."""
    area = area_of(*zones, margin_mm=margin_mm)
    if controller.cell.cell is None:
        accepted(controller.cell.take(Cell("bench", area=area)))
    else:
        accepted(controller.cell.change(Cell("bench", area=area)))


def gap_mm(joints_deg, *zones):
    """How near the arm is to any of them; below 0 it is inside."""
    return check_of(*zones).nearest_entries(joints_deg)[0].gap_mm
