"""The recordings themselves: complete, unchanged by a checkout, and free of the machine on which they were made."""

from __future__ import annotations

import json
import re

import pytest

from tests.conformance.golden_cases import GOLDEN
from tests.support.folded import folded

FILES = sorted(path for path in GOLDEN.rglob("*") if path.is_file() and "__pycache__" not in path.parts)
RECORDINGS = {"check_urdf": 42, "colcon": 37, "rclpy_behaviour": 93, "ros2cli": 388}


@pytest.mark.parametrize("name", RECORDINGS)
def test_every_line_is_a_case_with_a_name_of_its_own(name: str) -> None:
    names = [json.loads(line)["name"] for line in (GOLDEN / f"{name}.jsonl").read_text(encoding="utf-8").splitlines()]
    assert len(names) == len(set(names)) == RECORDINGS[name]


@folded("path", FILES, ids=lambda path: path.relative_to(GOLDEN).as_posix())
def test_a_checkout_gives_it_the_line_ends_it_was_committed_with(path) -> None:
    assert b"\r\n" not in path.read_bytes()


def test_no_path_of_the_machine_it_was_recorded_on_is_left() -> None:
    places = re.compile(r"(?<![\w>.~-])/(?:home|root|Users|mnt|opt|tmp|work)/\w[\w./-]*")
    assert {path.name: found for path in FILES if (found := places.findall(path.read_text(encoding="utf-8")))} == {}
