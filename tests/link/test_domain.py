"""What ROS_DOMAIN_ID may be: the answers of real rclpy (kilted), taken from it value by value."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

from day6_core.graph.discovery import discovery_warning
from day6_core.graph.domain import DomainError, domain_from_text
from tests.support.waiting import run

NO_NUMBER = "failed to initialize rcl: ROS_DOMAIN_ID is not an integral number, at /project/src/rcl/domain_id.c:49"
TOO_LARGE = "failed to initialize rcl: ROS_DOMAIN_ID is out of range, at /project/src/rcl/domain_id.c:53"


@pytest.mark.parametrize(
    ("text", "domain"),
    [
        ("", 0),
        ("5", 5),
        (" 5", 5),
        ("5 ", 5),
        ("5x", 5),
        ("+5", 5),
        ("0", 0),
        ("0x10", 16),
        ("010", 8),
        ("-1", 0),
        ("233", 233),
        ("99999", 99999),
        ("4294967296", 4294967296),
        ("18446744073709551615", 0),
    ],
)
def test_a_domain_is_read_as_by_c(text: str, domain: int) -> None:
    assert domain_from_text(text) == domain


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("abc", NO_NUMBER),
        (" ", NO_NUMBER),
        ("-", NO_NUMBER),
        ("0 ", NO_NUMBER),
        ("08", NO_NUMBER),
        ("0x", NO_NUMBER),
        ("五", NO_NUMBER),
        ("٥", NO_NUMBER),
        ("99999999999999999999999", TOO_LARGE),
    ],
)
def test_what_is_no_domain_is_refused_in_the_words_of_rcl(text: str, words: str) -> None:
    with pytest.raises(DomainError) as caught:
        domain_from_text(text)
    assert str(caught.value) == words


@pytest.mark.process
@pytest.mark.parametrize(
    ("words", "status", "said"),
    [
        (("ros2", "node", "list"), 1, ""),
        (("exec", "-c", "ros2 topic list"), 1, ""),
        (("exec", "-c", "ros2 run turtlesim turtlesim_node"), 250, "[ros2run]: Aborted\n"),
    ],
)
def test_a_command_in_no_domain_ends_with_the_reason(words: tuple[str, ...], status: int, said: str) -> None:
    done = _run("-m", "day6_tui.main", *words)
    assert (done.returncode, done.stdout) == (status, said)
    assert done.stderr.endswith(NO_NUMBER + "\n") and "Traceback" not in done.stderr


@pytest.mark.process
def test_a_program_of_a_student_in_no_domain_fails_in_init() -> None:
    done = _run("-m", "day6_tui.main", "python", "-c", "import rclpy\nrclpy.init()")
    assert done.returncode == 1
    assert done.stderr.splitlines()[-1] == f"rclpy._rclpy_pybind11.RCLError: {NO_NUMBER}"


def _run(*words: str) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "ROS_DOMAIN_ID": "abc", "DAY6_LINK": "off", "PYTHONPATH": ""}
    return run([sys.executable, *words], env=environment)


@pytest.mark.parametrize("value", ["", "OFF", "LOCALHOST", "SUBNET", "SYSTEM_DEFAULT"])
def test_a_known_discovery_range_is_taken_silently(value: str) -> None:
    assert discovery_warning({"ROS_AUTOMATIC_DISCOVERY_RANGE": value}) is None


@pytest.mark.process
@pytest.mark.parametrize("value", ["off", "NOT_SET", "BANANA"])
def test_an_unknown_discovery_range_is_warned_of_at_every_init_in_the_words_of_rcl(value: str) -> None:
    source = "import rclpy; rclpy.init(); rclpy.shutdown(); rclpy.init(); rclpy.shutdown()"
    done = run(
        [sys.executable, "-m", "day6_tui.main", "python", "-c", source],
        env={**os.environ, "ROS_AUTOMATIC_DISCOVERY_RANGE": value, "DAY6_LINK": "off", "PYTHONPATH": ""},
    )
    words = f"[rcl]: Invalid value '{value}' specified for 'ROS_AUTOMATIC_DISCOVERY_RANGE', assuming localhost only"
    lines = done.stderr.splitlines()
    assert [line[:8] for line in lines] == ["[WARN] ["] * 2
    assert all(line.endswith(words) for line in lines)
