"""The faults of beginners: each is named, and says what to type next. How soon it is, `table.py` measures."""

from __future__ import annotations

from pathlib import Path

import pytest

from day6_core.lessons.remarks import FAULTS
from tests.inspector.drills import DRILLS, Drill
from tests.inspector.lab import Lab
from tests.inspector.scenes import INJECTED

WITHOUT_COMMAND = frozenset({"ctrl_c", "shut_twice", "setuptools", "no_robot_model", "robot_model_deaf"})
"""Findings that no command of a terminal helps: they are harmless, or a matter of RViz's window."""


PLAYED = (
    *("d1", "d9", "d12", "d14", "d17", "d21", "d26", "d30", "d44", "d46"),
    *("i1", "i2", "i3", "i4", "i5", "i6b", "i7b", "i9"),
)
"""The faults in messages and inside programs that are played here; all are by the tables, and replayed by `test_replayed.py`."""

ALL = (*DRILLS, *(drill for drill in INJECTED if drill.number in PLAYED))


@pytest.mark.process
@pytest.mark.parametrize("drill", ALL, ids=lambda drill: f"{drill.number}-{drill.findings[0]}")
def test_the_fault_is_named_with_what_to_type_next(lab: Lab, drill: Drill) -> None:
    drill.inject(lab)
    found, _ = lab.finds(*drill.findings)
    assert found is not None, f"{sorted(lab.findings)}\n{lab.screen()}"
    key = found.id.removeprefix("inspector.")
    assert found.next or key in WITHOUT_COMMAND or key.startswith(("wheel_", "world."))
    assert str(Path.home()) not in found.text


def test_every_fault_of_the_list_has_a_drill() -> None:
    numbers = {int("".join(filter(str.isdigit, drill.number))) for drill in DRILLS}
    assert numbers >= set(range(1, FAULTS + 1))
