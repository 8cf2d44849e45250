"""Runs the tests of the real launch_testing and launch_testing_ros on ours, one process a file, and prints how many pass.

    python -m tests.conformance.launch_testing_suite --sources FOLDER [--clone] [--real PYTHON] [WORD…]

FOLDER holds checkouts of ros2/launch and ros2/launch_ros (see `checkouts.py`; `--clone` fetches them); the JSON beside this file
names the commits. `--real` runs the files on that interpreter's packages too. A WORD chooses files by a part of their name. What
looks only at how the sources are written (linters) is left out. The status is 0 when no test fails.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import tempfile
from pathlib import Path

from day6_core.ros.environment import program_environment
from tests.conformance.checkouts import Missing, extract
from tests.conformance.rclpy_suite import Outcomes, run, summary

INPUTS = Path(__file__).with_suffix(".json")
_LINTERS = ("test_copyright.py", "test_flake8.py", "test_mypy.py", "test_pep257.py", "test_xmllint.py")


def install_examples(tree: Path, tests: Path, prefix: Path) -> None:
    """Install what the tests of launch_testing look for in its prefix: example processes and launch tests."""
    index = prefix / "share" / "ament_index" / "resource_index" / "packages"
    index.mkdir(parents=True)
    (index / "launch_testing").touch()
    (prefix / "lib").mkdir()
    (tree / "example_processes").rename(prefix / "lib" / "launch_testing")
    (prefix / "share" / "launch_testing").mkdir()
    (prefix / "share" / "launch_testing" / "examples").symlink_to(tests / "launch_testing" / "examples")


def test_files(folder: Path, words: list[str]) -> list[Path]:
    """Return the files that pytest collects by their name, chosen by words; remove the linters."""
    found = {*folder.rglob("test_*.py"), *folder.rglob("*_test.py")}
    for file in [file for file in found if file.name in _LINTERS]:
        file.unlink()  # the real plugin imports every file of a folder
        found.discard(file)
    return sorted(file for file in found if not words or any(word in file.name for word in words))


def main() -> int:
    """Run both sides and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument(
        "--sources", type=Path, required=True, help="folder with checkouts of ros2/launch, ros2/launch_ros"
    )
    parser.add_argument("--clone", action="store_true", help="clone them there if they are missing")
    parser.add_argument("--real", metavar="PYTHON", help="interpreter with real launch_testing_ros and pytest")
    parser.add_argument("words", nargs="*", help="parts of names of test files (default: all)")
    chosen = parser.parse_args()
    ours: Outcomes = {}
    real: Outcomes = {}
    with tempfile.TemporaryDirectory() as name:
        for package, place in json.loads(INPUTS.read_text(encoding="utf-8")).items():
            print(f"{package}: {place['repository']}, commit {place['commit']}")
            source = Path(name, place["repository"].partition("/")[2])
            try:
                tree = (
                    extract(place["repository"], place["commit"], chosen.sources, source, clone=chosen.clone) / package
                )
            except Missing as error:
                print(error)
                return 2
            folder, prefix = Path(name, package), Path(name, f"{package}_prefix")
            folder.mkdir()
            tests = (tree / "test").rename(folder / "test")  # away from the sources, which would be imported first
            if package == "launch_testing":
                install_examples(tree, tests, prefix)
            files = test_files(tests, chosen.words)
            options = {
                "PYTEST_ADDOPTS": "--launch-args=dut_arg:=test",
                "AMENT_PREFIX_PATH": str(prefix),
                "PYTHONDONTWRITEBYTECODE": "1",
            }
            ours |= run(sys.executable, folder, files, {**program_environment(), **options})
            if chosen.real:
                print("the real one")
                network = {"ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST", "ROS_DOMAIN_ID": "88"}
                there = os.pathsep.join(filter(None, (str(prefix), os.environ.get("AMENT_PREFIX_PATH"))))
                real |= run(
                    chosen.real, folder, files, {**os.environ, **options, **network, "AMENT_PREFIX_PATH": there}
                )
    lines, good = summary(ours, real, {}, "launch_testing")
    print(*lines, sep="\n")
    return 0 if good else 1


if __name__ == "__main__":
    raise SystemExit(main())
