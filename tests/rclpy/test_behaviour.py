"""Recorded programs of real rclpy (Kilted, 9.1.2) do the same with ours: output, errors and exit status."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

sys.path.insert(0, os.path.dirname(__file__))

from golden import RECORDED, REFERENCE, Case, cases, play
from known_differences import KNOWN, TIMING, UNCHECKED_FIELDS

_CASES = cases(REFERENCE)
_OWN = cases(RECORDED)


def test_the_recorded_cases_are_there() -> None:
    if not REFERENCE.is_file():
        pytest.skip(f"the reference folder is not beside this repository: {REFERENCE}")
    names = [case.name for case in _CASES]
    assert len(names) > 80
    assert set(KNOWN) <= set(names), "a known difference names a case that does not exist"
    assert set(UNCHECKED_FIELDS) <= set(names)


recorded_here = pytest.mark.skipif(
    sys.version_info[:2] != (3, 11) or os.name == "nt",
    reason="recorded with Python 3.11 on Linux; its own messages, signals and exit codes are part of the recordings",
)


@recorded_here
@pytest.mark.parametrize("case", _CASES, ids=lambda case: case.name)
def test_a_recorded_program_does_the_same(case: Case, tmp_path: Path) -> None:
    if case.name in UNCHECKED_FIELDS:
        pytest.skip("agreed: recorded with field checks off, ours are on")
    outcome = play(case.code, tmp_path)
    if case.name in KNOWN:
        assert outcome != case.expected, f"no longer a difference: {KNOWN[case.name]}"
        pytest.xfail(KNOWN[case.name])
    assert outcome.exit_code == case.expected.exit_code, outcome.stderr
    assert outcome.stdout == case.expected.stdout
    late = TIMING.get(case.name)
    lines = [line for line in outcome.stderr.splitlines() if late is None or not line.endswith(late)]
    assert "\n".join(lines) == case.expected.stderr


@recorded_here
@pytest.mark.parametrize("case", _OWN, ids=lambda case: case.name)
def test_a_program_of_ours_does_what_it_did_with_real_rclpy(case: Case, tmp_path: Path) -> None:
    """The programs of recorded.jsonl; `record.py` records them anew where a real rclpy is."""
    outcome = play(case.code, tmp_path)
    assert outcome.exit_code == case.expected.exit_code, outcome.stderr
    assert outcome.stdout == case.expected.stdout
    assert outcome.stderr == case.expected.stderr
