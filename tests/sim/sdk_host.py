"""A host program around the maker's SDK: calls its public methods as standard input says.

A line in is `["Method", [arguments]]` as JSON; a line out is what the method returned, objects as
their attributes. The program ends with its input.
"""

from __future__ import annotations

import enum
import json
import os
import sys
from typing import Any

from piper_sdk import C_PiperInterface_V2


def plain(value: Any) -> Any:
    """Objects as dictionaries, as deep as they go."""
    if isinstance(value, enum.Enum):
        return int(value.value) if isinstance(value.value, int) else value.name
    if isinstance(value, dict):
        return {str(key): plain(each) for key, each in value.items()}
    if isinstance(value, list | tuple):
        return [plain(each) for each in value]
    if hasattr(value, "__dict__"):
        return {name.lstrip("_"): plain(each) for name, each in vars(value).items()}
    return value


def main(channel: str) -> None:
    """Connects as the SDK does on an adapter of its own choice, and obeys until the input ends."""
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # the SDK prints
    piper = C_PiperInterface_V2(channel, judge_flag=False, can_auto_init=False)
    piper.CreateCanBus(channel, bustype="udp_multicast", judge_flag=False)
    piper.ConnectPort()
    for line in sys.stdin:
        method, arguments = json.loads(line)
        answers.write(json.dumps(plain(getattr(piper, method)(*arguments))) + "\n")
        answers.flush()


if __name__ == "__main__":
    main(sys.argv[1])
