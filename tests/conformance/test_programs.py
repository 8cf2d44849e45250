"""Programs do with our rclpy what they were recorded to do with a real one (Kilted, 9.1.2): output, errors, exit status.

`differential.py` runs the same programs on a real rclpy where there is one, and records them.
"""

from __future__ import annotations

import os
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from tests.conformance.differential import difference
from tests.conformance.known_differences import KNOWN, TIMING
from tests.conformance.played import Case, Outcome, play, program_cases, reference_cases

pytestmark = pytest.mark.process

_REFERENCE = reference_cases()
_PROGRAMS = program_cases()
_ALIKE = [case for case in (*_REFERENCE, *_PROGRAMS) if case.name not in KNOWN]


def test_the_reference_cases_are_there() -> None:
    names = [case.name for case in _REFERENCE]
    assert len(names) > 80
    assert set(KNOWN) <= set(names), "a known difference names a case that does not exist"


def test_every_program_is_recorded() -> None:
    assert len(_PROGRAMS) >= 100
    assert [case.name for case in _PROGRAMS if case.expected.exit_code == -1] == []


recorded_here = pytest.mark.skipif(
    sys.version_info[:2] != (3, 11) or os.name == "nt",
    reason="recorded with Python 3.11 on Linux; its own messages, signals and exit codes are part of the recordings",
)


@recorded_here
@pytest.mark.parametrize("case", _REFERENCE, ids=lambda case: case.name)
def test_a_reference_program_does_the_same(case: Case, tmp_path: Path) -> None:
    outcome = play(case, tmp_path)
    if case.name in KNOWN:
        assert outcome != case.expected, f"no longer a difference: {KNOWN[case.name]}"
        pytest.xfail(KNOWN[case.name])
    assert _differences(case, outcome) == []


@recorded_here
@pytest.mark.parametrize("case", _PROGRAMS, ids=lambda case: case.name)
def test_a_program_does_what_it_did_with_real_rclpy(case: Case, tmp_path: Path) -> None:
    found = difference(case.expected, play(case, tmp_path))
    if found and "sleep(" in case.code:  # whose callbacks come first depends on the load, as with the real one
        found = difference(case.expected, play(case, tmp_path))
    assert found == []


@recorded_here
@pytest.mark.parametrize("case", _ALIKE, ids=lambda case: case.name)
def test_a_program_does_the_same_in_virtual_time(case: Case, tmp_path: Path) -> None:
    assert _differences(case, play(case, tmp_path, fast=True)) == []


def _differences(case: Case, outcome: Outcome) -> list[str]:
    late = TIMING.get(case.name)
    lines = [line for line in outcome.stderr.splitlines() if late is None or not line.endswith(late)]
    return difference(case.expected, replace(outcome, stderr="\n".join(lines)))
