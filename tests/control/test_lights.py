"""0x121: the lamps the simulated arm then has, the literal bytes, and what is refused."""

import pytest

from armui.arm.figures import WHOLE_OUT_OF_RANGE, check_arguments
from armui.control.devices.lights import Lights
from armui.control.link.link_state import NOT_CONNECTED, OFFLINE
from armui.protocol.codes import ALL_LAMPS
from armui.protocol.frame import Frame
from tests.accepted import accepted

LIGHT = {"joint": 1, "lamp": 0, "red": 0, "green": 0, "blue": 0}


def light(payload):
    return Frame(0x121, bytes.fromhex(payload))


def test_a_lamp_is_coloured_as_the_protocol_says(any_rig):
    rig = any_rig
    rig.connect()
    rig.heard()
    accepted(rig.controller.lights.set_light(2, 7, 255, 128, 1))
    rig.step()
    # enable, joint, lamp, red, green, blue, reserved, counter
    assert rig.heard() == [light("01 02 07 FF 80 01 00 00")]
    assert rig.firmware.settings.lights[2][:4] == (7, 255, 128, 1)
    told = rig.events[-1]
    assert (told.code, told.params["color"]) == ("sent_lamp", "#FF8001")


def test_all_lamps_are_lamp_0xff(any_rig):
    rig = any_rig
    rig.connect()
    rig.heard()
    accepted(rig.controller.lights.set_light(6, ALL_LAMPS, 0, 0, 16))
    rig.step()
    assert rig.heard() == [light("01 06 FF 00 00 10 00 00")]
    assert rig.codes()[-1] == "sent_lamps"


def test_the_counter_goes_round(rig):
    rig.connect()
    rig.heard()
    for _ in range(258):
        accepted(rig.controller.lights.set_light(1, 0, 0, 0, 0))
    rig.step()
    counted = [frame.data[7] for frame in rig.heard()]
    assert counted == [*range(256), 0, 1]


def test_what_was_refused_is_not_counted(rig):
    rig.connect()
    rig.heard()
    lights = rig.controller.lights
    assert lights.set_light(1, 0, 256, 0, 0).reason == WHOLE_OUT_OF_RANGE
    assert rig.codes()[-1] == "refused"
    accepted(lights.set_light(1, 0, 1, 2, 3))
    rig.step()
    assert rig.heard() == [light("01 01 00 01 02 03 00 00")]


def test_the_counter_goes_on_over_another_connection(rig):
    rig.connect()
    rig.controller.lights.set_light(1, 0, 0, 0, 0)
    rig.step()
    rig.controller.disconnect_device()
    rig.events.clear()
    rig.connect()
    rig.heard()
    rig.controller.lights.set_light(1, 0, 0, 0, 0)
    rig.step()
    assert [frame.data[7] for frame in rig.heard()] == [1]


def test_without_an_arm_it_is_refused_with_the_reason(rig):
    lights = rig.controller.lights
    assert lights.set_light(1, 0, 0, 0, 0).reason == NOT_CONNECTED
    rig.connect()
    rig.powered = False
    rig.run(0.6)
    rig.heard()
    assert lights.set_light(1, 0, 0, 0, 0).reason == OFFLINE
    rig.step()
    assert rig.heard() == []


def test_a_stopped_arm_can_be_lit(rig):
    rig.ready()
    rig.controller.emergency_stop()
    rig.run_until(lambda: "stop_confirmed" in rig.codes())
    rig.heard()
    accepted(rig.controller.lights.set_light(1, ALL_LAMPS, 255, 0, 0))
    rig.step()
    assert rig.heard() == [light("01 01 FF FF 00 00 00 00")]


@pytest.mark.parametrize(
    ("figures", "wrong"),
    [
        ({"joint": 0}, ("joint", 0, 1, 6)),
        ({"joint": 7}, ("joint", 7, 1, 6)),
        ({"joint": 1, "lamp": -1}, ("lamp", -1, 0, 254)),
        ({"lamp": 256}, ("lamp", 256, 0, 254)),
        ({"red": 256}, ("red", 256, 0, 255)),
        ({"red": 0, "green": -1}, ("green", -1, 0, 255)),
        ({"blue": 1000}, ("blue", 1000, 0, 255)),
    ],
)
def test_out_of_range_names_figure_value_and_range(figures, wrong):
    refusal = check_arguments(Lights.set_light, LIGHT | figures)
    assert refusal.reason == WHOLE_OUT_OF_RANGE
    named = ("figure", "value", "minimum", "maximum")
    assert tuple(refusal.params[name] for name in named) == wrong


@pytest.mark.parametrize("lamp", [0, 254, ALL_LAMPS])
def test_the_ends_of_the_ranges_may_be_sent(lamp):
    for joint, red, green, blue in ((1, 0, 255, 0), (6, 255, 0, 255)):
        light = {"joint": joint, "lamp": lamp, "red": red, "green": green, "blue": blue}
        assert check_arguments(Lights.set_light, light) is None
