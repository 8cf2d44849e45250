"""What the GitHub action runs, played on workspaces: green by tests that pass, and red by everything else."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
import yaml

from tests.project.sample_workspace import FAILS, PASSES, package
from tests.support.source_files import ROOT

pytestmark = pytest.mark.process

ACTION = ROOT / ".github/actions/workspace/action.yml"


def run(workspace: Path, packages: str = "", distro: str = "jazzy", allow_no_tests: str = "false") -> tuple[int, str]:
    """Run the action's last step; returns its status and all it prints."""
    step = yaml.safe_load(ACTION.read_text(encoding="utf-8"))["runs"]["steps"][-1]
    said = {"WORKSPACE": str(workspace), "PACKAGES": packages, "DISTRO": distro, "ALLOW_NO_TESTS": allow_no_tests}
    assert set(step["env"]) == set(said)
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    given = {"RUNNER_TEMP": str(workspace / "runner"), "GITHUB_OUTPUT": str(workspace / "output")}
    done = subprocess.run(
        ["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", step["run"]],  # as GitHub runs it
        env={**os.environ, "PATH": path, **said, **given},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        encoding="utf-8",
    )
    return done.returncode, done.stdout


def test_tests_that_pass_are_green(tmp_path: Path) -> None:
    package(tmp_path, "good", PASSES)
    status, said = run(tmp_path)
    assert (status, said.splitlines()[-1]) == (0, "packages: 1; tests: 1 passed")
    assert (tmp_path / "output").read_text(encoding="utf-8") == f"junit={tmp_path}/runner/day6-junit\n"
    assert (tmp_path / "runner/day6-junit/good/pytest.xml").is_file()


def test_a_test_that_fails_is_red_though_others_pass(tmp_path: Path) -> None:
    package(tmp_path, "good", PASSES)
    package(tmp_path, "bad", FAILS)
    assert run(tmp_path)[0] == 1


def test_a_package_that_cannot_be_built_is_red_though_the_tests_of_others_would_pass(tmp_path: Path) -> None:
    package(tmp_path, "good", PASSES)
    package(tmp_path, "broken", PASSES, setup="raise SystemExit('no')\n")
    assert run(tmp_path)[0] == 1


def test_a_workspace_without_tests_is_red_unless_that_is_allowed(tmp_path: Path) -> None:
    package(tmp_path, "untested")
    status, said = run(tmp_path)
    assert (status, said.splitlines()[-1]) == (1, "no test was run")
    assert run(tmp_path, allow_no_tests="true")[0] == 0


def test_chosen_packages_are_built_with_what_they_need_and_only_they_are_tested(tmp_path: Path) -> None:
    package(tmp_path, "needed", FAILS)
    package(tmp_path, "chosen", "import needed\n\n" + PASSES, needs="<depend>needed</depend>")
    package(tmp_path, "broken", setup="raise SystemExit('no')\n")
    assert run(tmp_path, packages="chosen")[0] == 0
    assert run(tmp_path, packages=" chosen  needed ")[0] == 1


def test_an_unknown_distribution_is_refused(tmp_path: Path) -> None:
    package(tmp_path, "good", PASSES)
    status, said = run(tmp_path, distro="noble")
    assert status == 2 and "noble" in said
