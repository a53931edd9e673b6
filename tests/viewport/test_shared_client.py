"""Two views, one after the other, with one process for their pictures."""

from functools import partial

from armui.viewport.client import PictureClient
from armui.viewport.view import ArmView
from tests.viewport.pinhole import HEIGHT, WIDTH
from tests.waiting import wait_until


def test_each_gets_its_own_first_picture(qtbot):
    client = PictureClient()
    images, pids = [], []
    for _ in range(2):
        view = ArmView(client=client)
        qtbot.addWidget(view)
        view.resize(WIDTH, HEIGHT)
        view.set_joints((0.0,) * 6, 0.0)
        view.show()
        wait_until(partial(getattr, view, "is_settled"))
        images.append(view._picture.image.copy())
        pids.append(client.pid)
        view.shutdown()
        view.close()
    client.stop()
    assert images[0] == images[1]
    assert pids[0] == pids[1] is not None
