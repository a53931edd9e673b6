"""Where the packaged program begins: what multiprocessing starts goes its own way first."""

from multiprocessing import freeze_support

if __name__ == "__main__":
    freeze_support()

    from armui.cli import main

    raise SystemExit(main())
