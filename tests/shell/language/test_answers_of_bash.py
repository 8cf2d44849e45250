"""What bash 5.2 and GNU's tools answered to command lines, recorded in `answers_of_bash.jsonl`: ours say the same.

`python -m tests.shell.language.test_answers_of_bash 'LINE' …` appends bash's answers to more lines to that file.
"""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any, NamedTuple

import pytest

RECORDED = Path(__file__).parent / "answers_of_bash.jsonl"


class Answer(NamedTuple):
    """What became of a line in an empty home folder, which is called HOME in the texts."""

    line: str
    status: int
    out: str
    err: str


ANSWERS = [Answer(**json.loads(text)) for text in RECORDED.read_text(encoding="utf-8").splitlines()]


@pytest.mark.skipif(sys.platform == "win32", reason="the words of the system for its errors")
@pytest.mark.parametrize(
    "answer",
    # `yes` is the system's.
    [pytest.param(each, id=each.line, marks=pytest.mark.process if "yes " in each.line else ()) for each in ANSWERS],
)
def test_a_line_is_answered_as_bash_answered_it(machine: Any, tmp_path: Path, answer: Answer) -> None:
    home = tmp_path / "home"
    shutil.rmtree(home / "ros2_ws")
    result = machine.run(answer.line)
    out, err = (text.replace(str(home), "HOME") for text in (result.out, result.err))
    assert (result.status, out, err) == answer[1:]


def asked(line: str) -> Answer:
    """Return what the bash of this machine answers."""
    with tempfile.TemporaryDirectory() as folder:
        home = Path(folder).resolve() / "home"
        home.mkdir()
        env = {"PATH": "/usr/bin:/bin", "HOME": str(home), "USER": "student", "LC_ALL": "C.UTF-8", "TZ": "UTC"}
        done = subprocess.run(
            ["bash", "-c", line], cwd=home, env=env, capture_output=True, stdin=subprocess.DEVNULL, check=False
        )
        out, err = (data.decode().replace(str(home), "HOME") for data in (done.stdout, done.stderr))
    err = re.sub(r"^bash: -c: line \d+: `.*\n", "", err, flags=re.MULTILINE)  # the line that a mistake is in
    return Answer(line, done.returncode, out, re.sub(r"^bash: (?:-c: )?line \d+: ", "bash: ", err, flags=re.MULTILINE))


if __name__ == "__main__":
    with RECORDED.open("a", encoding="utf-8") as file:
        for line in sys.argv[1:]:
            file.write(json.dumps(asked(line)._asdict(), ensure_ascii=False) + "\n")
