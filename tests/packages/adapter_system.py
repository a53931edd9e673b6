"""A computer for the adapter's helper: its /sys and /etc; tools that keep state and can fail."""

import contextlib
import importlib.util
import io
import json
import subprocess
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

HELPER = Path(__file__).resolve().parents[2] / "resources/packaging/linux/adapter_helper.py"
GO = "go\n"

_RUNNER = """
import json, sys
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
place, words = json.loads(sys.argv[1]), sys.argv[2:]
spec = spec_from_file_location("adapter_helper", place["helper"])
helper = module_from_spec(spec)
sys.modules["adapter_helper"] = helper
spec.loader.exec_module(helper)
for name in ("NET", "TTY", "ETC"):
    setattr(helper, name, Path(place["root"]) / name.lower())
helper.TOOL_FOLDERS = (place["root"] + "/bin",)
helper.PATIENCE_S, helper.GO_S, helper.ROOT = place["patience_s"], place["go_s"], place["owner"]
raise SystemExit(helper.main(words))
"""
_TOOL = """#!{python} -IS
import json, pathlib, sys, time
root = pathlib.Path({root!r})
name, words = pathlib.Path(sys.argv[0]).name, sys.argv[1:]
file = root / "state.json"
state = json.loads(file.read_text())
state["ran"].append([name, *words])
file.write_text(json.dumps(state))
wrong, at = state["wrong"].get(name, ["", ""])
if not wrong or (at and at not in words):
    wrong = ""
if wrong == "hang":
    time.sleep(600)
if wrong == "error":
    sys.exit(name + ": Operation not supported")
if wrong == "garbage":
    print("\\x00not what was asked for")
    sys.exit(0)
if name == "ip" and "show" in words:
    link = state["links"][words[words.index("dev") + 1]]
    data = {{"state": link["state"]}}
    if link["bitrate"]:
        data["bittiming"] = {{"bitrate": link["bitrate"]}}
    about = {{"info_kind": link["kind"], "info_data": data}}
    print(json.dumps([{{"ifname": "x", "linkinfo": about}}]))
elif name == "ip" and wrong != "lie":
    link = state["links"][words[words.index("dev") + 1]]
    if "bitrate" in words:
        if link["up"]:
            sys.exit("RTNETLINK answers: Device or resource busy")
        link["bitrate"] = int(words[words.index("bitrate") + 1])
    if "restart-ms" in words and link["up"]:
        sys.exit("RTNETLINK answers: Device or resource busy")
    if words[-1] in ("up", "down"):
        if words[-1] == "up" and link["kind"] == "can" and not link["bitrate"]:
            sys.exit("RTNETLINK answers: Invalid argument")
        link["up"] = words[-1] == "up"
        link["state"] = "ERROR-ACTIVE" if link["up"] else "STOPPED"
        flags = root / "net" / words[words.index("dev") + 1] / "flags"
        flags.write_text("0x400c1" if link["up"] else "0x40080")
    file.write_text(json.dumps(state))
elif name == "udevadm" and words[0] == "info":
    for key, value in state["udev"].get(pathlib.Path(words[-1][7:]).name, {{}}).items():
        print(key + "=" + value)
elif name == "systemctl" and words[0] == "is-active":
    sys.exit(0 if state["networkd"] else 3)
"""


class AdapterSystem:
    """Interfaces, serial ports, tools; see `_TOOL` for how they can fail.

    Args:
        root: An empty folder.
    """

    def __init__(self, root: Path) -> None:
        self.root = root
        self.etc = root / "etc"
        for name in ("net", "tty", "etc", "bin"):
            (root / name).mkdir()
        self._state: dict[str, Any] = {
            "links": {},
            "udev": {},
            "networkd": True,
            "wrong": {},
            "ran": [],
        }
        for name in ("ip", "udevadm", "networkctl", "systemctl"):
            tool = root / "bin" / name
            tool.write_text(_TOOL.format(python=sys.executable, root=str(root)))
            tool.chmod(0o755)
        self._save()

    def add(self, name: str, *, serial: str = "", dev_id: int = 0, **link: Any) -> None:
        """Plug an interface in; kind, up and bitrate as told."""
        folder = self.root / "net" / name
        folder.mkdir()
        (folder / "type").write_text(
            "280\n" if link.get("kind", "can") in {"can", "vcan"} else "1\n"
        )
        (folder / "dev_id").write_text(f"0x{dev_id:x}\n")
        (folder / "flags").write_text("0x400c1\n" if link.get("up") else "0x40080\n")
        state = "BUS-OFF" if link.get("up") else "STOPPED"
        self._state["links"][name] = {
            "kind": "can",
            "up": False,
            "bitrate": None,
            "state": state,
            **link,
        }
        self._state["udev"][name] = {"ID_SERIAL_SHORT": serial} if serial else {}
        self._save()

    def add_port(self, name: str, **found: str) -> None:
        """Plug a serial adapter in."""
        (self.root / "tty" / name).mkdir()
        self._state["udev"][name] = found
        self._save()

    def set(self, **values: Any) -> None:
        """Change what the tools know or do; `wrong` by tool: what, and at which word."""
        self._state = self.state()
        self._state.update(values)
        self._save()

    def state(self) -> dict[str, Any]:
        """What the tools know and ran."""
        found: dict[str, Any] = json.loads((self.root / "state.json").read_text())
        return found

    def link(self, name: str) -> dict[str, Any]:
        """What ip has made of an interface."""
        found: dict[str, Any] = self.state()["links"][name]
        return found

    def files(self) -> dict[str, str]:
        """Every file below /etc."""
        found = sorted(each for each in self.etc.rglob("*") if each.is_file())
        return {str(each.relative_to(self.etc)): each.read_text() for each in found}

    def command(self, *words: str, patience_s: float = 20.0, go_s: float = 20.0) -> list[str]:
        """How the helper is started here."""
        place = {
            "helper": str(HELPER),
            "root": str(self.root),
            "owner": self.root.stat().st_uid,
            "patience_s": patience_s,
            "go_s": go_s,
        }
        return [sys.executable, "-IS", "-c", _RUNNER, json.dumps(place), *words]

    def run(
        self, *words: str, say: str = GO, environment: dict[str, str] | None = None, **limits: float
    ) -> tuple[int, dict[str, Any]]:
        """Exit code, and all it said by its words."""
        done = subprocess.run(
            self.command(*words, **limits),
            input=say,
            capture_output=True,
            text=True,
            check=False,
            env=environment,
        )
        assert not done.stderr, done.stderr
        said: dict[str, Any] = {}
        for line in done.stdout.splitlines():
            said.update(json.loads(line))
        return done.returncode, said

    def refusals(self, asked: Iterable[Sequence[str]]) -> list[tuple[int, dict[str, Any]]]:
        """What it answers to words it does not even plan by, all asked in this process."""
        spec = importlib.util.spec_from_file_location("adapter_helper", HELPER)
        assert spec is not None
        assert spec.loader is not None
        helper = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(helper)
        for name in ("net", "tty", "etc"):
            setattr(helper, name.upper(), self.root / name)
        helper.__dict__["TOOL_FOLDERS"] = (str(self.root / "bin"),)
        answers = []
        for words in asked:
            with contextlib.redirect_stdout(io.StringIO()) as said:
                code = helper.main(list(words))
            (line,) = said.getvalue().splitlines()
            answers.append((code, json.loads(line)))
        return answers

    def _save(self) -> None:
        (self.root / "state.json").write_text(json.dumps(self._state))
