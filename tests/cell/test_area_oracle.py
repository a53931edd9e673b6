"""No touch of a mesh with a box that the check did not say: random arms, boxes and ways.

`python -m tests.cell.test_area_oracle 5000` makes the large run and says what came of it. The
oracle knows nothing of capsules: it takes the corners of the meshes and places all over their
triangles, in small steps along the way, and looks whether one of them is in the box.
"""

import sys

import numpy as np
import trimesh

from armui.cell.work_area import AreaBox
from armui.kinematics.poses import pose_to_matrix
from armui.protocol.generation import PiperModel
from tests.cell.areas import check_of
from tests.cell.test_enclosure import own, random_deg

PLACES = 400
"""On each mesh, beside its corners."""
STEPS = 12
MARGIN_MM = 10.0
MOVED = {"base_link"}


def surfaces_mm(model):
    """The links that move, with places all over each in its own frame."""
    urdf = own(model)
    found = []
    for node in urdf.scene.graph.nodes_geometry:
        _, name = urdf.scene.graph[node]
        mesh = urdf.scene.geometry[name]
        places, _ = trimesh.sample.sample_surface(mesh, PLACES, seed=1)
        found.append((node, np.concatenate((mesh.vertices, places))))
    return urdf, found


def places_mm(robot, joints_deg, finger_m):
    """All those places in the base frame; the base does not move and does not count."""
    urdf, surfaces = robot
    names = urdf.actuated_joint_names
    values = {f"joint{index + 1}": np.radians(angle) for index, angle in enumerate(joints_deg)}
    urdf.update_cfg({name: values.get(name, finger_m) for name in names})
    base = urdf.scene.graph.transforms
    return 1e3 * np.concatenate(
        [
            trimesh.transform_points(places, urdf.scene.graph[node][0])
            for node, places in surfaces
            if base.parents.get(node) not in MOVED
        ]
    )


def gap_mm(points, box):
    """The least distance of points from a box; 0 inside."""
    frame = pose_to_matrix(box.pose)
    local = (points - frame[:3, 3]) @ frame[:3, :3]
    beyond = np.maximum(np.abs(local) - np.array(box.size_mm) / 2.0, 0.0)
    return float(np.linalg.norm(beyond, axis=1).min())


def outcomes(count, seed):
    """How often the check and the oracle said what: unsaid touches, touches, false alarms, free."""
    rng = np.random.default_rng(seed)
    told = {"touch, said": 0, "touch, unsaid": 0, "false alarm": 0, "free": 0}
    false_mm = []
    models = {model: surfaces_mm(model) for model in PiperModel}
    for number in range(count):
        model = list(PiperModel)[number % len(PiperModel)]
        start, end = random_deg(model, 2, int(rng.integers(1 << 30)))
        end = start + (end - start) * rng.uniform(0.0, 0.3)
        place = rng.uniform((-550.0, -550.0, 0.0), (550.0, 550.0, 700.0))
        box = AreaBox(
            "box", (*place, *rng.uniform(-180.0, 180.0, 3)), tuple(rng.uniform(20, 200, 3))
        )
        said = check_of(box, margin_mm=MARGIN_MM, model=model).entries(np.array((start, end)))
        way = start + np.linspace(0.0, 1.0, STEPS)[:, None] * (end - start)
        gap = min(
            gap_mm(places_mm(models[model], each, rng.uniform(0.0, 0.035)), box) for each in way
        )
        if gap <= 0.0:
            told["touch, said" if said else "touch, unsaid"] += 1
        elif said:
            told["false alarm"] += gap > MARGIN_MM
            told["touch, said"] += gap <= MARGIN_MM
            false_mm.append(gap)
        else:
            told["free"] += 1
            told["touch, unsaid"] += gap < MARGIN_MM - 2.0
    return told, false_mm


def test_no_touch_is_unsaid():
    told, false_mm = outcomes(40, seed=7)
    assert told["touch, unsaid"] == 0
    assert told["touch, said"] > 1
    assert told["free"] > 5
    assert max(false_mm) < 80.0


if __name__ == "__main__":
    result, alarms_mm = outcomes(int(sys.argv[1]), seed=1)
    print(result)
    beyond = [gap for gap in alarms_mm if gap > MARGIN_MM]
    if beyond:
        quantiles = np.quantile(beyond, (0.5, 0.95, 1.0)).round(1).tolist()
        print("false alarms, how far away: median, 95 %, largest", quantiles)
