"""Prints the table of docs/en/trust/conformance.md: plays everything that is recorded, and counts what is equal.

    python -m tests.conformance.score [--sources FOLDER --real PYTHON [--colcon COLCON] [--clone]]

Without options it needs nothing but the repository: a row is a count over tests that compare with recordings of the real thing.
`--sources` and `--real` add the rows that need checkouts of public repositories (`checkouts.py`; `--clone` fetches them) and a
real rclpy, `--colcon` the one that needs the real colcon; these rows run strangers' programs, and take half an hour.
The reasons of all differences: `python -m pytest tests/conformance tests/launch`, at the end.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from tests.conformance.upstream.__main__ import read_report

TESTS = Path(__file__).parents[1]


@dataclass(frozen=True)
class Row:
    """A row that is counted over tests: cases are those of the tests of a file whose names begin with `test`."""

    what: str
    file: str
    test: str = "test_"
    unequal: str = "-"
    """How the tests begin whose cases have a known difference."""


ROWS = (
    Row(
        "message, service and action classes: fields, defaults, repr, refusals, bytes, hashes",
        "interfaces/test_real_classes.py",
    ),
    Row(
        "programs of ours, recorded with real rclpy: output, errors, exit status",
        "conformance/test_programs.py",
        "test_a_program_does",
    ),
    Row("rclpy, reference cases", "conformance/test_programs.py", "test_a_reference_program"),
    Row("`ros2`, reference cases", "conformance/test_ros2cli.py"),
    Row("launch files: order, texts, exit status", "launch/test_recorded.py"),
    Row("`colcon`, reference cases", "conformance/test_colcon.py"),
    Row("`check_urdf` and `urdf_to_graphviz`, reference cases", "conformance/test_check_urdf.py"),
    Row(
        "rqt_graph, drawn for combinations of its options",
        "rqt_graph/test_recorded_rqt_graph.py",
        unequal="test_a_combination_with_a_hidden_end",
    ),
)
_CASE = re.compile(r"(?P<test>\w+)\[(?P<case>.*)\]$", re.DOTALL)


def counted(row: Row, outcomes: dict[str, str]) -> tuple[int, int]:
    """Return how many cases of a row are equal, and how many there are. A case is equal when all tests with it pass."""
    cases: dict[str, bool] = {}
    for test, outcome in outcomes.items():
        match = _CASE.search(test.rpartition("::")[2])
        if match and match["test"].startswith(row.test):
            equal = outcome == "passed" and not match["test"].startswith(row.unequal)
            cases[match["case"]] = cases.get(match["case"], True) and equal
    return sum(cases.values()), len(cases)


def recorded() -> Iterator[tuple[str, str]]:
    """Run the tests of the rows and yield the rows."""
    for file in dict.fromkeys(row.file for row in ROWS):
        outcomes = _outcomes(file)
        for row in ROWS:
            if row.file == file:
                equal, total = counted(row, outcomes)
                yield row.what, f"{equal:,} of {total:,}" if total else f"no case was found in {file}"


def _outcomes(file: str) -> dict[str, str]:
    """Run a file of tests, what failed up to twice more: some cases are recorded by the wall clock."""
    outcomes: dict[str, str] = {}
    with tempfile.TemporaryDirectory() as folder:
        report, cases = Path(folder) / "report.xml", Path(folder) / "cases.jsonl"
        environ = {**os.environ, "PYTEST_CASES_TO": str(cases)}
        command = [
            sys.executable,
            "-m",
            "pytest",
            "-q",
            "-o",
            f"cache_dir={folder}",
            f"--junit-xml={report}",
            TESTS / file,
        ]
        for again in ([], ["--lf"], ["--lf"]):
            quiet = subprocess.DEVNULL
            subprocess.run([*command, *again], stdout=quiet, stderr=quiet, cwd=TESTS.parent, env=environ)
            outcomes |= read_report(Path(file).name, report.read_text(encoding="utf-8"))
            for line in cases.read_text(encoding="utf-8").splitlines() if cases.exists() else ():
                test, case, passed = json.loads(line)
                outcomes[f"{file}::{test}[{case}]"] = "passed" if passed else "failed"
            if "failed" not in outcomes.values():
                break
    return outcomes


def names() -> Iterator[tuple[str, str]]:
    """Yield the row of rclpy's public names."""
    told = _output("names")
    found = re.search(r"(\d+) differences in (\d+) names", told)
    yield "public names of rclpy 9.1.2", f"{int(found[2]) - int(found[1]):,} of {int(found[2]):,}" if found else told


def with_sources(options: list[str], real: str, colcon: str | None) -> Iterator[tuple[str, str]]:
    """Yield the rows that need checkouts."""
    told = _output("upstream", *options)
    for suite, passed in re.findall(r"^\| (\w+) \| \w+ \| (.*) \|$", told, re.MULTILINE):
        yield f"{suite}'s own tests", passed
    told = _output("strangers", *options, "--real", real)
    equal = _found(r"(\d+ of \d+ scenarios)", told)
    yield f"strangers' programs from {_found(r'from (.*)$', told)}, run in both", equal
    told = _output("strangers_built", *options, *(["--real", colcon] if colcon else []))
    built = _found(r"(\d+ repositories, \d+ packages), built", told)
    yield f"{built}, built plain and linked: sources changed", _found(r"(\d+) sources changed", told)
    if colcon:
        yield "install trees of strangers' Python packages", _found(r"(\d+ of \d+) install trees", told)


def _output(script: str, *arguments: str) -> str:
    command = [sys.executable, "-m", f"tests.conformance.{script}", *arguments]
    return subprocess.run(command, cwd=TESTS.parent, capture_output=True, text=True, encoding="utf-8").stdout


def _found(pattern: str, text: str) -> str:
    match = re.search(pattern, text, re.MULTILINE)
    return match[1] if match else "not measured"


def main() -> int:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sources", help="folder with checkouts of public repositories")
    parser.add_argument("--clone", action="store_true", help="clone what is missing there")
    parser.add_argument("--real", metavar="PYTHON", help="interpreter with real rclpy")
    parser.add_argument("--colcon", help="the real colcon")
    chosen = parser.parse_args()
    sections = [names(), recorded()]
    if chosen.sources and chosen.real:
        options = ["--sources", chosen.sources, *(["--clone"] if chosen.clone else [])]
        sections.append(with_sources(options, chosen.real, chosen.colcon))
    print("| compared with the real thing | equal |\n| --- | --- |")
    for section in sections:
        for what, equal in section:
            print(f"| {what} | {equal} |", flush=True)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
