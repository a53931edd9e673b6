"""An operator's hand at the 3D picture: takes hold of handles and carries them."""

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication

from armui.viewport.grips import Grip, GripKind
from armui.viewport.handles import HandleKind
from armui.viewport.robot_shape import moved


class Hand:
    """At the picture of a program whose arm is enabled; its process is not needed for dragging."""

    def __init__(self, app_driver, shape, kind=HandleKind.TOOL):
        self.app_driver = app_driver
        app_driver.ready()
        self.view = app_driver.program.view
        self.view._is_started = True  # no process: nothing waits for a picture
        self.view._on_robot_shown(shape)
        self.view.setVisible(True)
        self.view.resize(700, 560)
        self.bar = app_driver.find("view_bar")
        self.choose(kind)

    def choose(self, kind):
        self.bar.choose_handles(kind)

    def look(self):
        """What the timer does ten times a second."""
        self.app_driver.window._picture.refresh()

    def grip(self, kind, number) -> Grip:
        self.look()
        grips = self.view._grips(self.view.projection)
        return next(each for each in grips if (each.kind, each.number) == (kind, number))

    def send(self, kind, at, buttons, modifiers):
        button = Qt.MouseButton.LeftButton
        if kind is QMouseEvent.Type.MouseMove:
            button = Qt.MouseButton.NoButton
        place = QPointF(*at)
        event = QMouseEvent(kind, place, self.view.mapToGlobal(place), button, buttons, modifiers)
        QApplication.sendEvent(self.view, event)

    def press(self, at):
        left, none = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
        self.send(QMouseEvent.Type.MouseButtonPress, at, left, none)

    def move(self, at, modifiers=Qt.KeyboardModifier.NoModifier):
        self.send(QMouseEvent.Type.MouseMove, at, Qt.MouseButton.LeftButton, modifiers)

    def release(self, at):
        none = Qt.MouseButton.NoButton
        self.send(QMouseEvent.Type.MouseButtonRelease, at, none, Qt.KeyboardModifier.NoModifier)

    def place_on(self, grip) -> tuple[float, float]:
        """Where an axis is taken hold of: before its head; of a ring its first place."""
        if grip.kind is GripKind.AXIS:
            (x0, y0, z0), (x1, y1, z1) = grip.places[:2]
            place = (0.5 * (x0 + x1), 0.5 * (y0 + y1), 0.5 * (z0 + z1))
        else:
            place = grip.places[len(grip.places) // 5]
        return self.view.projection.pixel(place)

    def drag(self, grip, by_px, modifiers=Qt.KeyboardModifier.NoModifier):
        x, y = self.place_on(grip)
        self.press((x, y))
        end = (x + by_px[0], y + by_px[1])
        for share in (0.3, 0.7, 1.0):
            self.move((x + by_px[0] * share, y + by_px[1] * share), modifiers)
        self.release(end)
        return end

    @property
    def ghost(self):
        return self.view._state.preview.ghost_deg

    def tool_px(self, angles_deg):
        rows = self.view.shape.flange(self.view.shape.links(angles_deg))
        return self.view.projection.pixel(moved(rows, (0.0, 0.0, 0.0)))

    def fields(self):
        panel = self.app_driver.window.findChild(object, "operation_area").currentWidget()
        return panel.targets()
