"""`ros2 test`: a launch test in a domain of its own."""

from __future__ import annotations

import re

import pytest


def test_a_file_that_is_not_there_is_told(machine):
    result = machine.ros2("test", "nowhere.py")
    assert result.status == 2
    assert "error: Test file 'nowhere.py' does not exist" in result.stderr


@pytest.mark.parametrize(
    ("words", "domain", "told"),
    [
        ([], None, r"Running with ROS_DOMAIN_ID (\d+)\nROS_DOMAIN_ID \1\n"),
        ([], "42", r"ROS_DOMAIN_ID (42)\n"),
        (["--disable-isolation"], None, r"No ROS_DOMAIN_ID\n"),
    ],
)
def test_a_test_is_given_a_domain(machine, words, domain, told):
    (machine.cwd / "it.test.py").touch()
    machine.env.pop("ROS_DOMAIN_ID", None)
    if domain is not None:
        machine.env["ROS_DOMAIN_ID"] = domain
    assert re.fullmatch(told, machine.ros2("test", *words, "it.test.py").stdout)
