"""How long a class takes to grade, by hand: `python -m tests.grading.table [--submissions N] [--seed WORD] [DAY…]`.

Prints for each day how long that many good submissions take, and how many of them got all points.
"""

from __future__ import annotations

import argparse
import json
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from day6_core.lessons.grading.grader import right_answers
from day6_core.lessons.grading.scenarios import gradings
from tests.e2e.place import DAY6
from tests.grading.article import write
from tests.perf import budgets
from tests.perf.budgets import Row, print_table


def main() -> int:
    """Print the table; return 1 if something isn't kept."""
    days = [each.lesson for each in gradings()]
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--submissions", type=int, default=40)
    parser.add_argument("--seed", default="table")
    parser.add_argument("days", nargs="*", default=days)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        for number in range(options.submissions):
            write(Path(folder, f"{number:03}.zip"), {}, {"pupil": f"pupil {number}", "answers": right_answers(days)})
        missed = print_table(grade(Path(folder), day, options.seed) for day in options.days)
    return int(missed > 0)


def grade(folder: Path, day: str, seed: str) -> Row:
    """How long the submissions in a folder take for one day."""
    seen = folder / "seen.json"
    before, began = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    subprocess.run(
        [*DAY6, "grade", "--lesson", day, "--seed", seed, "--json", str(seen), "--force", str(folder)],
        stdout=subprocess.DEVNULL, check=False,
    )  # fmt: skip
    took, after = time.monotonic() - began, resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    submissions = json.loads(seen.read_text(encoding="utf-8"))["submissions"]
    right = sum(each["points"] == each["most"] for each in submissions)
    budget = budgets.GRADED._replace(what=f"grade: {len(submissions)} submissions of one day")
    return budget.row(took, f"{day}: {cpu:.1f} s of CPU, {right} of {len(submissions)} have all points")


if __name__ == "__main__":
    sys.exit(main())
