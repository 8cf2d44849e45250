"""A small part of `tests/perf/shell_against_bash.py`: what random command lines leave behind is what real bash leaves."""

from __future__ import annotations

import shutil
import sys

import pytest

from tests.perf.shell_against_bash import differences

pytestmark = pytest.mark.skipif(
    not sys.platform.startswith("linux") or shutil.which("bash") is None, reason="needs GNU"
)


@pytest.mark.process
@pytest.mark.parametrize("seed", [2, 1024, 1023, 3001])
def test_random_command_lines_leave_the_same_tree(seed: int) -> None:
    assert "\n".join(differences(seed)) == ""
