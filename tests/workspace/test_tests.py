"""`colcon test` runs the tests of a package, `colcon test-result` tells what came of them."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import pytest

from tests.workspace.workshop import Workshop

GOOD = "def test_one():\n    assert 1 + 1 == 2\n"
NOTICE = """\
# Copyright 2026 A. Student
#
# Licensed under the Apache License, Version 2.0 (the "License");
"""
BAD = "def test_two():\n    assert 1 + 1 == 3\n"


def timeless(text: str) -> str:
    return re.sub(r"\[\d+\.\d+s", "[<T>", text)


@pytest.fixture
def package(workshop: Workshop) -> Path:
    folder = workshop.create("hello")
    for file in (folder / "test").iterdir():
        file.unlink()
    (folder / "test" / "test_sum.py").write_text(GOOD, encoding="utf-8")
    return folder


@pytest.mark.process
def test_passing_tests_finish_and_are_counted(workshop: Workshop, package: Path) -> None:
    done = workshop.run("colcon build > /dev/null\ncolcon test\ncolcon test-result --all")
    assert timeless(done.out) == (
        "Starting >>> hello\nFinished <<< hello [<T>]\n\nSummary: 1 package finished [<T>]\n"
        "build/hello/pytest.xml: 1 test, 0 errors, 0 failures, 0 skipped\n\n"
        "Summary: 1 test, 0 errors, 0 failures, 0 skipped\n"
    )
    assert (done.status, done.err) == (0, "")


@pytest.mark.process
def test_a_failing_test_is_no_failed_build_but_is_told(workshop: Workshop, package: Path) -> None:
    (package / "test" / "test_bad.py").write_text(BAD, encoding="utf-8")
    done = workshop.run("colcon build > /dev/null\ncolcon test\necho status $?\ncolcon test-result --verbose")
    assert timeless(done.out).startswith(
        "Starting >>> hello\nFinished <<< hello [<T>]\t[ with test failures ]\n\nSummary: 1 package finished [<T>]\n"
        "  1 package had test failures: hello\nstatus 0\n"
        "build/hello/pytest.xml: 2 tests, 0 errors, 1 failure, 0 skipped\n- hello.test.test_bad test_two\n"
        "  <<< failure message\n"
    )
    assert done.out.endswith("\nSummary: 2 tests, 0 errors, 1 failure, 0 skipped\n")
    assert done.status == 1


@pytest.mark.process
def test_without_pytest_nothing_is_green(workshop: Workshop, package: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A Python without it is played by a module of that name that says what `python -m` says then."""
    blocked = workshop.workspace / "blocked"
    blocked.mkdir()
    (blocked / "pytest.py").write_text("import sys\nsys.exit('No module named pytest')\n", encoding="utf-8")
    monkeypatch.setattr("day6_core.workspace.package_tests.find_spec", lambda name: None)
    done = workshop.run(f"colcon build > /dev/null\nexport PYTHONPATH='{blocked}':\"$PYTHONPATH\"\ncolcon test")
    assert done.status == 1
    assert "No module named pytest" in done.err and "Failed   <<< hello" in done.err
    assert workshop.run("colcon test-result").status == 1


@pytest.mark.process
def test_results_can_be_asked_for_as_a_status(workshop: Workshop, package: Path) -> None:
    (package / "test" / "test_bad.py").write_text(BAD, encoding="utf-8")
    assert workshop.run("colcon build > /dev/null\ncolcon test --return-code-on-test-failure").status == 1


def test_without_results_there_is_nothing_to_tell(workshop: Workshop) -> None:
    done = workshop.run("colcon test-result")
    assert done.status == 2
    assert done.err.endswith("error: argument --test-result-base: Path 'build' does not exist\n")


@pytest.mark.parametrize("encoding", ["utf-8", "utf-16"])
def test_a_result_with_a_document_type_is_skipped(workshop: Workshop, encoding: str) -> None:
    text = (
        f'<?xml version="1.0" encoding="{encoding}"?><!DOCTYPE s [<!ENTITY a "b">]><testsuite tests="1" failures="0"/>'
    )
    (workshop.workspace / "build").mkdir(parents=True, exist_ok=True)
    (workshop.workspace / "build" / "bad.xml").write_bytes(text.encode(encoding))
    done = workshop.run("colcon test-result --all")
    assert "Skipping 'build/bad.xml': a document type is not allowed" in done.err and "0 tests" in done.out


@pytest.mark.process
def test_the_tests_of_a_new_package_find_its_slips(workshop: Workshop) -> None:
    folder = workshop.create("hello", "--node-name hi")
    done = workshop.run(
        "colcon build > /dev/null\ncolcon test --event-handlers console_direct+ console_stderr-\n"
        "colcon test-result --all"
    )
    assert "PytestUnknownMarkWarning" not in done.out
    assert "3 tests, 0 errors, 0 failures, 1 skipped" in done.out, done
    (folder / "hello" / "hi.py").write_text(
        "import math \n\n\ndef main():\n    '''says hello'''\n    print('Hi')\n", encoding="utf-8"
    )
    done = workshop.run("colcon test > /dev/null\ncolcon test-result --verbose")
    assert (
        "3 tests, 0 errors, 1 failure, 1 skipped" in done.out or "3 tests, 0 errors, 2 failures, 1 skipped" in done.out
    )
    report = (workshop.workspace / "build/hello/pytest.xml").read_text(encoding="utf-8")
    assert "hello/hi.py:1:1: F401 " in report and "W291 trailing whitespace" in report


def test_docstrings_and_notices_are_looked_at(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from ament_copyright.main import main as notices
    from ament_pep257.main import main as docstrings

    file = tmp_path / "node.py"
    file.write_text('"""Turns wheels."""\n', encoding="utf-8")
    assert (docstrings([str(tmp_path)]), notices([str(tmp_path)])) == (0, 1)
    file.write_text(f"{NOTICE}'''turns wheels'''\n", encoding="utf-8")
    assert (docstrings([str(tmp_path)]), notices([str(tmp_path)])) == (1, 0)


def test_a_notice_has_a_year_a_name_and_a_license_that_ros_knows(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    from ament_copyright.main import main as notices

    file = tmp_path / "node.py"
    for text, said in {
        "": "",
        NOTICE: "",
        f"#!/usr/bin/env python3\n# -*- coding: utf-8 -*-\n\n{NOTICE}": "",
        NOTICE.replace("2026", "(c) 2020-2024, 2026,"): "",
        NOTICE.replace("2026", "(c) 2025-present"): "could not find copyright notice",
        NOTICE.replace("2026 ", ""): "could not find copyright notice",
        NOTICE.replace("Copyright", "SPDX-FileCopyrightText:"): "could not find copyright notice",
        "# Turns wheels.\n\n" + NOTICE: "could not find copyright notice",
        "# Copyright 2026 A. Student\nx = 1\n": "license=<unknown>",
    }.items():
        file.write_text(text, encoding="utf-8")
        assert notices([str(file)]) == bool(said)
        assert capsys.readouterr().err == (f"{file}: {said}\n" if said else ""), text


def test_a_packages_own_setup_needs_no_notice_and_other_files_do(tmp_path: Path) -> None:
    """ros2/examples has none there, and its tests pass."""
    from ament_copyright.main import main as notices

    setup, inner = tmp_path / "setup.py", tmp_path / "tools" / "setup.py"
    inner.parent.mkdir()
    setup.write_text("from setuptools import setup\n", encoding="utf-8")
    assert notices([str(tmp_path)]) == 1
    (tmp_path / "package.xml").write_text("<package/>\n", encoding="utf-8")
    assert notices([str(tmp_path)]) == 0
    inner.write_text("x = 1\n", encoding="utf-8")
    assert notices([str(tmp_path)]) == 1


LISTS = """\
cmake_minimum_required(VERSION 3.8)
project(mixed)
find_package(ament_cmake REQUIRED)
install(DIRECTORY test DESTINATION share/mixed)
if(BUILD_TESTING)
  find_package(ament_cmake_pytest REQUIRED)
  ament_add_pytest_test(sums test/test_sum.py ENV MOOD=good)
  {more}
endif()
ament_package()
"""
MANIFEST = """\
<package format="3"><name>mixed</name><version>0.1.0</version><description>d</description>
<maintainer email="a@example.org">A</maintainer><license>MIT</license><buildtool_depend>ament_cmake</buildtool_depend>
<export><build_type>ament_cmake</build_type></export></package>
"""
MOOD = "import os\n\n\ndef test_mood():\n    assert os.environ['MOOD'] == 'good'\n"


def cmake_package(workshop: Workshop, more: str = "", test: str = MOOD) -> None:
    folder = workshop.workspace / "src" / "mixed"
    (folder / "test").mkdir(parents=True, exist_ok=True)
    (folder / "CMakeLists.txt").write_text(LISTS.format(more=more), encoding="utf-8")
    (folder / "package.xml").write_text(MANIFEST, encoding="utf-8")
    (folder / "test" / "test_sum.py").write_text(test, encoding="utf-8")


@pytest.mark.process
def test_the_pytest_tests_of_a_cmake_package_run(workshop: Workshop) -> None:
    cmake_package(workshop)
    done = workshop.run("colcon build > /dev/null\ncolcon test\ncolcon test-result --all")
    assert "1 test, 0 errors, 0 failures, 0 skipped" in done.out, done
    assert (done.status, done.err) == (0, "")
    cmake_package(workshop, test=BAD)
    done = workshop.run("colcon test\ncolcon test-result --all")
    assert "1 package had test failures: mixed" in done.out
    assert "1 test, 0 errors, 1 failure, 0 skipped" in done.out and done.status == 1


LAUNCH_TEST = """\
import os
import sys
import unittest

import launch
import launch.actions
import launch_testing.actions


def generate_test_description():
    program = launch.actions.ExecuteProcess(cmd=[sys.executable, '-c', 'print("up"); input()'], output='screen')
    return launch.LaunchDescription([program, launch_testing.actions.ReadyToTest()])


class TestIt(unittest.TestCase):

    def test_domain(self, test_args):
        self.assertEqual(test_args['colour'], 'red')
        self.assertEqual(os.environ['MOOD'], 'good')
        self.assertIn(int(os.environ['ROS_DOMAIN_ID']), {domains})
"""
ISOLATED = """
find_package(ament_cmake_ros REQUIRED)
find_package(launch_testing_ament_cmake REQUIRED)
function(add_ros_isolated_launch_test path)
  set(RUNNER "${ament_cmake_ros_DIR}/run_test_isolated.py")
  add_launch_test("${path}" RUNNER "${RUNNER}" ${ARGN})
endfunction()
add_ros_isolated_launch_test(test/test_launch.py TIMEOUT 300 ARGS colour:=red ENV MOOD=good)
"""


@pytest.mark.process
def test_the_launch_tests_of_a_cmake_package_run_isolated(workshop: Workshop) -> None:
    """The official page "Writing Basic Integration Tests with launch_testing" adds its test in this way."""
    cmake_package(workshop, ISOLATED)
    file = workshop.workspace / "src" / "mixed" / "test" / "test_launch.py"
    file.write_text(LAUNCH_TEST.format(domains="range(1, 102)"), encoding="utf-8")
    assert workshop.run("printenv ROS_DOMAIN_ID").out == "0\n"
    done = workshop.run("colcon build > /dev/null\ncolcon test\ncolcon test-result --all")
    assert "build/mixed/test_results/mixed/test_test_launch.py.xunit.xml: 1 test, 0 errors, 0 failures" in done.out, (
        done
    )
    assert (done.status, done.err) == (0, "")
    cmake_package(workshop, "add_ros_test(test/test_launch.py ARGS colour:=red ENV MOOD=good)")
    file.write_text(LAUNCH_TEST.format(domains="(7,)"), encoding="utf-8")
    done = workshop.run("export ROS_DOMAIN_ID=7\ncolcon build > /dev/null\ncolcon test\ncolcon test-result --all")
    assert (done.status, done.err) == (0, ""), done
    assert "test_test_launch.py.xunit.xml: 1 test, 0 errors, 0 failures" in done.out
    file.write_text(LAUNCH_TEST.format(domains="()"), encoding="utf-8")
    done = workshop.run("colcon test\ncolcon test-result --all")
    assert "1 package had test failures: mixed" in done.out and "1 test, 0 errors, 1 failure" in done.out
    file.write_text("import nothing\n", encoding="utf-8")
    done = workshop.run("colcon test\ncolcon test-result --all")
    assert "1 package had test failures: mixed" in done.out and "1 test, 1 error, 0 failures" in done.out


def test_xml_files_are_looked_at(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    from ament_xmllint.main import main as xmllint

    assert xmllint([str(tmp_path)]) == 1 and capsys.readouterr().err == "No files found\n"
    file = tmp_path / "package.xml"
    file.write_text("<package>\n</package>\n", encoding="utf-8")
    assert xmllint([str(tmp_path)]) == 0 and capsys.readouterr().out.endswith("is valid\n\nNo problems found\n")
    file.write_text("<package>\n</pakage>\n", encoding="utf-8")
    assert xmllint([str(tmp_path)]) == 1
    assert f"{file}:2: parser error : mismatched tag" in capsys.readouterr().err


@pytest.mark.process
def test_style_is_checked_by_the_configuration_that_a_test_names(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from ament_flake8 import main as ament_flake8

    file = tmp_path / "wide.py"
    file.write_text(f"x = '{'-' * 100}'\n", encoding="utf-8")
    wide = tmp_path / "wide.ini"
    wide.write_text("[flake8]\nmax-line-length = 120\n", encoding="utf-8")
    (tmp_path / ".flake8").write_text("[flake8]\nmax-line-length = 120\n", encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    known = {"flake8": ament_flake8.find_spec("flake8"), "none": None}
    for name, found in known.items():
        monkeypatch.setattr(ament_flake8, "find_spec", lambda _, found=found: found)
        assert ament_flake8.main([str(file)]) == 1, f"ROS reads no configuration that lies about ({name})"
        assert ament_flake8.main(["--linelength", "120", str(file)]) == 0
        if found is not None:
            assert ament_flake8.main(["--config", str(wide), "."]) == 0
            assert ament_flake8.main(["--exclude", "wide.py", "--linelength", "99"]) == 0


def test_only_the_docstring_of_a_function_begins_with_a_capital(tmp_path: Path) -> None:
    from ament_pep257.main import main as pep257

    file = tmp_path / "described.py"
    file.write_text('class Case:\n    """unittest of a thing."""\n', encoding="utf-8")
    assert pep257([str(file)]) == 0
    file.write_text('def case():\n    """unittest of a thing."""\n', encoding="utf-8")
    assert pep257([str(file)]) == 1


@pytest.mark.parametrize("installed", [True, False])
def test_docstrings_are_checked_by_the_codes_that_a_test_names(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, installed: bool
) -> None:
    """As packages have it that write the summary beside the quotes, which ROS's own convention refuses (D213)."""
    from ament_pep257 import main as pep257

    if not installed:
        monkeypatch.setattr(pep257, "find_spec", lambda _: None)
    elif pep257.find_spec("pydocstyle") is None:
        pytest.skip("pydocstyle is not installed")
    file = tmp_path / "described.py"
    text = '"""Wheels."""\n\n\ndef turn() -> None:\n    """Turn the wheels.\n\n    Both.\n    """\n'
    file.write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    assert pep257.main([]) == 1
    assert pep257.main([".", "--add-ignore", "D213"]) == 0
    assert pep257.main([".", "--ignore", "D203", "D213"]) == 0
    assert pep257.main([".", "--select", "D400"]) == 0
    assert pep257.main([".", "--select", "D400", "--add-select", "D213"]) == 1
    assert pep257.main([".", "--convention", "google"]) == 0
    assert pep257.main(["--exclude", "described.py"]) == 0
    assert pep257.main(["--exclude", "other.py", "--", "."]) == 1


def test_linters_end_at_words_that_they_do_not_know(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A test that calls `main()` gives them pytest's own."""
    from ament_copyright.main import main as notices
    from ament_flake8.main import main as style
    from ament_mypy.main import main as types
    from ament_pep257.main import main as docstrings
    from ament_xmllint.main import main as xmllint

    monkeypatch.setattr(sys, "argv", ["pytest", "-q", str(tmp_path)])
    for main in (notices, style, types, docstrings, xmllint):
        with pytest.raises(SystemExit, match="2"):
            main()


def test_linters_leave_out_what_a_test_excludes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from ament_copyright.main import main as notices
    from ament_xmllint.main import main as xmllint

    made = tmp_path / "made"
    made.mkdir()
    (made / "bare.py").write_text("x = 1\n", encoding="utf-8")
    (made / "wrong.xml").write_text("<package>\n", encoding="utf-8")
    (tmp_path / "right.xml").write_text("<package/>\n", encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    assert (notices([]), notices(["--exclude", "made/*.py"]), notices([".", "--exclude", "bare.py"])) == (1, 0, 1)
    assert (xmllint([]), xmllint(["--exclude", "made"]), xmllint(["--exclude", "wrong.xml"])) == (1, 0, 0)
    assert xmllint(["--extensions", "launch"]) == 1, "no such file"


def test_tests_beside_each_other_hold_different_domains() -> None:
    """As `launch_pytest` fixtures of public packages ask for one."""
    from domain_coordinator import domain_id

    with domain_id() as first, domain_id() as second:
        assert 1 <= first < second <= 100
        with pytest.raises(RuntimeError, match=r"^Failed to get a unique ROS domain ID$"), domain_id(lambda: first):
            raise AssertionError
    with domain_id(lambda: first) as again:
        assert again == first, "what was given back can be held"
    with pytest.raises(ZeroDivisionError), domain_id():
        _ = 1 // 0


@pytest.mark.process
def test_types_are_checked_as_in_ros(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The test that some packages have beside those of flake8 and PEP 257."""
    from ament_mypy.main import main as mypy

    assert mypy([str(tmp_path)]) == 1 and capsys.readouterr().err == "No files found\n"
    (tmp_path / "right.py").write_text("import no_such_module\n\nx: int = no_such_module.x\n", encoding="utf-8")
    assert mypy([str(tmp_path)]) == 0, "what is imported may have no types"
    (tmp_path / "wrong.py").write_text("x: int = 'text'\n", encoding="utf-8")
    capsys.readouterr()
    assert mypy([str(tmp_path)]) == 1
    assert "wrong.py:1:10: error: Incompatible types in assignment" in capsys.readouterr().out
    assert mypy(["--exclude", "wrong.py", "--", str(tmp_path)]) == 0
    assert mypy(["--config", str(tmp_path / "none.ini"), str(tmp_path)]) == 1


def test_without_mypy_the_test_of_types_fails_and_says_why(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from ament_mypy import main as ament_mypy

    monkeypatch.setattr(ament_mypy, "find_spec", lambda name: None)
    assert ament_mypy.main([]) == 1
    assert capsys.readouterr().err == "mypy is not installed (pip install mypy)\n"


@pytest.mark.process
def test_tests_that_cannot_run_here_are_named_and_counted_as_skipped(workshop: Workshop) -> None:
    cmake_package(workshop, "ament_add_gtest(speed test/speed.cpp)\n  ament_lint_auto_find_test_dependencies()")
    done = workshop.run("colcon build > /dev/null\ncolcon test\ncolcon test-result --all")
    assert "these of 'mixed' did not run: speed, ament_lint_auto" in done.err
    assert "Summary: 3 tests, 0 errors, 0 failures, 2 skipped" in done.out
    cmake_package(workshop)
    assert "Summary: 1 test, 0 errors" in workshop.run("colcon test\ncolcon test-result --all").out
