"""S11: the button that pauses a run never becomes, under the finger, the one that goes on."""

from PySide6.QtWidgets import QWidget

from armui.control.run.progress import RunPhase
from tests.operator.test_running import BACK, OUT, Operator, to


def test_a_pause_pressed_as_the_step_ends_does_not_take_the_next_step(app_driver):
    operator = Operator(app_driver, to(OUT), to(BACK))
    operator.child("run_steps").setChecked(True)
    operator.send()
    operator.until(lambda: operator.progress.phase is RunPhase.MOVING)
    app_driver.run(0.1)
    pause: QWidget = app_driver.find("run_pause")
    place = pause.mapTo(app_driver.window, pause.rect().center())
    operator.until(lambda: operator.progress.phase is RunPhase.WAITING)
    app_driver.heard()
    for _ in range(3):
        app_driver.press(app_driver.window.childAt(place))
        app_driver.run(0.2)
    assert operator.progress.phase is RunPhase.WAITING
    assert not app_driver.window.childAt(place).isEnabled()
    assert operator.text("run_next") == "Next step"
    app_driver.click("run_next")
    operator.until_over()
