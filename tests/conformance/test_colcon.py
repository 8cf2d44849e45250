"""Every recorded case of the real colcon and `ros2 pkg create`, against ours; what differs is listed with a reason."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from day6_core.session.streams import Captured
from tests.conformance.colcon_cases import PREPARATIONS, Case, Workshop, differences, load_cases

CASES = load_cases()
EXCEPTIONS: dict[str, str] = {}
"""`{case: why it differs}`."""


@pytest.fixture
def workshop(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Workshop]:
    monkeypatch.setattr("day6_core.shell.desk.login_name", lambda: "root")  # who made the recording
    place = Workshop(tmp_path / "home")
    yield place
    place.close()


def _parameters() -> list:
    return [
        pytest.param(
            case,
            id=case.name,
            marks=[pytest.mark.xfail(reason=EXCEPTIONS[case.name], strict=True)] if case.name in EXCEPTIONS else [],
        )
        for case in CASES
    ]


@pytest.mark.process
@pytest.mark.parametrize("case", _parameters())
def test_the_build_is_that_of_the_real_colcon(workshop: Workshop, monkeypatch: pytest.MonkeyPatch, case: Case) -> None:
    if case.name == "build_tty":
        monkeypatch.setattr(Captured, "isatty", lambda self: True)
    prepare = PREPARATIONS.get(case.name)
    if prepare is not None:
        prepare(workshop)
    done = workshop.run(
        case.command.partition("setup.py && ")[2] or case.command, workshop.terminal(workshop.workspace / case.folder)
    )
    found = differences(case, workshop, done.out, done.err, done.status)
    assert not found, f"{case.command}\n{found}"


def test_every_preparation_and_exception_names_a_case() -> None:
    names = {case.name for case in CASES}
    assert set(EXCEPTIONS) <= names
    assert set(PREPARATIONS) <= names


def test_at_least_97_of_100_cases_are_equal() -> None:
    assert len(EXCEPTIONS) <= 0.03 * len(CASES)
