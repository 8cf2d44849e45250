"""Scripts written at random: our shell does with them what bash was recorded to do (`bash_lines.jsonl`)."""

from __future__ import annotations

import json
import shutil
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.conformance.bash_lines import ARGUMENTS, REFUSAL, SAMPLE, hashed, planted, without_programs
from tests.shell.conftest import Machine

ANSWERS = [json.loads(line) for line in SAMPLE.read_text(encoding="utf-8").splitlines()]
PART = 20


@pytest.fixture
def shell(tmp_path: Path) -> Iterator[Machine]:
    made = Machine(tmp_path / "home")
    yield made
    made.desk.close()


@pytest.mark.skipif(sys.platform == "win32", reason="the words of the system for its errors")
@pytest.mark.parametrize("first", range(0, len(ANSWERS), PART))
def test_a_random_script_does_what_it_did_in_bash(shell: Machine, first: int) -> None:
    home = shell.desk.home
    for answer in ANSWERS[first : first + PART]:
        script = without_programs(answer["seed"])
        assert hashed(script) == answer["script"], "the grammar has changed: record the sample anew"
        shutil.rmtree(home)
        home.mkdir()
        planted(home)
        (home / "script.sh").write_text("# the files are there\n" + script, encoding="utf-8")
        result = shell.run(f"bash script.sh {ARGUMENTS[0]} '{ARGUMENTS[1]}' {ARGUMENTS[2]}")
        assert REFUSAL not in result.err, script
        assert (result.status, result.out.replace(str(home), "HOME")) == (answer["status"], answer["out"]), script
        assert bool(result.err.strip()) == answer["err"], (script, result.err)


def test_the_sample_is_large_and_varied() -> None:
    assert len(ANSWERS) >= 100
    assert len({answer["out"] for answer in ANSWERS}) > 50
