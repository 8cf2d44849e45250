"""Whatever a package looks like and however it is built: the pupil's files are the same afterwards, to the byte."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import pytest
from shapes import CMAKE, PYTHON, STEPS, changes, lay_out, snapshot
from workshop import Workshop

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="most shapes need links")

PATIENCE = 600.0


def build(workshop: Workshop, options: str, cwd: Path | None = None) -> tuple[int, str]:
    running = workshop.start(f"colcon build {options}", workshop.terminal(cwd))
    workshop.wait(lambda: running.program.status is not None, PATIENCE)
    assert running.program.status is not None
    return running.program.status, running.out.text + running.err.text


def results(output: str) -> dict[str, str]:
    return dict(re.findall(r"(?m)^(?:Finished|Failed|Aborted) +<<< (\S+) \[[\d.]+s(.*)\]$", output))


def test_no_shape_of_a_package_costs_a_source_file(workshop: Workshop) -> None:
    shapes = {**PYTHON, **CMAKE}
    assert len(shapes) >= 90
    for step, (option, later) in enumerate(STEPS):
        lay_out(workshop.workspace / "src", shapes, later)
        before = snapshot(workshop.home)
        _, output = build(workshop, f"--continue-on-error {option}")
        kept = {path: what for path, what in before.items() if path.startswith("ros2_ws/src") or "ros2_ws" not in path}
        after = {
            path: what
            for path, what in snapshot(workshop.home).items()
            if path.startswith("ros2_ws/src") or path in kept
        }
        assert changes(kept, after) == [], f"step {step}: colcon build {option}"
        ended = results(output)
        assert ended.keys() == shapes.keys()
        for name, shape in shapes.items():
            used = shape.later if later and shape.later is not None else shape
            failed = used.fails or used.refused or (used.fails_linked and bool(option))
            assert bool(ended[name]) == failed, f"step {step}, {name}: {ended[name]}\n{output}"
