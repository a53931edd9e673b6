"""The arms of the family as data files."""

import json
import math

import pytest

from armui.arm.models import (
    LINK_NAMES,
    ModelFileError,
    all_models,
    model_data,
    model_folder,
    read_model,
)
from armui.kinematics.geometry import Geometry, GeometryError, Wrist
from armui.protocol.generation import PiperModel
from tests.family import MODELS

MASSES_KG = {
    PiperModel.PIPER: 4.16,
    PiperModel.PIPER_H: 4.167,
    PiperModel.PIPER_L: 4.167,
    PiperModel.PIPER_X: 4.307,
}


@pytest.fixture
def changed(tmp_path):
    """Writes a model's file with a field changed, and reads it."""

    def change(field, value):
        fields = json.loads((model_folder(PiperModel.PIPER) / "model.json").read_bytes())
        *way, last = field.split(".")
        place = fields
        for step in way:
            place = place[int(step)] if step.isdigit() else place[step]
        place[last] = value
        (tmp_path / "model.json").write_text(json.dumps(fields))
        return read_model(tmp_path)

    return change


@pytest.mark.parametrize("model", MODELS)
def test_a_file_tells_of_its_own_model(model):
    data = model_data(model)

    assert data.model is model
    assert data.name == model.value.replace("piper", "PiPER").replace("_", " ").upper().replace(
        "PIPER", "PiPER"
    )
    assert sum(link.mass_kg for link in data.links) == pytest.approx(MASSES_KG[model])
    assert tuple(link.name for link in data.links) == LINK_NAMES
    assert data.gripper.turned_deg == (90.0 if model is PiperModel.PIPER_X else 0.0)
    assert (data.geometry.wrist is Wrist.PARALLEL) == (model is PiperModel.PIPER_X)


def test_the_ranges_are_those_of_the_table():
    wrists = {
        model: [each.max_deg for each in data.limits[3:]] for model, data in all_models().items()
    }
    assert wrists == {
        PiperModel.PIPER: [100.0, 70.0, 120.0],
        PiperModel.PIPER_H: [135.0, 89.5, 180.0],
        PiperModel.PIPER_L: [127.0, 89.5, 180.0],
        PiperModel.PIPER_X: [89.0, 89.0, 170.0],
    }
    assert set(model_data().accelerations_deg_s2) == {math.degrees(5.0)}
    assumed = {model for model, data in all_models().items() if data.speeds_assumed}
    assert assumed == set(MODELS) - {PiperModel.PIPER}


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize(
    ("version", "older"),
    [
        ("S-V1.5-2", True),
        ("S-V1.6-2", True),
        ("S-V1.6-3", False),
        ("S-V1.10-0", False),
        ("unreadable", False),
    ],
)
def test_firmware_before_1_6_3_has_its_zeros_2_degrees_elsewhere(model, version, older):
    data = model_data(model)
    geometry = data.geometry_of(version)

    shifts = [
        then.theta_deg - now.theta_deg
        for then, now in zip(geometry.rows, data.geometry.rows, strict=True)
    ]
    assert shifts == pytest.approx([0, -2, 2, 0, 0, 0] if older else [0] * 6)


@pytest.mark.parametrize(
    ("field", "value", "says"),
    [
        ("id", "nero", "one of piper, piper_h, piper_l, piper_x"),
        ("format", 2, "one of 1"),
        ("dh.2.alpha_deg", 5.0, "no closed form"),
        ("dh.2.a_mm", -285.0, "longer than 0"),
        ("dh.1.d_mm", 3.0, "no closed form"),
        ("dh", [], "a list of 6"),
        ("links.3.name", "link4", "link3"),
        ("links.3.mass_kg", "heavy", "0.0"),
        ("torque.b", [1, 2], "6 × 0.0"),
        ("gripper.turned", 90, "gripper.turned is unknown"),
        ("name", None, "name"),
        ("speeds", "guessed", "known or assumed"),
    ],
)
def test_a_wrong_field_is_named_with_the_file(changed, tmp_path, field, value, says):
    with pytest.raises(ModelFileError) as error:
        changed(field, value)

    assert str(tmp_path / "model.json") in str(error.value)
    assert says in str(error.value)


def test_a_missing_file_is_named(tmp_path):
    with pytest.raises(ModelFileError, match=r"model\.json"):
        read_model(tmp_path / "nowhere")


def test_what_is_no_table_is_no_geometry():
    rows = [list(row) for row in model_data().geometry.rows]
    with pytest.raises(GeometryError, match="5 rows"):
        Geometry.from_dh(rows[:5])
    rows[3][2] = math.inf
    with pytest.raises(GeometryError, match="no number"):
        Geometry.from_dh(rows)
