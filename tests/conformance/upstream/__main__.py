"""Runs the tests of ROS's own packages on ours, one process a file as their builds do, and prints how many pass.

    python -m tests.conformance.upstream [SUITE…] --sources FOLDER [--clone] [--real PYTHON] [--only WORD]

A SUITE is a JSON file beside this one (default: all of them). FOLDER holds checkouts of the repositories (see `checkouts.py`;
`--clone` fetches what is missing). `--real` runs the files on that interpreter's packages too, `--only` chooses files by a part
of their names. What looks only at how the sources are written (linters) is left out. The status is 0 when exactly the tests
fail that are expected to. A suite says:

    repository, commit   where the tests are
    tests                folders of tests; each is run beside the folder, away from the sources
    expected             test -> why it fails here; a test is FILE::NAME, of several folders FOLDER/FILE::NAME
    names                patterns of files of tests (default: those of pytest)
    distro               the distribution to run under (default: as anywhere)
    files, remove        texts of files to write beside the tests; files of the checkout that go
    path, install        folders to import from; path in a prefix -> path in the checkout, as its build installs it
    programs             path in the prefix -> text of a Python program, for one that their build makes of C++
    env                  variables; a value that is a path in the checkout becomes that path
    link                 true: processes see each other
    tries                how often a file with a failing test runs at most, where timers go by the wall: passed once, passed
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from day6_core.ros.environment import program_environment
from tests.conformance.checkouts import Missing, extract

INPUTS = {file.stem: file for file in sorted(Path(__file__).parent.glob("*.json"))}
LONGEST_S = 300
"""Seconds for one file."""
_LINTERS = {f"test_{tool}.py" for tool in ("copyright", "flake8", "mypy", "pep257", "xmllint")}

Outcomes = dict[str, str]
"""Test -> "passed", "failed" or "skipped"."""


def run(python: str, files: Iterable[tuple[Path, Path]], env: Mapping[str, str], inputs: Mapping[str, Any]) -> Outcomes:
    """Run test files, each given with the folder to run it in, in processes of their own."""
    outcomes: Outcomes = {}
    for folder, file in files:
        owner = f"{folder.name}/" if len(inputs["tests"]) > 1 else ""
        here = _run_file(python, folder, file, env)
        for _ in range(inputs.get("tries", 1) - 1):
            if "failed" in here.values():
                again = _run_file(python, folder, file, env)
                here = {test: again.get(test, one) if one == "failed" else one for test, one in here.items()}
        outcomes |= {f"{owner}{test}": outcome for test, outcome in here.items()}
        print(f"   {owner}{file.relative_to(folder)}: {_counted(here.values())}", flush=True)
    return outcomes


def _run_file(python: str, folder: Path, file: Path, env: Mapping[str, str]) -> Outcomes:
    report = folder / f"{file.stem}.xml"
    report.unlink(missing_ok=True)
    path = str(file.relative_to(folder))
    options = [env.get("PYTEST_ADDOPTS", ""), "-q", "-p", "no:cacheprovider", f"--junit-xml={report}", path]
    where = {**env, "PYTEST_ADDOPTS": " ".join(options)}  # as colcon: some tests parse the command line
    quiet = subprocess.DEVNULL
    command = [python, "-m", "pytest"]
    try:
        subprocess.run(command, cwd=folder, env=where, timeout=LONGEST_S, stdin=quiet, stdout=quiet, stderr=quiet)
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
    return ", ".join(f"{counts[each]} {each}" for each in ("passed", "failed", "skipped") if counts[each]) or "nothing"


def share(outcomes: Outcomes) -> str:
    """Return how many tests passed, of all that weren't skipped."""
    counts = Counter(outcomes.values())
    return f"{counts['passed']:,} of {counts['passed'] + counts['failed']:,}"


def summary(
    ours: Outcomes, real: Outcomes, expected: Mapping[str, str], suite: str = "rclpy"
) -> tuple[list[str], bool]:
    """Return what to print of a suite, and whether exactly what was expected to fail did."""
    failed = {test for test, outcome in ours.items() if outcome == "failed"}
    lines = [f"-- {test}: {expected[test]}" for test in sorted(failed & set(expected))]
    for test in sorted(failed - set(expected)):
        lines.append(f"!= {test}: not expected to fail{' (the real one fails too)' * (real.get(test) == 'failed')}")
    passes = sorted(test for test in expected if ours.get(test) == "passed")
    lines += [f"== {test}: expected to fail, but passes" for test in passes]
    both = {f"{suite}'s own tests": ours, f"the same on the real {suite}": real}
    lines += [f"{what}: {share(outcomes)}" for what, outcomes in both.items() if outcomes]
    return lines, failed <= set(expected) and not passes


def prepared(inputs: Mapping[str, Any], tree: Path, place: Path, word: str) -> Iterator[tuple[Path, Path]]:
    """Copy the folders of tests out of a checkout; yield where each file of tests is run, and the file."""
    for name in inputs.get("remove", ()):
        (tree / name).unlink()
    for tests in map(tree.joinpath, inputs["tests"]):
        folder = place / tests.parent.relative_to(tree)
        ignored = shutil.ignore_patterns(*_LINTERS)  # the real plugin of launch_testing imports every file of a folder
        there = Path(shutil.copytree(tests, folder / tests.name, ignore=ignored))
        for name, text in inputs.get("files", {}).items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(text, encoding="utf-8")
        found = {each for name in inputs.get("names", ("test_*.py", "*_test.py")) for each in there.rglob(name)}
        yield from ((folder, file) for file in sorted(found) if word in file.name)


def variables(inputs: Mapping[str, Any], tree: Path, prefix: Path, base: Mapping[str, str]) -> dict[str, str]:
    """Install what the tests look for in their own prefix; return the variables they run with, `base` being the others."""
    index = prefix / "share" / "ament_index" / "resource_index" / "packages"
    index.mkdir(parents=True)
    for name, source in inputs.get("install", {}).items():
        (index / Path(name).parts[1]).touch()
        shutil.copytree(tree / source, prefix / name)
    for name, text in inputs.get("programs", {}).items():
        program = prefix / name
        program.parent.mkdir(parents=True, exist_ok=True)
        program.write_text(f"#!{sys.executable}\n{text}", encoding="utf-8")
        program.chmod(0o755)
    given = {key: str(tree / text) if (tree / text).exists() else text for key, text in inputs.get("env", {}).items()}
    paths = {"PYTHONPATH": [str(tree / each) for each in inputs.get("path", ())], "AMENT_PREFIX_PATH": [str(prefix)]}
    joined = {key: os.pathsep.join([*own, *filter(None, [base.get(key)])]) for key, own in paths.items()}
    return {**base, **joined, **given, "PYTHONDONTWRITEBYTECODE": "1"}


def play(suite: str, inputs: Mapping[str, Any], chosen: argparse.Namespace) -> tuple[Outcomes, Outcomes]:
    """Run a suite on ours, and on the real one if there is one."""
    with tempfile.TemporaryDirectory() as name:
        at = Path(name).resolve()
        repository = inputs["repository"].removeprefix("https://github.com/")
        tree = extract(repository, inputs["commit"], chosen.sources, at / "source", clone=chosen.clone)
        files = list(prepared(inputs, tree, at / "tests", chosen.only))
        domain = str(60 + os.getpid() % 40)
        outer = {key: text for key, text in os.environ.items() if key != "ROS_DISTRO"}
        outer |= {"ROS_DOMAIN_ID": domain, "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}
        distro = {"ROS_DISTRO": inputs["distro"]} if "distro" in inputs else {}
        here = {**_environment({**outer, **distro}), "DAY6_LINK": "on" if inputs.get("link") else "off"}
        ours = run(sys.executable, files, variables(inputs, tree, at / "prefix", here), inputs)
        if not chosen.real:
            return ours, {}
        print("   the real one:")
        return ours, run(chosen.real, files, variables(inputs, tree, at / "real", outer), inputs)


def _environment(base: Mapping[str, str]) -> dict[str, str]:
    """Return what a program runs with, in the distribution that `base` asks for."""
    code = "import json, sys; from day6_core.ros.environment import program_environment as made; json.dump(made(), sys.stdout)"
    if "ROS_DISTRO" not in base:
        return program_environment(base)
    done = subprocess.run([sys.executable, "-c", code], env=dict(base), capture_output=True, text=True, check=True)
    return dict(json.loads(done.stdout))


def main() -> int:
    """Run the suites and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("suites", nargs="*", metavar="SUITE", help=f"of {', '.join(INPUTS)} (default: all)")
    parser.add_argument("--sources", type=Path, required=True, metavar="FOLDER", help="with checkouts")
    parser.add_argument("--clone", action="store_true", help="clone into it what is missing")
    parser.add_argument("--real", metavar="PYTHON", help="interpreter with the real packages and pytest")
    parser.add_argument("--only", default="", metavar="WORD", help="a part of names of test files")
    chosen = parser.parse_args()
    if unknown := sorted(set(chosen.suites) - set(INPUTS)):
        parser.error(f"no suite {', '.join(unknown)}")
    good, table = True, ["| tests of | commit | pass |", "| --- | --- | --- |"]
    for suite in chosen.suites or INPUTS:
        inputs = json.loads(INPUTS[suite].read_text(encoding="utf-8"))
        print(f"{suite}: {inputs['repository']}, commit {inputs['commit']}")
        try:
            ours, real = play(suite, inputs, chosen)
        except Missing as error:
            print(error)
            good, ours = False, {}
        else:
            lines, as_expected = summary(ours, real, inputs["expected"], suite)
            good = good and as_expected and bool(ours)
            print(*lines, sep="\n", flush=True)
        table.append(f"| {suite} | {inputs['commit'][:8]} | {share(ours) if ours else 'not run'} |")
    print(*table, sep="\n")
    return 0 if good else 1


if __name__ == "__main__":
    raise SystemExit(main())
