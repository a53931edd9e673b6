"""`python -m tests.safety.fuzz`: many actions, or one seed again."""

from __future__ import annotations

import argparse
import os
import sys
import time

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from PySide6.QtCore import QCoreApplication

from armui.protocol.generation import Generation
from tests.safety.fuzz.runner import run, shrink
from tests.safety.fuzz.script import script

_TOLD_EVERY = 10


def main() -> int:
    """Run seeds until the actions are used up; each violation is told once, narrowed down."""
    options = _options()
    application = QCoreApplication([])
    seen: dict[str, int] = {}
    done, began_s, seed = 0, time.monotonic(), options.seed
    last = options.seed + (options.seeds or 1)
    while seed < last:
        generation = Generation(options.generation or 2 - seed % 2)
        actions = script(seed, options.actions)
        if options.keep:
            actions = [actions[int(index)] for index in options.keep.split(",")]
        failure = run(actions, generation, options.ignore)
        done += len(actions) if failure is None else failure.index + 1
        if failure is not None:
            key = f"{failure.violation.promise}: {failure.violation.key}"
            seen[key] = seen.get(key, 0) + 1
            if seen[key] == 1:
                kept = list(range(failure.index + 1))
                if not options.keep and not options.whole:
                    kept, failure = shrink(actions, failure, generation, ignored=options.ignore)
                told = ",".join(map(str, kept))
                sys.stdout.write(
                    f"\n{key}\n  {failure.violation.text}\n  generation {int(generation)}; again: "
                    f"python -m tests.safety.fuzz --seed {seed} --actions {options.actions} "
                    f"--generation {int(generation)} --keep {told}\n"
                )
                for index in kept:
                    sys.stdout.write(f"    {index:4} {actions[index]}\n")
                sys.stdout.flush()
        seed += 1
        if (seed - options.seed) % _TOLD_EVERY == 0:
            sys.stderr.write(f"{seed - options.seed} seeds, {done} actions\n")
            sys.stderr.flush()
    wall_s = time.monotonic() - began_s
    sys.stdout.write(f"\n{done} actions, {last - options.seed} seeds, {wall_s:.0f} s\n")
    for key, count in sorted(seen.items(), key=lambda each: -each[1]):
        sys.stdout.write(f"{count:5} × {key}\n")
    application.processEvents()
    return 1 if seen else 0


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m tests.safety.fuzz", description=__doc__)
    parser.add_argument("--seed", type=int, default=0, help="the first seed (0)")
    parser.add_argument("--seeds", type=int, default=1, help="how many, one after the other (1)")
    parser.add_argument("--actions", type=int, default=100, help="of each seed (100)")
    parser.add_argument("--generation", type=int, choices=(1, 2), help="else by turns")
    parser.add_argument("--keep", help="only the actions of these numbers, as a failure tells them")
    parser.add_argument(
        "--ignore", action="append", default=[], help="pass over violations with this in their key"
    )
    parser.add_argument("--whole", action="store_true", help="do not narrow failures down")
    return parser.parse_args()


if __name__ == "__main__":
    sys.exit(main())
