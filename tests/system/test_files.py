"""Sizes of files as the operator reads them."""

import pytest

from armui.system.files import size_text

SIZES = {
    0: "0 B",
    999: "999 B",
    1_000: "1.0 kB",
    1_500: "1.5 kB",
    9_949: "9.9 kB",
    9_950: "10 kB",
    12_345: "12 kB",
    999_499: "999 kB",
    999_500: "1.0 MB",
    3_440_000: "3.4 MB",
    40_000_000: "40.0 MB",
    999_949_999: "999.9 MB",
    999_950_000: "1.00 GB",
    1_200_000_000: "1.20 GB",
}


@pytest.mark.parametrize(("count", "text"), SIZES.items())
def test_a_size_has_two_figures_or_more_and_none_is_nothing(count, text):
    assert size_text(count) == text
