"""SpaceMice: their reports byte by byte, and what comes, goes and falls silent."""

import pytest

from armui.gamepad.space_mice import SILENT_S, SpaceMice, SpaceMouseState, after


def axes_after(*reports):
    state = SpaceMouseState()
    for report in reports:
        state = after(state, bytes.fromhex(report))
    return {name: round(value, 3) for name, value in state.axes().items() if value}


@pytest.mark.parametrize(
    ("reports", "expected"),
    [
        # 0x015E = 350: pushed to the right, which is −Y of an arm seen from behind
        (["01 5E01 0000 0000"], {"y": -1.0}),
        # 0xFF51 = −175: pushed away by half
        (["01 0000 51FF 0000"], {"x": 0.5}),
        # pressed down: Z of the device leads downwards
        (["01 0000 0000 5E01"], {"z": -1.0}),
        (["02 5E01 0000 A2FE"], {"ry": -1.0, "rz": 1.0}),
        (["02 0000 5E01 0000"], {"rx": -1.0}),
        # translation and rotation by turns, as the older ones tell
        (["01 5E01 0000 0000", "02 0000 0000 5E01"], {"y": -1.0, "rz": -1.0}),
        (["01 5E01 0000 0000", "01 0000 0000 0000"], {}),
        # all six at once, as the newer ones do
        (["01 5E01 0000 0000 0000 0000 A2FE"], {"y": -1.0, "rz": 1.0}),
        # further than its travel
        (["01 F401 0000 0000"], {"y": -1.0}),
        # nothing that is known
        (["01 5E01", "17 5E01 5E01 5E01", ""], {}),
    ],
)
def test_what_a_report_means(reports, expected):
    assert axes_after(*reports) == expected


@pytest.mark.parametrize(
    ("report", "buttons"),
    [
        ("03 01", {"1"}),
        ("03 03 00", {"1", "2"}),
        ("03 00 00 80 04", {"24", "27"}),
        ("03 00 00 00 00", set()),
    ],
)
def test_buttons(report, buttons):
    assert after(SpaceMouseState(), bytes.fromhex(report)).buttons == buttons


def test_buttons_and_axes_do_not_disturb_each_other():
    state = after(SpaceMouseState(), bytes.fromhex("01 5E01 0000 0000"))
    state = after(state, bytes.fromhex("03 02"))
    assert (state.figures[0], state.buttons) == (350, frozenset("2"))
    state = after(state, bytes.fromhex("02 0000 0000 0000"))
    assert (state.figures[0], state.buttons) == (350, frozenset("2"))


# Devices ------------------------------------------------------------------------------------------


class Device:
    """One that hidapi opened."""

    def __init__(self):
        self.reports = []
        self.broken = None
        self.closed = False

    def open_path(self, path):
        if self.broken is not None:
            raise self.broken

    def set_nonblocking(self, wanted):
        assert wanted

    def read(self, _size):
        if self.broken is not None:
            raise self.broken
        return self.reports.pop(0) if self.reports else []

    def close(self):
        self.closed = True


class Hid:
    """hidapi with what is plugged in."""

    def __init__(self, *found):
        self.found = list(found)
        self.opened = {}
        self.next = Device()

    def enumerate(self, vendor, product):
        assert product == 0
        return [each for each in self.found if each["vendor_id"] == vendor]

    def device(self):
        device, self.next = self.next, Device()
        return device


def found(vendor=0x256F, product=0xC635, page=1, usage=8, path=b"/dev/hidraw0"):
    return {
        "path": path,
        "vendor_id": vendor,
        "product_id": product,
        "usage_page": page,
        "usage": usage,
        "product_string": "SpaceMouse Compact",
    }


def mice_of(hid):
    mice = SpaceMice()
    mice._hid = hid
    mice.scan()
    return mice


@pytest.mark.parametrize(
    ("what", "is_one"),
    [
        (found(), True),
        (found(vendor=0x046D, product=0xC626), True),
        (found(vendor=0x046D, product=0xC52B, usage=6), False),  # a receiver for keyboards
        (found(usage=6), False),  # the keys of a SpaceMouse Enterprise
        (found(page=0, usage=0), True),
        (found(vendor=0x046D, product=0xC626, page=0, usage=0), True),
        (found(vendor=0x046D, product=0xC52B, page=0, usage=0), False),
        (found(vendor=0x1234), False),
    ],
)
def test_what_is_a_space_mouse(what, is_one):
    assert bool(mice_of(Hid(what)).read(0.0)) == is_one


def test_what_it_tells_is_read_and_the_newest_stands():
    hid = Hid(found())
    device = hid.next
    mice = mice_of(hid)
    device.reports = [list(bytes.fromhex(each)) for each in ("01 5E0100000000", "01 000051FF0000")]
    device.reports.append(list(bytes.fromhex("03 01")))
    (state,) = mice.read(1.0)
    assert state.info.name == "SpaceMouse Compact"
    assert {name for name, value in state.axes.items() if value} == {"x"}
    assert state.buttons == {"1"}
    assert not state.silent


def test_silence_away_from_the_centre_and_at_rest():
    hid = Hid(found())
    device = hid.next
    mice = mice_of(hid)
    device.reports = [list(bytes.fromhex("01 5E0100000000"))]
    assert not mice.read(1.0)[0].silent
    assert not mice.read(1.0 + SILENT_S - 0.01)[0].silent
    assert mice.read(1.0 + SILENT_S + 0.01)[0].silent
    device.reports = [list(bytes.fromhex("01 000000000000"))]
    assert not mice.read(2.0)[0].silent
    assert not mice.read(200.0)[0].silent  # at rest it has nothing to tell


def test_one_that_is_pulled_out_is_gone_and_is_found_again():
    hid = Hid(found())
    device = hid.next
    mice = mice_of(hid)
    assert mice.read(0.0)
    device.broken = OSError("read error")
    assert mice.read(0.0) == ()
    assert device.closed
    mice.scan()
    assert mice.read(0.0)


def test_one_that_may_not_be_opened_is_named():
    hid = Hid(found())
    hid.next.broken = OSError("open failed")
    mice = mice_of(hid)
    assert mice.read(0.0) == ()
    assert mice.unusable == ("SpaceMouse Compact",)


def test_one_that_floods_does_not_keep_the_thread():
    hid = Hid(found())
    device = hid.next
    mice = mice_of(hid)
    device.reports = [list(bytes.fromhex("01 5E0100000000"))] * 10_000
    mice.read(0.0)
    assert len(device.reports) == 9_800


def test_all_are_let_go():
    hid = Hid(found())
    device = hid.next
    mice = mice_of(hid)
    mice.close()
    assert device.closed
    assert mice.read(0.0) == ()
