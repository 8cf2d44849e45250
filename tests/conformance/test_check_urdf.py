"""The recorded cases of check_urdf and urdf_to_graphviz (urdfdom 4.0.1), played on our commands."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from day6_core.graph import Graph
from day6_core.ros.programs import load
from day6_core.session.clock import WorldClock
from day6_core.session.program import Program
from day6_core.session.scheduler import Scheduler
from day6_core.session.session import Session
from day6_core.session.streams import Captured
from tests.conformance.golden_cases import GOLDEN
from tests.support.pdf_text import pdf_text


def cases() -> list[dict[str, Any]]:
    return [json.loads(line) for line in (GOLDEN / "check_urdf.jsonl").read_text(encoding="utf-8").splitlines()]


@pytest.mark.parametrize("case", cases(), ids=lambda case: case["name"])
def test_the_tools_answer_as_recorded(case: dict[str, Any], tmp_path: Path) -> None:
    if case["urdf"] is not None:
        (tmp_path / "robot.urdf").write_text(case["urdf"], encoding="utf-8")
    stdout, stderr = Captured(), Captured()
    scheduler = Scheduler(WorldClock())
    # Without our own line about where to look; and it is our drawing that is looked at, whether `dot` is here or not.
    env = {"DAY6_HINTS": "off", "PATH": ""}
    session = Session(scheduler, Graph(), case["argv"], env=env, cwd=tmp_path, stdout=stdout, stderr=stderr)
    program = Program(session, load("urdfdom", case["argv"][0]))
    assert scheduler.run(lambda: program.status is not None, timeout=10.0)
    assert program.status == case["exit_code"]
    assert stdout.text == case["stdout"]
    assert stderr.text == case["stderr"]
    for name, text in case["files_created"].items():
        if name.endswith(".gv"):
            assert (tmp_path / name).read_text(encoding="utf-8") == text
        if name.endswith(".pdf"):
            assert "".join(case["files_created"][name[:-4] + ".gv"].split('"')[1].split()) in pdf_text(tmp_path / name)
