"""``python -m armui`` is the same as the command ``armui``."""

from armui.cli import main

if __name__ == "__main__":
    raise SystemExit(main())
