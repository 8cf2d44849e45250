"""What one pupil can do to another in each mode that this machine has, and what is left of a pupil at the end."""

from __future__ import annotations

import sys
from typing import Any

import pytest

if sys.platform != "linux":
    pytest.skip("pupils are kept apart on Linux only", allow_module_level=True)

from day6_core.isolation import attacks, modes
from tests.isolation.school import LIMITS, asked

APART = ("users", "bubblewrap")


def deed(mode: str, name: str) -> Any:
    answer = asked(mode, name)
    if isinstance(answer, str):
        pytest.skip(answer)
    return answer["got"]


@pytest.mark.process
@pytest.mark.parametrize("mode", APART)
def test_nothing_a_pupil_tries_against_another_goes_through(mode: str) -> None:
    assert [name for name in deed(mode, "attacks") if not name.startswith("visible.")] == []


@pytest.mark.process
def test_where_all_are_one_user_everything_goes_through() -> None:
    """The attacks are real ones."""
    tried = set(attacks.names()) - {"processes.setuid"}
    assert tried - set(deed("none", "attacks")) <= {"processes.ptrace", "processes.mem"}  # Yama may forbid them


@pytest.mark.process
def test_landlock_is_not_called_separating_where_sockets_can_be_reached() -> None:
    through = deed("landlock", "attacks")
    if "sockets.keeper" in through:
        assert not any(name.startswith("files.") for name in through)
    else:
        assert [name for name in through if not name.startswith("visible.")] == []


@pytest.mark.process
@pytest.mark.parametrize("mode", modes.NAMES)
def test_the_end_of_a_cell_leaves_no_process(mode: str) -> None:
    assert deed(mode, "orphans") == [5, 0, True]


@pytest.mark.process
@pytest.mark.parametrize("mode", modes.NAMES)
def test_what_a_program_leaves_behind_ends_with_the_cell(mode: str) -> None:
    assert deed(mode, "orphans_of_ended") == [1, 0, 0]


@pytest.mark.process
@pytest.mark.parametrize("mode", modes.NAMES)
def test_a_new_server_ends_what_a_killed_one_left(mode: str) -> None:
    assert deed(mode, "forgotten") == [5, 0]


@pytest.mark.process
@pytest.mark.parametrize("mode", modes.NAMES)
def test_a_pupil_gets_no_more_than_his_limits(mode: str) -> None:
    taken = deed(mode, "limits")
    assert taken["files"] == LIMITS.disk >> 20
    assert taken["memory"] <= LIMITS.memory >> 20
    assert taken["temporary"] <= LIMITS.disk >> 20
    if mode in APART:
        assert 5 < taken["processes"] < LIMITS.processes and taken["others"] == 0


@pytest.mark.process
@pytest.mark.parametrize("mode", ("bubblewrap", "landlock"))
def test_programs_that_are_graded_in_a_cell_meet_others(mode: str) -> None:
    assert deed(mode, "graded") == [""]


@pytest.mark.process
@pytest.mark.parametrize("mode", modes.NAMES)
def test_a_program_finds_its_own_places_and_nothing_of_the_servers(mode: str) -> None:
    around = deed(mode, "surroundings")
    variables = around["env"]
    assert "TOKEN_OF_SERVER" not in variables and "LD_PRELOAD" not in variables
    assert variables["HOME"] == around["cwd"] == around["home"]
    assert variables["DAY6_RUNTIME_DIR"] == around["runtime"] and variables["DAY6_LANG"] == "zh"
    assert (around["core"], around["umask"]) == (0, 0o077)
    assert around["open"] == 4  # 0, 1, 2 and the folder being listed
    assert mode != "users" or around["groups"] == []


@pytest.mark.process
@pytest.mark.parametrize("mode", modes.NAMES)
def test_a_pupils_own_node_and_ros2_meet_in_the_cell(mode: str) -> None:
    said = deed(mode, "lesson")
    assert "data: from mine" in said and "/mine" in said, said


@pytest.mark.process
@pytest.mark.parametrize("mode", APART)
def test_odd_names_of_pupils_are_only_names(mode: str) -> None:
    assert deed(mode, "names") == [True] * 4
