"""Every check of the project, one after the other: ``python -m tests.check``.

Needs no display. Ends at the first check that fails, with its exit code.
"""

import subprocess
import sys
import sysconfig
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SCRIPTS = Path(sysconfig.get_path("scripts"))

SCENES = ("online", "run", "library", "settings-refused")
"""Of the gallery: the 3D picture, a motion, a window with files, a dialog."""

CHECKS = (
    (SCRIPTS / "ruff", "check"),
    (SCRIPTS / "ruff", "format", "--check"),
    (SCRIPTS / "mypy",),
    (SCRIPTS / "lint-imports",),
    (sys.executable, "-m", "pytest", "-n", "auto"),
)


def main() -> int:
    """Run the checks; returns the exit code of the first that fails, or 0."""
    with tempfile.TemporaryDirectory() as pictures:
        gallery = (sys.executable, "-m", "tests.gallery", pictures, "--quick", *SCENES)
        for command in (*CHECKS, gallery):
            words = [str(word) for word in command]
            print("$", Path(words[0]).name, *words[1:], flush=True)
            code = subprocess.run(words, cwd=ROOT, check=False).returncode
            if code:
                return code
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
