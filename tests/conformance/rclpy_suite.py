"""Runs rclpy's own tests on our rclpy, one process a file as its own build does, and prints how many pass.

    python -m tests.conformance.rclpy_suite --sources FOLDER [--clone] [--real PYTHON] [WORD…]

FOLDER holds a checkout of ros2/rclpy (see `checkouts.py`; `--clone` fetches it); `rclpy_suite.json` names the commit, and every
test that is expected to fail, with its reason. `--real` runs the files on that interpreter's rclpy too. A WORD chooses files by
a part of their name. A file with a failing test is run up to three times, because timers are measured by the wall; what passed
once passes. The status is 0 when exactly the expected tests fail.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from collections import Counter
from collections.abc import Iterable, Mapping
from pathlib import Path

from day6_core.ros.environment import program_environment
from tests.conformance.checkouts import Missing, extract

INPUTS = Path(__file__).with_suffix(".json")
LONGEST_S = 240
"""Seconds for one file."""

Outcomes = dict[str, str]
"""Test -> "passed", "failed" or "skipped"."""


def run(python: str, folder: Path, files: list[Path], env: Mapping[str, str]) -> Outcomes:
    """Run test files, each in a process of its own."""
    outcomes: Outcomes = {}
    for file in files:
        here = _run_file(python, folder, file, env)
        for _ in range(2):
            if "failed" in here.values():
                again = _run_file(python, folder, file, env)
                here = {test: again.get(test, one) if one == "failed" else one for test, one in here.items()}
        outcomes |= here
        print(
            f"   {file.name}: {_counted(each for test, each in outcomes.items() if test.startswith(file.name))}",
            flush=True,
        )
    return outcomes


def _run_file(python: str, folder: Path, file: Path, env: Mapping[str, str]) -> Outcomes:
    report = folder / f"{file.stem}.xml"
    report.unlink(missing_ok=True)
    command = [
        python,
        "-m",
        "pytest",
        "-q",
        "-p",
        "no:cacheprovider",
        f"--junit-xml={report}",
        str(file.relative_to(folder)),
    ]
    try:
        subprocess.run(
            command, cwd=folder, env=env, timeout=LONGEST_S, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
    except subprocess.TimeoutExpired:
        return {f"{file.name}::(the file)": "failed"}
    if not report.is_file():
        return {f"{file.name}::(the file)": "failed"}
    return read_report(file.name, report.read_text(encoding="utf-8"))


def read_report(file: str, text: str) -> Outcomes:
    """Return the outcomes in a JUnit report. A test that is reported twice (its teardown failed too) failed."""
    outcomes: Outcomes = {}
    for case in ElementTree.fromstring(text).iter("testcase"):
        owner = (case.get("classname") or "").rpartition(".")[2]
        owner = "" if owner == Path(file).stem else f"{owner}::"
        test = f"{file}::{owner}{case.get('name') or '(the file)'}"
        kinds = {child.tag for child in case}
        outcome = "failed" if kinds & {"failure", "error"} else "skipped" if "skipped" in kinds else "passed"
        if outcomes.get(test) != "failed":
            outcomes[test] = outcome
    return outcomes


def _counted(outcomes: Iterable[str]) -> str:
    counts = Counter(outcomes)
    return (
        ", ".join(f"{counts[each]} {each}" for each in ("passed", "failed", "skipped") if counts[each]) or "nothing ran"
    )


def _share(outcomes: Outcomes) -> str:
    counts = Counter(outcomes.values())
    return f"{counts['passed']} of {counts['passed'] + counts['failed']}"


def summary(
    ours: Outcomes, real: Outcomes, expected: Mapping[str, str], package: str = "rclpy"
) -> tuple[list[str], bool]:
    """Return what to print of a package's tests, and whether exactly what was expected to fail did."""
    failed = {test for test, outcome in ours.items() if outcome == "failed"}
    lines = [f"-- {test}: {expected[test]}" for test in sorted(failed & set(expected))]
    for test in sorted(failed - set(expected)):
        lines.append(f"!= {test}: not expected to fail{' (the real one fails too)' * (real.get(test) == 'failed')}")
    passes = sorted(test for test in expected if ours.get(test) == "passed")
    lines += [f"== {test}: expected to fail, but passes" for test in passes]
    both = {f"{package}'s own test suite": ours, f"the same on the real {package}": real}
    lines += [f"{what}: {_share(outcomes)}" for what, outcomes in both.items() if outcomes]
    return lines, failed <= set(expected) and not passes


def main() -> int:
    """Run both sides and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sources", type=Path, required=True, help="folder with a checkout of ros2/rclpy")
    parser.add_argument("--clone", action="store_true", help="clone it there if it is missing")
    parser.add_argument("--real", metavar="PYTHON", help="interpreter with real rclpy and pytest")
    parser.add_argument("words", nargs="*", help="parts of names of test files (default: all)")
    chosen = parser.parse_args()
    inputs = json.loads(INPUTS.read_text(encoding="utf-8"))
    print(f"{inputs['repository']} {inputs['tag']}, commit {inputs['commit']}")
    with tempfile.TemporaryDirectory() as name:
        try:
            tree = extract(
                inputs["repository"], inputs["commit"], chosen.sources, Path(name) / "source", clone=chosen.clone
            )
        except Missing as error:
            print(error)
            return 2
        folder = Path(name) / "tests"
        folder.mkdir()
        (tree / "rclpy" / "test").rename(folder / "test")
        (folder / "test" / "__init__.py").unlink()  # points rclpy to the C library that its own build has just made
        files = sorted((folder / "test").glob("test_*.py"))
        files = [file for file in files if not chosen.words or any(word in file.name for word in chosen.words)]
        link = {"DAY6_LINK": "off", "PYTHONDONTWRITEBYTECODE": "1"}
        ours = run(sys.executable, folder, files, {**program_environment(), **link})
        real: Outcomes = {}
        if chosen.real:
            print("the real one")
            env = {**os.environ, "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST", "ROS_DOMAIN_ID": "87"}
            real = run(chosen.real, folder, files, env)
    lines, good = summary(ours, real, inputs["expected"])
    print(*lines, sep="\n")
    return 0 if good else 1


if __name__ == "__main__":
    raise SystemExit(main())
