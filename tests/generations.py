"""Which protocol a test speaks: the fixture `generation` offers both."""

import pytest

from armui.protocol.generation import Generation

ONE_IS_ENOUGH = pytest.mark.parametrize("generation", [Generation.TWO], ids=["gen2"], indirect=True)
"""For what a window does alike whatever protocol is spoken below it.

Both are for what the arm is told, for what it answers, and for figures that only one of them has.
"""
