"""What is laid over the picture is drawn anew where it has changed, and looks the same."""

import numpy as np
import pytest
from PySide6.QtCore import QRectF
from PySide6.QtGui import QColor, QFont, QImage, QPainter

from armui.viewport.camera import HOME_CAMERA, ViewDirection
from armui.viewport.palette import DARK, LIGHT
from armui.viewport.projection import Projection
from armui.viewport.stroke_painter import KeptLayer, StrokeLayer, StrokePainter
from armui.viewport.strokes import Stroke
from tests.viewport.test_views import pixels

SIZE = (300, 240)
STROKES = [
    Stroke(((0.0, 0.0, 0.1), (0.2, 0.1, 0.3)), "#2f6fde", 2.5, label="x"),
    Stroke(((0.0, 0.0, 0.0), (0.3, 0.0, 0.0), (0.0, 0.2, 0.4)), "#3f9a4b", 0.0, filled=True),
]

pytestmark = pytest.mark.usefixtures("qapp")


def painted(paint, ratio=1.0):
    image = QImage(round(SIZE[0] * ratio), round(SIZE[1] * ratio), QImage.Format.Format_RGB32)
    image.setDevicePixelRatio(ratio)
    image.fill(QColor("#f4f6f8"))
    painter = QPainter(image)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    paint(painter)
    painter.end()
    return pixels(image)


class Counted:
    """Says which lines there are, and how often it was asked."""

    def __init__(self):
        self.asked = 0

    def __call__(self):
        self.asked += 1
        return STROKES


@pytest.mark.parametrize("ratio", [1.0, 1.5, 2.0])
def test_a_kept_line_looks_like_one_that_is_painted(ratio):
    projection = Projection(HOME_CAMERA, *SIZE)
    plain = painted(lambda on: StrokePainter().paint(on, STROKES, projection, LIGHT), ratio)
    layer = StrokeLayer(StrokePainter())
    for _ in range(2):
        kept = painted(lambda on: layer.paint(on, 1, lambda: STROKES, projection, LIGHT), ratio)
        differs = np.abs(plain.astype(int) - kept).max(axis=2) > 24  # the smoothing of letters
        assert differs.mean() < 0.002
    assert np.ptp(plain, axis=(0, 1)).max() > 100


@pytest.mark.parametrize("toward", [(1, 0), (-1, 0), (0, 1), (0, -1), (1, 1)], ids=str)
def test_the_edge_of_the_picture_cuts_no_label(toward):
    """The picture is painted on a larger ground, where one sees what goes beyond it."""
    projection = Projection(HOME_CAMERA, *SIZE)
    _, right, up = (np.array(axis) for axis in HOME_CAMERA.axes())
    focus_m, scale_px = np.array(HOME_CAMERA.focus_m), projection.scale_px(0.0)
    half_px = np.array(SIZE) / 2.0 - 4.0
    along_px = np.array(toward) * half_px
    end_m = focus_m + (right * along_px[0] + up * along_px[1]) / scale_px
    beyond_m = focus_m + (end_m - focus_m) * 1.2

    def shown(end_m, label):
        line = Stroke((tuple(focus_m), tuple(end_m)), "#2f6fde", 1.0, label=label)

        def paint(on):
            on.scale(0.5, 0.5)
            on.translate(SIZE[0] / 2.0, SIZE[1] / 2.0)
            StrokePainter().paint(on, [line], projection, LIGHT)

        return painted(paint).astype(int)

    written = np.abs(shown(end_m, "TCP") - shown(end_m, "")).max(axis=2) > 8
    assert written.any()
    rows, columns = np.nonzero(written)
    assert SIZE[1] / 4 <= rows.min() <= rows.max() <= 3 * SIZE[1] / 4
    assert SIZE[0] / 4 <= columns.min() <= columns.max() <= 3 * SIZE[0] / 4
    assert (shown(beyond_m, "TCP") == shown(beyond_m, "")).all()


def test_it_is_asked_for_again_where_something_has_changed_and_only_there():
    strokes, layer = Counted(), StrokeLayer(StrokePainter())
    seen = Projection(HOME_CAMERA, *SIZE)
    wider = Projection(HOME_CAMERA, SIZE[0] + 1, SIZE[1])
    above = Projection(HOME_CAMERA.turned_to(ViewDirection.TOP), *SIZE)
    changes = [
        (1, seen, LIGHT),
        (2, seen, LIGHT),
        (2, wider, LIGHT),
        (2, above, LIGHT),
        (2, above, DARK),
    ]
    for number, (key, projection, palette) in enumerate(changes, start=1):
        for _ in range(3):
            painted(
                lambda on, key=key, projection=projection, palette=palette: layer.paint(
                    on, key, strokes, projection, palette
                )
            )
        assert strokes.asked == number


def test_another_font_and_other_pixels_are_changes_too():
    drawn: list[int] = []
    layer = KeptLayer()

    def paint(on):
        layer.paint(on, "key", lambda: QRectF(0.0, 0.0, 50.0, 50.0), lambda _on: drawn.append(1))

    def paint_larger(on):
        on.setFont(QFont("sans", 30))
        paint(on)

    for paints, ratio, count in ((paint, 1.0, 1), (paint_larger, 1.0, 2), (paint_larger, 2.0, 3)):
        painted(paints, ratio)
        painted(paints, ratio)
        assert len(drawn) == count


def test_where_there_is_nothing_nothing_is_drawn():
    layer = KeptLayer()
    blank = painted(lambda on: None)
    empty = painted(lambda on: layer.paint(on, 1, QRectF, lambda _on: 1 / 0))
    assert (blank == empty).all()
