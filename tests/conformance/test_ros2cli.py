"""Every recorded case of the real `ros2` whose command is here, against ours; what differs is listed with a reason."""

from __future__ import annotations

import shutil
from collections.abc import Iterator

import pytest

from day6_core.ros.differences import VALUES
from tests.conformance.golden_cases import GOLDEN, Case, load_cases, load_exceptions
from tests.conformance.machine import Machine, is_stepped

CASES = load_cases()
EXCEPTIONS = load_exceptions()


def _parameters() -> list:
    return [pytest.param(case, id=case.name, marks=_marks(case)) for case in CASES]


def _marks(case: Case) -> list:
    reason = EXCEPTIONS.get(case.name, "")
    differs = [pytest.mark.xfail(reason=reason, strict=True)] if reason else []
    return [*differs, pytest.mark.process] if not is_stepped(case) or case.name == "run_prefix" else differs


@pytest.fixture(scope="module")
def machine(tmp_path_factory) -> Iterator[Machine]:
    files = tmp_path_factory.mktemp("golden") / "files"
    shutil.copytree(GOLDEN / "files", files)
    machine = Machine(GOLDEN / "nodes", files)
    yield machine
    machine.close()


@pytest.fixture(autouse=True)
def _recorded_of_kilted(monkeypatch: pytest.MonkeyPatch) -> None:
    """What only Kilted prints, `ros2` of which was recorded, with the packages of Jazzy."""
    values, source = VALUES["action.root_node"]
    monkeypatch.setitem(VALUES, "action.root_node", ({"humble": values["kilted"]}, source))


@pytest.mark.random_order(disabled=True)  # recorded one after the other: what one sets, the next one reads
@pytest.mark.parametrize("case", _parameters())
def test_the_answer_is_that_of_the_real_command(machine, case):
    found = machine.play(case)
    assert not found, f"{' '.join(case.argv)}\n{found}"


def test_every_exception_names_a_case():
    assert set(EXCEPTIONS) <= {case.name for case in CASES}


def test_at_least_97_of_100_cases_are_equal():
    assert len(EXCEPTIONS) <= 0.03 * len(CASES)
