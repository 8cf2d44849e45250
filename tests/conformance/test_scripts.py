"""What the scripts behind the figures of docs/en/trust/conformance.md count as equal, and whether what they take in is named."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from tests.conformance.checkouts import Missing, extract
from tests.conformance.played import Outcome
from tests.conformance.score import ROWS, TESTS, Row, counted
from tests.conformance.strangers import INPUTS as STRANGERS
from tests.conformance.strangers import difference, programs, same_course
from tests.conformance.strangers_built import packages
from tests.conformance.upstream.__main__ import INPUTS as SUITES
from tests.conformance.upstream.__main__ import prepared, read_report, summary, variables

COMMIT = re.compile(r"[0-9a-f]{40}")


def test_every_input_is_a_repository_at_a_commit() -> None:
    strangers, *suites = (json.loads(path.read_text(encoding="utf-8")) for path in (STRANGERS, *SUITES.values()))
    inputs = [*suites, *strangers["repositories"]]
    assert [each["repository"] for each in inputs if not COMMIT.fullmatch(each["commit"])] == []
    names = [each["repository"] for each in strangers["repositories"]]
    assert len(names) == len(set(names)) and len(names) > 30
    assert all(strangers["known"].values()) and all(reason for suite in suites for reason in suite["expected"].values())


# -- checkouts ---------------------------------------------------------------------------------------------------------


@pytest.fixture
def checkout(tmp_path: Path) -> tuple[Path, str]:
    """A folder with a checkout of `somebody/things`, and its first commit; its second one has another text."""
    if shutil.which("git") is None:
        pytest.skip("git is not installed")
    repository = tmp_path / "somebody+things"
    repository.mkdir()

    def git(*arguments: str) -> str:
        settings = ("user.name=a", "user.email=a@localhost", "commit.gpgsign=false", "core.autocrlf=false")
        options = [word for setting in settings for word in ("-c", setting)]
        done = subprocess.run(["git", *options, *arguments], cwd=repository, capture_output=True, text=True, check=True)
        return done.stdout.strip()

    git("init", "--quiet")
    (repository / "pkg").mkdir()
    for text in ("first\r\n", "second\n"):
        (repository / "pkg" / "a.py").write_bytes(text.encode())
        git("add", ".")
        git("commit", "--quiet", "-m", text)
    return tmp_path, git("rev-parse", "HEAD~1")


@pytest.mark.process
def test_a_repository_is_taken_at_its_commit_byte_for_byte(checkout: tuple[Path, str], tmp_path: Path) -> None:
    sources, commit = checkout
    tree = extract("somebody/things", commit, sources, tmp_path / "out")
    assert (tree / "pkg" / "a.py").read_bytes() == b"first\r\n"


@pytest.mark.process
def test_a_repository_or_commit_that_is_not_there_is_told(checkout: tuple[Path, str], tmp_path: Path) -> None:
    sources, _ = checkout
    with pytest.raises(Missing, match="nobody/nothing: no checkout below"):
        extract("nobody/nothing", "0" * 40, sources, tmp_path / "out")
    with pytest.raises(Missing):
        extract("somebody/things", "0" * 40, sources, tmp_path / "out")


# -- upstream's own tests ----------------------------------------------------------------------------------------------

REPORT = """<testsuites><testsuite>
<testcase classname="test.test_x.TestX" name="test_good"/>
<testcase classname="test.test_x.TestX" name="test_bad"><failure/></testcase>
<testcase classname="test.test_x" name="test_plain[1]"><skipped/></testcase>
<testcase classname="test.test_x.TestX" name="test_torn"/>
<testcase classname="test.test_x.TestX" name="test_torn"><error/></testcase>
</testsuite></testsuites>"""


def test_a_test_whose_teardown_fails_failed() -> None:
    assert read_report("test_x.py", REPORT) == {
        "test_x.py::TestX::test_good": "passed",
        "test_x.py::TestX::test_bad": "failed",
        "test_x.py::test_plain[1]": "skipped",
        "test_x.py::TestX::test_torn": "failed",
    }


def test_only_what_is_expected_may_fail_and_what_is_expected_must() -> None:
    assert summary({"a": "passed", "b": "failed"}, {}, {"b": "why"}) == (
        ["-- b: why", "rclpy's own tests: 1 of 2"],
        True,
    )
    assert summary({"a": "failed"}, {}, {})[1] is False
    assert summary({"a": "passed"}, {}, {"a": "why"})[1] is False


def test_a_suite_is_prepared_as_its_data_say(tmp_path: Path) -> None:
    tree = tmp_path / "tree"
    for name in (
        "pkg/test/test_a.py",
        "pkg/test/sub/b_test.py",
        "pkg/test/test_flake8.py",
        "pkg/test/__init__.py",
        "msgs/A.msg",
    ):
        (tree / name).parent.mkdir(parents=True, exist_ok=True)
        (tree / name).touch()
    inputs = {
        "tests": ["pkg/test"],
        "remove": ["pkg/test/__init__.py"],
        "files": {"shim/a.py": "A = 1\n"},
        "path": ["msgs"],
        "install": {"share/msgs": "msgs"},
        "env": {"WHERE": "msgs", "CHECKS": "0"},
    }
    place = tmp_path / "place"
    files = list(prepared(inputs, tree, place, ""))
    assert [(str(file.relative_to(place).as_posix()), folder) for folder, file in files] == [
        ("pkg/test/sub/b_test.py", place / "pkg"),
        ("pkg/test/test_a.py", place / "pkg"),
    ]
    assert (place / "pkg" / "shim" / "a.py").read_text(encoding="utf-8") == "A = 1\n"
    assert not (place / "pkg" / "test" / "__init__.py").exists()
    env = variables(inputs, tree, tmp_path / "prefix", {"PYTHONPATH": "before"})
    assert env["WHERE"] == str(tree / "msgs") and env["CHECKS"] == "0"
    assert env["PYTHONPATH"] == os.pathsep.join([str(tree / "msgs"), "before"])
    assert (tmp_path / "prefix/share/ament_index/resource_index/packages/msgs").is_file()
    assert (tmp_path / "prefix/share/msgs/A.msg").is_file()


# -- strangers ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("one", "other", "same"),
    [
        (["a", "b"], ["a", "b"], True),
        (["up", "tick 1", "tick 2"], ["up", "tick 1", "tick 2", "tick 3"], True),
        (["up", "tick 1", "bye"], ["up", "tick 1", "tick 2", "bye"], True),
        (["up", "tick 1", "bye"], ["up", "tick 1", "tick 2"], False),
        (["up", "tick 1"], ["up", "tick 1", "error"], False),
        (["up", "tick 1"], ["up", "tick 2"], False),
        ([], ["tick 1"], False),
    ],
)
def test_only_how_often_a_program_repeats_itself_may_differ(one: list[str], other: list[str], same: bool) -> None:
    assert same_course(one, other) is same
    assert same_course(other, one) is same


def test_another_exit_status_is_a_difference() -> None:
    assert difference(Outcome("", "", 1), Outcome("", "", -2)) == ["exit status 1, ours -2"]


def test_programs_that_can_be_started_and_need_nothing_else_are_taken(tmp_path: Path) -> None:
    files = {
        "pkg/package.xml": "<package><name>pkg</name></package>",
        "pkg/pkg/talker.py": "import rclpy\nfrom pkg.words import WORDS\ndef main(): rclpy.init()\n",
        "pkg/pkg/words.py": "WORDS = []\n",
        "pkg/pkg/guarded.py": "import rclpy\nif __name__ == '__main__':\n    rclpy.init()\n",
        "pkg/pkg/camera.py": "import cv2, rclpy\ndef main(): rclpy.init()\n",
        "pkg/pkg/writer.py": "import rclpy\ndef main(): open('a', 'w')\n",
        "pkg/test/test_it.py": "import rclpy\ndef main(): rclpy.init()\n",
        "pkg/pkg/broken.py": "import rclpy\ndef main(:\n",
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    found, left_out = programs("somebody/things", tmp_path)
    assert [(each.path, each.module, each.guarded) for each in found] == [
        ("pkg/pkg/guarded.py", "pkg.guarded", True),
        ("pkg/pkg/talker.py", "pkg.talker", False),
    ]
    assert left_out == 2
    assert packages(tmp_path) == {"pkg": tmp_path / "pkg"}


# -- the table ---------------------------------------------------------------------------------------------------------


def test_a_case_is_equal_when_all_tests_with_it_pass() -> None:
    outcomes = {"test_x.py::test_a[1]": "passed", "test_x.py::test_b[1]": "failed", "test_x.py::test_a[2]": "passed"}
    assert counted(Row("", ""), outcomes) == (1, 2)
    assert counted(Row("", "", "test_a"), outcomes) == (2, 2)


def test_every_row_counts_tests_that_exist() -> None:
    for row in ROWS:
        assert f"def {row.test}" in (TESTS / row.file).read_text(encoding="utf-8"), row.what
