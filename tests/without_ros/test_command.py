"""`day6-tui test`: what a developer and a job of CI see of it."""

from __future__ import annotations

import os
import signal
from pathlib import Path
from xml.etree import ElementTree

import pytest

from day6_core.system.processes import marked
from day6_core.workspace.run_tests import Case, read_cases
from tests.support.waiting import until
from tests.without_ros.repositories import (
    MANIFEST,
    TEST_COUNTER,
    Done,
    message_package,
    python_package,
    result,
    start,
    write,
)
from tests.without_ros.test_plugin import LAUNCH_TEST, SEES, files_in

PASSES = "def test_sum():\n    assert 1 + 1 == 2\n"
FAILS = "def test_sum():\n    assert 1 + 1 == 3\n"
SKIPS = "import pytest\n\n\n@pytest.mark.skip(reason='no robot here')\ndef test_robot():\n    assert False\n"


def run(folder: Path, *words: str, **more: str) -> Done:
    """Run `day6-tui test` in a folder."""
    return result(start("day6-tui", folder, "test", *words, **more))


def lines(done: Done) -> list[str]:
    """What is on standard output, without times."""
    return [line.partition(" [")[0] for line in done.out.splitlines()]


@pytest.mark.process
def test_a_workspace_is_built_and_tested_and_nothing_is_left(tmp_path: Path) -> None:
    message_package(tmp_path / "src/levels")
    test = "from levels.msg import Level\n\n\ndef test_level():\n    assert Level(height=1.0).height == 1\n"
    needs = "<depend>levels</depend>"
    python_package(
        tmp_path / "src/counter", needs=needs, test__test_a=TEST_COUNTER, test__test_b=LAUNCH_TEST, test__test_c=test
    )
    before = files_in(tmp_path)
    done = run(tmp_path)
    assert (done.status, done.err) == (0, ""), done
    assert lines(done) == ["levels: no tests", "counter: passed, 3 passed", "", "packages: 2; tests: 3 passed"]
    assert files_in(tmp_path) == before


@pytest.mark.process
def test_what_failed_is_said_in_the_words_of_pytest_and_the_others_are_tested(tmp_path: Path) -> None:
    python_package(tmp_path / "src/bad", "bad", test__test_sum=FAILS)
    python_package(tmp_path / "src/good", "good", test__test_sum=PASSES)
    done = run(tmp_path, "--parallel-workers", "1")
    assert done.status == 1
    assert "E   assert (1 + 1) == 3" in done.out
    assert lines(done)[:2] == ["bad: FAILED, 1 failed", "good: passed, 1 passed"]
    assert lines(done)[-4:] == [
        "failed:",
        "  bad: bad.test.test_sum::test_sum: assert (1 + 1) == 3",
        "",
        "packages: 2; tests: 1 passed, 1 failed",
    ]


@pytest.mark.process
def test_a_failing_launch_test_of_a_cmake_package_is_red(tmp_path: Path) -> None:
    text = (
        "cmake_minimum_required(VERSION 3.8)\nproject(checks)\nfind_package(ament_cmake REQUIRED)\nif(BUILD_TESTING)\n"
    )
    text += "  find_package(launch_testing_ament_cmake REQUIRED)\n  add_launch_test(test/test_launched.py)\n"
    text += (
        "  find_package(ament_cmake_gtest REQUIRED)\n  ament_add_gtest(arm test/arm.cpp)\nendif()\nament_package()\n"
    )
    test = LAUNCH_TEST.replace("            pass\n", "            self.assertEqual(1, 2)\n")
    write(
        tmp_path / "src/checks",
        {
            "package.xml": MANIFEST.format(name="checks", needs="<depend>counter</depend>", kind="ament_cmake"),
            "CMakeLists.txt": text,
            "test/test_launched.py": test,
        },
    )
    python_package(tmp_path / "src/counter")
    done = run(tmp_path, "--packages-select", "checks")
    assert done.status == 1 and "1 != 2" in done.out, done
    assert "  checks: checks::arm: day6-tui runs only pytest and launch tests" in lines(done)


@pytest.mark.process
def test_skipped_tests_are_told_with_their_reasons_and_alone_are_not_green(tmp_path: Path) -> None:
    python_package(tmp_path, "robot", test__test_robot=SKIPS)
    done = run(tmp_path)
    assert done.status == 1
    assert lines(done) == [
        "robot: skipped, 1 skipped",
        "",
        "skipped:",
        "  robot: robot.test.test_robot::test_robot: no robot here",
        "",
        "packages: 1; tests: 1 skipped",
        "no test was run",
    ]
    write(tmp_path, {"test/test_sum.py": PASSES})
    assert run(tmp_path).status == 0


@pytest.mark.process
def test_without_tests_it_is_red_unless_that_is_allowed(tmp_path: Path) -> None:
    python_package(tmp_path)
    assert run(tmp_path).status == 1
    assert run(tmp_path, "--allow-no-tests").status == 0


@pytest.mark.process
def test_a_package_that_cannot_be_built_is_red_and_those_that_need_it_are_named(tmp_path: Path) -> None:
    python_package(tmp_path / "src/needs_it", "needs_it", needs="<depend>broken</depend>", test__test_sum=PASSES)
    python_package(tmp_path / "src/good", "good", test__test_sum=PASSES)
    broken = python_package(tmp_path / "src/broken", "broken", test__test_sum=PASSES)
    write(broken, {"setup.py": "raise OSError('no such luck')\n"})
    done = run(tmp_path)
    assert done.status == 1
    assert "broken: NOT BUILT" in lines(done) and "good: passed, 1 passed" in lines(done)
    assert "no such luck" in done.err
    assert "not tested, because something was not built: broken, needs_it" in lines(done)


@pytest.mark.process
def test_packages_are_chosen_and_built_with_what_they_need(tmp_path: Path) -> None:
    python_package(tmp_path / "src/needed", "needed", test__test_sum=FAILS)
    test = "import needed\n\n\n" + PASSES
    python_package(tmp_path / "src/chosen", "chosen", needs="<depend>needed</depend>", test__test_sum=test)
    write(python_package(tmp_path / "src/broken", "broken"), {"setup.py": "raise OSError\n"})
    assert run(tmp_path, "--packages-select", "chosen").status == 0
    assert run(tmp_path, "--packages-skip", "needed", "broken").status == 0
    unknown = run(tmp_path, "--packages-select", "absent")
    assert unknown.status == 1 and "absent" in unknown.err


@pytest.mark.process
def test_tests_that_cannot_be_collected_are_red(tmp_path: Path) -> None:
    python_package(tmp_path, test__test_it="import quite_unknown\n", test__test_sum=PASSES)
    done = run(tmp_path)
    assert done.status == 1 and "No module named 'quite_unknown'" in done.out
    assert lines(done)[-1].startswith("packages: 1; tests: ") and "1 failed" in lines(done)[-1]


@pytest.mark.process
def test_junit_files_are_those_of_this_run(tmp_path: Path) -> None:
    python_package(tmp_path / "counter", test__test_sum=FAILS)
    results = tmp_path / "results"
    assert run(tmp_path, "counter", "--junit-dir", "results").status == 1
    assert [(case.name, case.outcome) for case in read_cases(results)] == [
        ("counter.test.test_sum::test_sum", "failed")
    ]
    write(tmp_path / "counter", {"test/test_sum.py": PASSES})
    assert run(tmp_path, "counter", "--junit-dir", "results", "--pytest-args=-k 'sum'").status == 0
    suite = ElementTree.parse(results / "counter/pytest.xml").getroot()
    assert [case.get("name") for case in suite.iter("testcase")] == ["test_sum"]
    assert not list(suite.iter("failure"))


@pytest.mark.process
def test_the_folders_of_colcon_are_kept_where_they_are_wanted(tmp_path: Path) -> None:
    python_package(tmp_path / "src/counter", test__test_sum=PASSES)
    assert run(tmp_path, "--build-dir", ".").status == 0
    assert (tmp_path / "install/counter/share/counter/package.xml").is_file()
    assert {"build", "install", "log", "src"} >= set(os.listdir(tmp_path)) - {".pytest_cache"}


@pytest.mark.process
def test_packages_that_are_tested_at_the_same_time_do_not_see_each_other(tmp_path: Path) -> None:
    for name, other in (("one", "two"), ("two", "one")):
        python_package(
            tmp_path / name, name, test__test_it=SEES.format(name=name, other=other, folder=tmp_path.as_posix())
        )
        (tmp_path / name / name / "COLCON_IGNORE").touch()
    write(tmp_path, {})
    done = run(tmp_path, "--parallel-workers", "2", "--packages-select", "one", "two")
    assert done.status == 0, done
    assert (tmp_path / "one_sees").read_text(encoding="utf-8") == "one"
    assert (tmp_path / "two_sees").read_text(encoding="utf-8") == "two"


@pytest.mark.process
def test_workers_of_xdist_have_graphs_of_their_own_here_too(tmp_path: Path) -> None:
    for name, other in (("one", "two"), ("two", "one")):
        test = SEES.format(name=name, other=other, folder=tmp_path.as_posix())
        write(python_package(tmp_path / "counter"), {f"test/test_{name}.py": test})
    done = run(tmp_path, "--pytest-args=-n 2 --dist loadfile")
    assert done.status == 0, done
    assert (tmp_path / "one_sees").read_text(encoding="utf-8") == "one"
    assert (tmp_path / "two_sees").read_text(encoding="utf-8") == "two"


@pytest.mark.process
def test_a_folder_without_packages_is_told(tmp_path: Path) -> None:
    done = run(tmp_path)
    assert done.status == 1 and "there is no package to test in" in done.err and done.out == ""
    assert run(tmp_path, "absent").status == 2


@pytest.mark.process
def test_a_repository_without_packages_has_its_tests_run(tmp_path: Path) -> None:
    test = "import rclpy\n\n\ndef test_node():\n    rclpy.init()\n    assert rclpy.create_node('n').get_node_names() == ['n']\n"
    write(tmp_path / "library", {"tests/test_it.py": test})
    done = run(tmp_path / "library", "--junit-dir", str(tmp_path / "results"))
    assert (done.status, lines(done)[0]) == (0, "library: passed, 1 passed"), done
    assert (tmp_path / "results/library/pytest.xml").is_file()
    write(tmp_path / "library", {"tests/test_it.py": FAILS})
    assert run(tmp_path / "library").status == 1


@pytest.mark.process
def test_an_environment_of_python_in_the_workspace_is_not_taken_for_packages(tmp_path: Path) -> None:
    python_package(tmp_path / "src/counter", test__test_sum=PASSES)
    write(
        tmp_path / "venv", {"pyvenv.cfg": "", "lib/std_msgs/package.xml": MANIFEST.format(name="x", needs="", kind="y")}
    )
    done = run(tmp_path)
    assert (done.status, lines(done)[-1]) == (0, "packages: 1; tests: 1 passed"), done


@pytest.mark.process
@pytest.mark.parametrize(("options", "waits"), [(["--real-time"], "time.sleep(1000)"), ([], "while True: pass")])
def test_ctrl_c_ends_the_tests_and_leaves_nothing(tmp_path: Path, options: list[str], waits: str) -> None:
    told = "'{DAY6_JOB} {DAY6_RUNTIME_DIR}'.format(**os.environ)"
    test = (
        "import os\nimport pathlib\nimport time\n\n\ndef test_it():\n"
        f"    pathlib.Path('{tmp_path.as_posix()}/mark').write_text({told})\n    {waits}\n"
    )
    python_package(tmp_path, test__test_it=test)
    process = start("day6-tui", tmp_path, "test", *options)
    until(lambda: (tmp_path / "mark").exists() and " " in (tmp_path / "mark").read_text(encoding="utf-8"))
    mark, graph = (tmp_path / "mark").read_text(encoding="utf-8").split()
    process.send_signal(signal.SIGINT)
    assert result(process).status == 130
    assert not Path(graph).exists()
    assert marked(f"DAY6_JOB={mark}") == []


def test_results_are_read_from_all_kinds_of_files(tmp_path: Path) -> None:
    cases = (
        '<testcase classname="a" name="good"/><testcase name="bad"><failure message="no">text</failure></testcase>'
        '<testcase name="worse"><error>text</error></testcase><testcase name="out"><skipped type="x" message="why"/></testcase>'
        '<testcase name="known"><skipped type="pytest.xfail" message="later"/></testcase>'
    )
    write(
        tmp_path,
        {"p/pytest.xml": f"<testsuites><testsuite>{cases}</testsuite></testsuites>", "p/q/broken.xml": "<testsuite>"},
    )
    found = read_cases(tmp_path / "p")
    assert found[:5] == [
        Case("a::good", "passed", ""),
        Case("bad", "failed", "no"),
        Case("worse", "failed", "text"),
        Case("out", "skipped", "why"),
        Case("known", "xfailed", "later"),
    ]
    assert (found[5].name, found[5].outcome) == ("broken.xml", "failed")
