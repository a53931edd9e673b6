"""Logs made by python-can itself, and the command run on them."""

from __future__ import annotations

import argparse
import base64
import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import can

from armui.decode import add_arguments, run

TEXT_SUFFIXES = (".log", ".asc", ".trc", ".csv")
# 90° = 90000 = 0x15F90, -0.001° = -1
JOINTS = "00015F90FFFFFFFF"
ASC_HEADER = "date Sat Nov 21 02:00:00.000 2026\nbase hex  timestamps absolute\n"
ASC_BEGIN = "internal events logged\nBegin Triggerblock Thu Jan 01 00:00:00.0 1970\n"
TRC_HEADER = ";$FILEVERSION=2.1\n;$STARTTIME=25569.0\n;$COLUMNS=N,O,T,I,d,L,D\n;\n"
CSV_HEADER = "timestamp,arbitration_id,extended,remote,error,dlc,data\n"
GOOD = {
    ".log": "(1.0) can0 2A5#0000000000000000",
    ".asc": "1.000000 1  2A5             Rx   d 8 00 00 00 00 00 00 00 00",
    ".trc": "  1  1000.000 DT 02A5 Rx 8 00 00 00 00 00 00 00 00",
    ".csv": f"1.0,0x2a5,0,0,0,8,{base64.b64encode(bytes(8)).decode()}",
}
HEADER = {".log": "", ".asc": ASC_HEADER + ASC_BEGIN, ".trc": TRC_HEADER, ".csv": CSV_HEADER}


def message(time_s: float, arbitration_id: int, payload: str = "", **kind) -> can.Message:
    data = bytes.fromhex(payload)
    return can.Message(
        timestamp=time_s, arbitration_id=arbitration_id, data=data, dlc=kind.pop("dlc", len(data)),
        is_extended_id=kind.pop("extended", False), channel=1, **kind,
    )  # fmt: skip


def record(path: Path, *messages: can.Message) -> Path:
    with can.Logger(path) as logger:
        for each in messages:
            logger(each)
    return path


def decode(path: Path, *options: str) -> int:
    parser = argparse.ArgumentParser()
    add_arguments(parser)
    return run(parser.parse_args([*options, str(path)]))


def objects(capsys) -> tuple[list[dict[str, Any]], str]:
    output = capsys.readouterr()
    return [json.loads(line) for line in output.out.splitlines()], output.err


def in_process(*arguments: str, **keywords) -> subprocess.Popen[Any]:
    code = "import sys; from armui.cli import main; sys.argv.insert(1, 'decode'); sys.exit(main())"
    return subprocess.Popen(
        [sys.executable, "-c", code, *arguments],
        cwd=Path(__file__).parents[2],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        **keywords,
    )
