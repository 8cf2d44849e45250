"""A machine whose time the test moves on."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.support.stepped_machine import SteppedMachine


@pytest.fixture
def machine() -> Iterator[SteppedMachine]:
    machine = SteppedMachine()
    yield machine
    machine.end()


@pytest.fixture
def arm(tmp_path: Path) -> str:
    """A robot with one joint of every kind, a mimic of a mimic, soft limits and a range without 0."""
    joints = {
        "turn": ("continuous", ""),
        "bend": ("revolute", '<limit lower="-1" upper="2" effort="1" velocity="1"/>'),
        "far": ("revolute", '<limit lower="1" upper="2" effort="1" velocity="1"/>'),
        "slide": ("prismatic", '<limit lower="0" upper="0.5" effort="1" velocity="1"/>'),
        "soft": (
            "revolute",
            (
                '<limit lower="-2" upper="2" effort="1" velocity="1"/>'
                '<safety_controller soft_lower_limit="-0.5" soft_upper_limit="1" k_velocity="1"/>'
            ),
        ),
        "stiff": ("revolute", '<limit lower="0.3" upper="0.3" effort="1" velocity="1"/>'),
        "glued": ("fixed", ""),
        "floats": ("floating", ""),
        "follows": ("continuous", '<mimic joint="bend" multiplier="2" offset="0.1"/>'),
        "follows_it": ("continuous", '<mimic joint="follows" multiplier="-1" offset="1"/>'),
    }
    text = '<robot name="arm"><link name="base"/>'
    for name, (kind, inside) in joints.items():
        text += f'<link name="{name}_link"/><joint name="{name}" type="{kind}"><parent link="base"/>'
        text += f'<child link="{name}_link"/>{inside}</joint>'
    file = tmp_path / "arm.urdf"
    file.write_text(text + "</robot>", encoding="utf-8")
    return str(file)
