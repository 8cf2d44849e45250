"""Grades one submission where its pupil's desktop could run: `python -I -m day6_core.lessons.grading.apart`, started in a cell.

A line of JSON comes on standard input ({"size", "seed", "gradings", "answers"}), then the submission itself; what `Graded.data`
says goes to standard output, with how it was kept apart. The server that starts this believes the shape of nothing.
"""

from __future__ import annotations

import json
import os
import sys
import tempfile
from pathlib import Path

from day6_core.lessons.grading import shield
from day6_core.lessons.grading.grader import Grader
from day6_core.lessons.grading.scenarios import read_grading

NICE = 10
"""Desktops of the lesson that goes on come first."""


def main() -> int:
    shield.hide()
    if sys.platform != "win32":
        os.nice(NICE)
    job = json.loads(sys.stdin.buffer.readline())
    gradings = [read_grading(Path(path)) for path in job["gradings"]]
    grader = Grader(gradings, seed=job["seed"], answers=job["answers"])
    with tempfile.TemporaryDirectory(prefix="d6a-") as folder:
        file = Path(folder, "submission.zip")
        file.write_bytes(sys.stdin.buffer.read(job["size"]))
        (graded,) = grader.grade([file], 1)
    report = {**graded.data(), "shielded": graded.shielded, "problem": graded.problem}
    sys.stdout.write(json.dumps(report) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
