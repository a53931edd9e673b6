"""The adapter's helper: each verb, hostile words, tools that fail in each way, files and links."""

import os
import shutil
import subprocess
import sys

import pytest

from tests.each import check_each
from tests.packages.adapter_system import HELPER, AdapterSystem

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="the helper is for Linux")

HOSTILE = (
    "",
    "can0; rm -rf /",
    "../x",
    "..",
    ".",
    "/etc/passwd",
    "can0/../can0",
    "x" * 4000,
    "can0\n",
    "$(id)",
    "`id`",
    "-all",
    "--help",
    "can²",
    "罐0",
    "can0 up",
    "\u202ecan0",
    "%s",
    "can*",
    "eth0",
)


@pytest.fixture
def system(tmp_path):
    system = AdapterSystem(tmp_path)
    system.add("can0", serial="AB12", bitrate=None)
    system.add("can1", serial="CD34", up=True, bitrate=500_000)
    system.add("vcan0", kind="vcan")
    system.add("eth0", kind="ether")
    return system


def changed(system):
    """What ip was told, beside to show."""
    return [ran for ran in system.state()["ran"] if ran[0] == "ip" and "set" in ran]


def refused(outcome, code):
    assert outcome[0] == 1
    assert outcome[1]["refused"]["code"] == code, outcome
    return outcome[1]["refused"]["text"]


def test_up_sets_the_bit_rate_and_looks_at_it(system):
    code, said = system.run("up", "can0", "1000000")
    assert code == 0
    done = {"kind": "can", "bitrate": 1_000_000, "state": "ERROR-ACTIVE", "up": True}
    assert said["done"] == {**done, "restarts": True}
    assert system.link("can0")["up"]
    # one that is up with another bit rate goes down first
    assert system.run("up", "can1", "1000000")[0] == 0
    assert system.link("can1")["bitrate"] == 1_000_000


def test_a_vcan_has_no_bit_rate(system):
    code, _said = system.run("up", "vcan0", "1000000")
    assert code == 0
    assert not any("bitrate" in ran for ran in changed(system))


def test_down_and_back_from_bus_off_with_its_own_bit_rate(system):
    assert system.run("down", "can1")[0] == 0
    assert not system.link("can1")["up"]
    code, said = system.run("reset", "can1")
    assert (code, said["done"]["bitrate"], said["done"]["up"]) == (0, 500_000, True)
    refused(system.run("reset", "can0"), "no_bitrate")


def test_a_driver_that_knows_no_restart_is_brought_up_all_the_same(system):
    system.set(wrong={"ip": ["error", "restart-ms"]})
    code, said = system.run("up", "can0", "1000000")
    assert (code, said["done"]["restarts"]) == (0, False)


def test_hostile_names_reach_no_tool(system):
    def check(word):
        asked = [
            ("up", word, "1000000"),
            ("down", word),
            ("reset", word),
            ("remember", word),
            ("remember", word, "arm_left", "1000000"),
            ("remember", "can0", word, "1000000"),
            ("forget", word),
            ("up", "can0", word),
        ]
        for words, (code, said) in zip(asked, system.refusals(asked), strict=True):
            assert code == 1, words
            assert len(said["refused"]["text"]) <= 40
        assert [code for code, _ in system.refusals([(word,), (word, "can0")])] == [2, 2]

    check_each(HOSTILE, check)
    assert system.run("up", HOSTILE[1], "1000000")[0] == 1
    assert system.state()["ran"] == []
    assert system.files() == {}


def test_names_of_the_kernel_and_of_others_are_not_given(system):
    of_kernel = ("can0", "can7", "vcan1", "eth1", "wlan0", "lo", "enp3s0", "all", "arm-left")
    asked = [("remember", "can0", name, "1000000") for name in (*of_kernel, "x" * 16)]
    for answer in system.refusals(asked):
        refused(answer, "bad_name")
    system.add("arm_left", serial="EF56")
    refused(system.run("remember", "can0", "arm_left", "1000000"), "name_taken")


def test_other_bit_rates_are_refused(system):
    strange = ("0", "1", "1e6", "01000000", "1000000 ", "٥٠٠٠٠٠", "999999999999")
    for answer in system.refusals([("up", "can0", word) for word in strange]):
        refused(answer, "bad_bitrate")


def test_nothing_is_done_without_go(system):
    for said in ("", "no\n", "gogo\n", "\n"):
        code, told = system.run("up", "can0", "1000000", say=said)
        assert (code, set(told)) == (1, {"plan"})
    assert changed(system) == []


def test_it_does_not_wait_for_ever_to_be_told(system):
    process = subprocess.Popen(
        system.command("down", "can1", go_s=0.2), stdin=subprocess.PIPE, stdout=subprocess.PIPE
    )
    with process:
        assert process.wait(30) == 1  # its input is still open
    assert system.link("can1")["up"]


def test_the_environment_says_nothing(system, tmp_path):
    trap = tmp_path / "trap"
    trap.mkdir()
    for name in ("ip", "udevadm", "json.py", "sitecustomize.py"):
        (trap / name).write_text("#!/bin/sh\nexit 9\n")
        (trap / name).chmod(0o755)
    environment = {
        "PATH": str(trap),
        "PYTHONPATH": str(trap),
        "PYTHONHOME": str(trap),
        "IFS": "/",
        "LD_LIBRARY_PATH": str(trap),
        "HOME": str(trap),
        "LC_ALL": "zz",
    }
    code, _said = system.run("up", "can0", "1000000", environment=environment)
    assert code == 0
    assert HELPER.read_text(encoding="utf-8").splitlines()[0] == "#!/usr/bin/python3 -IS"


def test_an_ip_that_is_absent_fails_hangs_or_lies_is_told(system):
    system.set(wrong={"ip": ["error", ""]})
    assert "Operation not supported" in refused(system.run("up", "can0", "1000000"), "tool_failed")
    system.set(wrong={"ip": ["garbage", ""]})
    refused(system.run("up", "can0", "1000000"), "tool_failed")
    system.set(wrong={"ip": ["hang", ""]})
    refused(system.run("up", "can0", "1000000", patience_s=1.0), "tool_hangs")
    system.set(wrong={"ip": ["lie", "set"]})
    refused(system.run("up", "can0", "1000000"), "not_up")
    refused(system.run("down", "can1"), "not_down")
    (system.root / "bin/ip").unlink()
    refused(system.run("up", "can0", "1000000"), "tool_missing")


def test_one_that_was_up_is_up_again_where_its_bit_rate_cannot_be_changed(system):
    system.set(wrong={"ip": ["error", "bitrate"]})
    refused(system.run("up", "can1", "1000000"), "tool_failed")
    assert system.link("can1")["up"]
    assert system.link("can1")["bitrate"] == 500_000


LINK = """# Written by armui for AB12 0x0
[Match]
Property=ID_SERIAL_SHORT=AB12

[Link]
Name=arm_left
"""
NETWORK = """# Written by armui for AB12 0x0
[Match]
Name=arm_left

[Link]
RequiredForOnline=no

[CAN]
BitRate=1000000
RestartSec=100ms
"""


def test_for_networkd_a_link_and_a_network_are_kept_as_they_were_shown(system):
    code, shown = system.run("remember", "can0", "arm_left", "1000000", say="")
    assert code == 1
    assert system.files() == {}
    code, said = system.run("remember", "can0", "arm_left", "1000000")
    assert (code, said["done"]) == (0, {"not_told": []})
    assert said["plan"] == shown["plan"]
    files = {
        "systemd/network/70-armui-arm_left.link": LINK,
        "systemd/network/70-armui-arm_left.network": NETWORK,
    }
    assert system.files() == files
    assert said["plan"]["files"] == {str(system.etc / name): text for name, text in files.items()}
    assert ["networkctl", "reload"] in system.state()["ran"]
    for path in system.etc.rglob("*"):
        assert path.stat().st_mode & 0o777 == (0o755 if path.is_dir() else 0o644)

    code, said = system.run("forget", "arm_left")
    assert code == 0
    assert len(said["plan"]["removed"]) == 2
    assert system.files() == {}
    refused(system.run("forget", "arm_left"), "not_kept")


def test_two_channels_of_one_adapter_are_told_apart(system):
    system.add("can2", serial="AB12", dev_id=1)
    assert system.run("remember", "can0", "arm_left", "1000000")[0] == 0
    assert system.run("remember", "can2", "arm_right", "500000")[0] == 0
    files = system.files()
    for name, channel in (("arm_left", "0x0"), ("arm_right", "0x1")):
        link = files[f"systemd/network/70-armui-{name}.link"]
        assert f"Property=ID_SERIAL_SHORT=AB12 ARMUI_DEV_ID={channel}\n" in link
        assert 'ENV{ARMUI_DEV_ID}="$attr{dev_id}"' in files[f"udev/rules.d/76-armui-{name}.rules"]


RULE = (
    "# Written by armui for AB12 0x0\n"
    'SUBSYSTEM=="net", ACTION=="add", ATTR{type}=="280", ENV{ID_SERIAL_SHORT}=="AB12", '
    'ATTR{dev_id}=="0x0", NAME="arm_left", TAG+="systemd", '
    'ENV{SYSTEMD_WANTS}+="armui-can-arm_left.service"\n'
)


def test_without_networkd_a_rule_and_a_unit(system):
    system.set(networkd=False)
    assert system.run("remember", "can0", "arm_left", "1000000")[0] == 0
    ip = system.root / "bin/ip"
    unit = (
        "# Written by armui for AB12 0x0\n[Unit]\nDescription=CAN adapter arm_left\n\n[Service]\n"
        f"Type=oneshot\nExecStart={ip} link set dev arm_left up type can bitrate 1000000 "
        "restart-ms 100\n"
    )
    assert system.files() == {
        "udev/rules.d/76-armui-arm_left.rules": RULE,
        "systemd/system/armui-can-arm_left.service": unit,
    }
    # with networkd again the new files replace those, under another name, too
    system.set(networkd=True)
    code, said = system.run("remember", "can0", "arm_right", "1000000")
    assert (code, len(said["plan"]["removed"])) == (0, 2)
    assert [name.rsplit("/", 1)[1] for name in system.files()] == [
        "70-armui-arm_right.link",
        "70-armui-arm_right.network",
    ]


def test_a_name_of_another_adapter_is_not_taken_from_it(system):
    assert system.run("remember", "can0", "arm_left", "1000000")[0] == 0
    before = system.files()
    refused(system.run("remember", "can1", "arm_left", "1000000"), "name_taken")
    assert system.files() == before


def test_an_adapter_without_serial_number_or_with_a_strange_one_is_not_kept(system):
    system.add("can3")
    refused(system.run("remember", "can3", "arm_left", "1000000"), "no_serial")
    for number, serial in enumerate(('x", RUN+="/bin/sh', "a b", "%i", "x" * 65, "é", "$env{X}")):
        system.add(f"can{number + 10}", serial=serial)
        (answer,) = system.refusals([("remember", f"can{number + 10}", "arm_left", "1000000")])
        refused(answer, "bad_serial")
    assert system.files() == {}


def test_tools_that_fail_after_the_files_are_written_are_named(system):
    system.set(wrong={"udevadm": ["error", "control"], "networkctl": ["error", ""]})
    code, said = system.run("remember", "can0", "arm_left", "1000000")
    assert code == 0
    assert said["done"]["not_told"] == ["udevadm: tool_failed", "networkctl: tool_failed"]
    assert len(system.files()) == 2


def test_an_udevadm_that_is_absent_or_hangs_keeps_nothing(system):
    system.set(wrong={"udevadm": ["hang", ""]})
    outcome = system.run("remember", "can0", "arm_left", "1000000", patience_s=1.0)
    refused(outcome, "tool_hangs")
    (system.root / "bin/udevadm").unlink()
    refused(system.run("remember", "can0", "arm_left", "1000000"), "tool_missing")
    assert system.files() == {}


def test_links_are_never_followed(system, tmp_path):
    victim = tmp_path / "victim"
    victim.write_text("mine\n")
    folder = system.etc / "systemd/network"
    folder.mkdir(parents=True)
    (folder / "70-armui-arm_left.link").symlink_to(victim)
    refused(system.run("remember", "can0", "arm_left", "1000000"), "not_ours")
    refused(system.run("forget", "arm_left"), "not_kept")
    shutil.rmtree(folder)
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    folder.symlink_to(elsewhere)
    refused(system.run("remember", "can0", "arm_left", "1000000"), "system")
    assert victim.read_text() == "mine\n"
    assert list(elsewhere.iterdir()) == []


def test_where_others_may_write_nothing_is_written(system):
    (system.etc / "systemd").mkdir()
    (system.etc / "systemd").chmod(0o777)
    text = refused(system.run("remember", "can0", "arm_left", "1000000"), "system")
    assert "others may write in systemd" in text
    assert system.files() == {}


def test_a_disk_that_fails_midway_leaves_nothing(system):
    (system.etc / "systemd/network/70-armui-arm_left.network").mkdir(parents=True)
    refused(system.run("remember", "can0", "arm_left", "1000000"), "not_ours")
    assert system.files() == {}


def test_a_serial_adapter_may_be_opened_by_who_sits_at_the_computer(system):
    ids = {"ID_BUS": "usb", "ID_VENDOR_ID": "16d0", "ID_MODEL_ID": "117e"}
    system.add_port("ttyACM0", **ids, ID_SERIAL_SHORT="20:8A")
    system.add_port("ttyUSB1", **ids)
    system.add_port("ttyS0", ID_BUS="pci")
    system.add_port("ttyUSB2", ID_BUS="pci")
    assert system.run("remember", "ttyACM0")[0] == 0
    assert system.run("remember", "ttyUSB1")[0] == 0
    refused(system.run("remember", "ttyS0"), "no_interface")
    refused(system.run("remember", "ttyUSB2"), "not_usb")
    rule = 'SUBSYSTEM=="tty", ENV{ID_VENDOR_ID}=="16d0", ENV{ID_MODEL_ID}=="117e"'
    assert system.files() == {
        "udev/rules.d/70-armui-port-20_8A.rules": "# Written by armui for 16d0:117e 20:8A\n"
        f'{rule}, ENV{{ID_SERIAL_SHORT}}=="20:8A", TAG+="uaccess"\n',
        "udev/rules.d/70-armui-port-16d0-117e.rules": "# Written by armui for 16d0:117e \n"
        f'{rule}, TAG+="uaccess"\n',
    }
    assert system.run("forget", "port-20_8A")[0] == 0
    assert len(system.files()) == 1


def test_on_a_real_vcan():
    """The kernel's own interface, switched on and off by the real ip; root and vcan are wanted."""
    name = f"armui{os.getpid() % 10_000}"
    ip = shutil.which("ip", path="/usr/sbin:/usr/bin:/sbin:/bin")
    if ip is None:
        pytest.skip("there is no ip")
    made = subprocess.run(
        [ip, "link", "add", name, "type", "vcan"], capture_output=True, text=True, check=False
    )
    if made.returncode:
        pytest.skip(f"no vcan can be made here: {made.stderr.strip()}")
    try:
        for words, up in ((("up", name, "1000000"), True), (("down", name), False)):
            command = [sys.executable, "-IS", str(HELPER), *words]
            done = subprocess.run(
                command, input="go\n", capture_output=True, text=True, check=False
            )
            assert done.returncode == 0, done.stdout
            told = subprocess.check_output([ip, "link", "show", name], text=True)
            assert ("UP" in told) is up
    finally:
        subprocess.run([ip, "link", "delete", name], check=False)
