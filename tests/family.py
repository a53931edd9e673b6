"""The arms of the family, for tests: what is true of one shall be true of all."""

from armui.arm.models import all_models, model_data
from armui.kinematics.geometry import Geometry
from armui.protocol.generation import PiperModel

MODELS = tuple(PiperModel)
PIPER = model_data(PiperModel.PIPER).geometry
PIPER_BEFORE_V1_6_3 = model_data(PiperModel.PIPER).older_geometry

FACTORY_LIMITS = model_data(PiperModel.PIPER).limits
FACTORY_ACCELERATION_DEG_S2 = model_data(PiperModel.PIPER).accelerations_deg_s2[0]
"""Of a PiPER, the same for all its joints."""

GEOMETRIES: dict[str, Geometry] = {
    f"{model}{suffix}": geometry
    for model, data in all_models().items()
    for suffix, geometry in zip(("", "-older"), data.geometries, strict=True)
}
"""All of them by name, in both conventions of the zeros."""


def ranges(model: PiperModel) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """The lowest and the highest angles of a model's joints."""
    limits = model_data(model).limits
    return tuple(each.min_deg for each in limits), tuple(each.max_deg for each in limits)
