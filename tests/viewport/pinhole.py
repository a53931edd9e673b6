"""Where a view shows a point: a pinhole camera, worked out apart from the program's."""

import numpy as np

from armui.viewport.camera import HOME_CAMERA, VIEW_ANGLE_DEG, OrbitCamera

WIDTH, HEIGHT = 450, 350


def project(points_m: np.ndarray, camera: OrbitCamera = HOME_CAMERA) -> np.ndarray:
    """Pixels (x, y from the top left) where a picture of a view with perspective shows points."""
    eye, focus = np.array(camera.eye_m), np.array(camera.focus_m)
    forward = (focus - eye) / np.linalg.norm(focus - eye)
    right = np.cross(forward, [0.0, 0.0, 1.0])
    right /= np.linalg.norm(right)
    up = np.cross(right, forward)
    relative = points_m - eye
    scale = HEIGHT / 2.0 / np.tan(np.radians(VIEW_ANGLE_DEG / 2.0)) / (relative @ forward)
    return np.column_stack(
        [WIDTH / 2.0 + relative @ right * scale, HEIGHT / 2.0 - relative @ up * scale]
    )
