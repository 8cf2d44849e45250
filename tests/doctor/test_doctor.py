"""`day6-tui doctor`: every check is real and bounded, and its report can be pasted anywhere."""

from __future__ import annotations

import ast
import os
import re
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

from day6_core.language import LANGUAGES
from day6_core.system.memory import Memory
from day6_tui.locale import Texts, catalogue
from day6_tui.upkeep import checks, doctor, trials
from day6_tui.upkeep.line import LEVELS, Line, note, ok, problem
from tests.support.short_folder import make_short_folder
from tests.support.source_files import nodes, sources


def keys(check: str) -> list[str]:
    return [line.key for line in getattr(checks, check)()]


def levels(check: str) -> set[str]:
    return {line.level for line in getattr(checks, check)()}


def test_a_check_that_stands_still_is_a_problem_and_the_report_goes_on() -> None:
    for_ever = threading.Event()

    def stuck() -> Iterator[Line]:
        yield ok("system.ssh")
        for_ever.wait()

    found = list(doctor.bounded(stuck, 0.4))
    for_ever.set()
    assert [(line.level, line.key) for line in found] == [("ok", "system.ssh"), ("problem", "check.late")]
    assert found[1].values == {"name": "stuck", "seconds": "0 s"}


def test_a_check_that_fails_is_a_problem_with_its_reason() -> None:
    def broken() -> Iterator[Line]:
        yield ok("system.ssh")
        raise ZeroDivisionError("by zero")

    found = list(doctor.bounded(broken, 5))
    assert [line.key for line in found] == ["system.ssh", "check.failed"]
    assert found[1].values["reason"] == "ZeroDivisionError: by zero"


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_text_that_a_check_names_exists(language: str) -> None:
    texts = catalogue(language)
    named = set()
    for path, text in sources("day6_tui/upkeep"):
        for node in nodes(ast.parse(text)) if path.name in ("checks.py", "doctor.py") else ():
            if (
                isinstance(node, ast.Call)
                and isinstance(node.func, ast.Name)
                and node.func.id in ("ok", "note", "problem")
            ):
                for each in node.args[: 2 if node.func.id != "ok" else 1]:
                    named |= {str(part.value) for part in ast.walk(each) if isinstance(part, ast.Constant)}
    whole = {name for name in named if f"doctor.{name}" in texts}
    assert len(whole) > 60
    parts = {name for name in named - whole if name and not any(key.startswith(f"doctor.{name}") for key in texts)}
    # What is left are names compared inside of an expression, not keys.
    assert parts <= {"default", "option", "DAY6_LANG"}, parts


@pytest.mark.parametrize(("language", "level"), [("en", "PROBLEM  "), ("zh", "问题  ")])
def test_a_problem_is_written_with_what_to_do_below_it(language: str, level: str) -> None:
    texts = Texts(language)
    width = max(len(texts(f"doctor.level.{each}")) * (2 if language == "zh" else 1) for each in LEVELS)
    shown = list(doctor.written(problem("python.home", "python.home.todo"), texts, width))
    assert shown[0].startswith(level) and shown[1] == f"{' ' * width}  -> unset PYTHONHOME"
    assert len(list(doctor.written(note("system.ssh"), texts, width))) == 1


def test_neither_home_nor_name_of_the_user_are_shown(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(doctor, "_homes", lambda: ["/home/anna/.local/share/day6-tui/home", "/home/anna"])
    monkeypatch.setattr(doctor, "_user", lambda: "anna")
    said = doctor.anonymous
    assert said("/home/anna/x /home/anna") == "~/x ~"
    assert said("/home/anna/.local/share/day6-tui/home/ros2_ws") == "~/ros2_ws"
    assert said("/home/annabel/x") == "/home/annabel/x"
    assert said("/media/anna/stick, anna: no, banana: yes") == "/media/USER/stick, USER: no, banana: yes"
    monkeypatch.setattr(doctor, "_user", lambda: "in")
    assert said("in tmux") == "in tmux"


def test_control_characters_of_variables_do_not_reach_the_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_NAMESPACE", "a\x1b]0;b\x07\nc")
    lines = [each for line in checks.variables() for each in doctor.written(line, Texts("en"), 7)]
    assert all(line.isprintable() for line in lines) and any("ROS_NAMESPACE=a" in line for line in lines)


def test_variables_are_listed_secrets_hidden_and_slips_named(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in [each for each in os.environ if each.startswith(checks.NOTEWORTHY)]:
        monkeypatch.delenv(name)
    assert keys("variables") == ["variables.none"]
    monkeypatch.setenv("DAY6_HUB_WORD", "chalk and sponge")
    monkeypatch.setenv("DAY6_LANGUAGE", "zh")
    found = list(checks.variables())
    assert [(line.key, line.values["name"]) for line in found] == [
        ("variables", "DAY6_HUB_WORD"),
        ("variables", "DAY6_LANGUAGE"),
        ("variables.close", "DAY6_LANGUAGE"),
    ]
    assert found[0].values["value"] == "***" and found[2].values["close"] == "DAY6_LANG"


@pytest.mark.parametrize(
    ("environment", "key"),
    [
        ({"LANG": "C", "TERM": "xterm"}, "glyphs.no_utf8"),
        ({"LANG": "C.UTF-8", "TERM": "linux"}, "glyphs.simple"),
        ({"LANG": "C.UTF-8", "TERM": "xterm-256color"}, "glyphs.half"),
        ({"LANG": "C.UTF-8", "TERM": "xterm", "NO_COLOR": "1"}, "terminal.no_colour"),
        ({"LANG": "C.UTF-8", "TERM": "dumb"}, "terminal.no_colour.dumb"),
        ({"LANG": "C.UTF-8", "TERM": "xterm", "TMUX": "x"}, "glyphs.pixels.never"),
        ({"LANG": "C.UTF-8", "TERM": "xterm"}, "glyphs.pixels.asked"),
    ],
)
@pytest.mark.skipif(os.name == "nt", reason="terminals there are all alike")
def test_the_report_says_which_pictures_and_why(
    monkeypatch: pytest.MonkeyPatch, environment: dict[str, str], key: str
) -> None:
    monkeypatch.setattr(checks, "terminal_environ", lambda: environment)
    assert key in keys("terminal")


def test_the_language_and_what_has_chosen_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("LANG", "zh_CN.UTF-8")
    (line,) = checks.language()
    assert (line.key, line.values["language"], line.values["by"]) == ("language.by", "zh", "LANG")
    monkeypatch.setenv("DAY6_LANG", "fr")
    assert keys("language") == ["language.unknown", "language.by"] and "problem" in levels("language")


@pytest.mark.parametrize(
    ("environment", "key"),
    [
        ({}, "ros.by.default"),
        ({"ROS_DISTRO": "jazzy"}, "ros.by.variable"),
        ({"ROS_DISTRO": "jazzy", "DAY6_DISTRO": "jazzy"}, "ros.by.handed_on"),
        ({"ROS_DISTRO": "foxy"}, "ros.other"),
    ],
)
def test_the_distribution_and_what_has_chosen_it(
    monkeypatch: pytest.MonkeyPatch, environment: dict[str, str], key: str
) -> None:
    monkeypatch.setattr(checks, "terminal_environ", lambda: environment)
    monkeypatch.setattr(checks.distribution, "current", lambda: "jazzy")
    assert keys("ros")[0] == key


def test_a_real_ros_in_the_terminal_is_noticed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "rclpy").mkdir()
    monkeypatch.setenv("PYTHONPATH", str(tmp_path))
    assert list(checks.ros())[-1] == note("ros.sourced", what=str(tmp_path))


def test_a_package_that_is_missing_or_too_old_is_a_problem(monkeypatch: pytest.MonkeyPatch) -> None:
    wrong = [
        trials.Requirement("numpy", ">=1.26", "1.0", False),
        trials.Requirement("xacro", ">=2.1", None, False),
        trials.Requirement("aiohttp", ">=3.10", None, False, "serve"),
    ]
    monkeypatch.setattr(trials, "requirements", lambda: wrong)
    monkeypatch.setattr(trials, "failing_imports", lambda modules: {"zenoh": "ImportError: no", "yaml": "no"})
    monkeypatch.setattr("day6_tui.textual_private.version", lambda: "99.0.1")
    found = {line.key: line.level for line in checks.packages()}
    assert found == {
        "packages.wrong": "problem",
        "packages.missing": "problem",
        "packages.extra.serve": "note",
        "packages.versions": "ok",
        "packages.textual.untested": "problem",
        "packages.import": "problem",
        "packages.zenoh": "note",
    }


def test_what_is_installed_here_fits_what_was_declared() -> None:
    found = {each.name: each for each in trials.requirements()}
    assert found["textual"].fits and found["numpy"].version and not found["numpy"].extra
    assert not {"hypothesis", "pytest-xdist", "mypy"} & set(found)
    assert found["aiohttp"].extra == "serve"


def test_a_folder_is_tried_by_writing_a_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert trials.cannot_write(tmp_path) == "" and list(tmp_path.iterdir()) == []
    (tmp_path / "file").touch()
    assert trials.cannot_write(tmp_path / "file") != ""
    monkeypatch.setattr(checks, "data_folder", lambda: tmp_path / "not" / "yet")
    assert "folders.not_yet" in keys("folders") and list(tmp_path.iterdir()) == [tmp_path / "file"]
    monkeypatch.setattr(checks.trials, "cannot_write", lambda folder: "Read-only file system")
    assert "problem" in levels("folders")


def test_little_space_is_noted_and_very_little_is_a_problem(monkeypatch: pytest.MonkeyPatch) -> None:
    for free, level, key in (10**9 - 1, "note", "folders.little"), (10**7, "problem", "folders.full"):
        monkeypatch.setattr(checks.shutil, "disk_usage", lambda path, free=free: type("Usage", (), {"free": free}))
        assert {line.level for line in checks.folders() if line.key == key} == {level}


@pytest.mark.skipif(os.name == "nt", reason="no Unix sockets")
def test_a_socket_is_opened_and_reached_and_leaves_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    folder = make_short_folder("d6d-")
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(folder))
    assert keys("sockets") == ["sockets"]
    assert not list(folder.glob(".day6-*"))
    (folder / "file").touch()
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(folder / "file"))
    (line,) = checks.sockets()
    assert (line.level, line.key) == ("problem", "sockets.nowhere")


def test_a_wrong_domain_is_a_problem_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_DOMAIN_ID", "red")
    assert keys("sockets") == [] and keys("graph") == ["graph.domain"]
    monkeypatch.setenv("ROS_DOMAIN_ID", "7")
    assert keys("graph") == ["graph.nobody"]


def test_a_process_on_this_domain_and_one_on_another_are_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    folder = make_short_folder("d6d-")
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(folder))
    monkeypatch.setenv("ROS_DOMAIN_ID", "7")
    for domain in ("7", "8"):
        (folder / domain).mkdir()
        (folder / domain / f"p-0a1b-{os.getppid()}").touch()
    (folder / "7" / f"p-0a1b-{os.getpid()}").touch()
    found = list(checks.graph())
    assert [line.key for line in found] == ["graph.programs", "graph.others"]
    assert found[0].values["count"] == 1 and found[1].values["domains"] == "8"


@pytest.mark.skipif(os.name == "nt", reason="no such limit")
def test_few_open_files_are_a_problem(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("resource.getrlimit", lambda which: (64, 4096))
    assert next(iter(checks.limits())) == problem("limits.files.few", "limits.files.todo", soft="64", hard="4096")


@pytest.mark.parametrize(
    ("wish", "held", "expected"),
    [
        ("500", True, ok("limits.program", most="0.5 GB")),
        ("500", False, ok("limits.program.watched", most="0.5 GB")),
        ("0", True, ok("limits.program.none")),
        ("0", False, ok("limits.program.none")),
    ],
)
def test_it_is_told_who_limits_the_memory_of_programs(
    monkeypatch: pytest.MonkeyPatch, wish: str, held: bool, expected: Line
) -> None:
    monkeypatch.setenv("DAY6_MEMORY_LIMIT", wish)
    monkeypatch.setattr("day6_core.shell.process.memory.is_held_by_system", lambda: held)
    assert list(checks.limits())[-1] == expected


def test_memory_is_told_as_far_as_the_system_tells_it(monkeypatch: pytest.MonkeyPatch) -> None:
    for total, found, kind, free in (
        (8 * 10**9, None, "limits.memory", "?"),
        (8 * 10**9, Memory(8 * 10**9, 4 * 10**9), "limits.memory", "4.0 GB"),
        (8 * 10**9, Memory(8 * 10**9, 10**8), "limits.memory.little", "0.1 GB"),
    ):
        monkeypatch.setattr(checks, "total_memory", lambda total=total: total)
        monkeypatch.setattr(checks, "available", lambda found=found: found)
        (line,) = (each for each in checks.limits() if each.key.startswith("limits.memory"))
        assert (line.key, line.values["free"]) == (kind, free)


@pytest.mark.process
def test_a_module_that_cannot_be_imported_is_named_with_its_reason() -> None:
    failed = trials.failing_imports(("json", "no_such_module_of_anybody"))
    assert (
        list(failed) == ["no_such_module_of_anybody"] and "ModuleNotFoundError" in failed["no_such_module_of_anybody"]
    )


@pytest.mark.process
def test_programs_that_cannot_import_rclpy_say_why(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(trials, "program_environment", lambda: {**os.environ, "PYTHONPATH": ""})
    assert "No module named 'rclpy'" in trials.one_message()


def run(*words: str, **environment: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "day6_tui.main", "doctor", *words],
        env={**os.environ, **environment},
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        encoding="utf-8",
    )


@pytest.mark.process
@pytest.mark.parametrize(
    ("language", "fine", "sent"), [("en", "No problems", "a message arrived"), ("zh", "没有问题", "消息送到了")]
)
def test_the_whole_report_where_all_is_well(language: str, fine: str, sent: str) -> None:
    done = run("--lang", language, DAY6_HUB_WORD="chalk and sponge")
    assert (done.returncode, done.stderr) == (0, ""), done.stdout
    assert sent in done.stdout and done.stdout.splitlines()[-1].startswith(fine)
    assert "chalk" not in done.stdout and "DAY6_HUB_WORD=***" in done.stdout
    assert os.environ["HOME"] not in done.stdout and "\x1b" not in done.stdout
    assert all(line.isprintable() for line in done.stdout.splitlines())


@pytest.mark.process
@pytest.mark.skipif(os.name == "nt", reason="no Unix sockets")
def test_a_report_with_a_problem_has_status_1_and_says_what_to_do() -> None:
    done = run("--lang", "en", DAY6_RUNTIME_DIR="/dev/null/day6")
    assert done.returncode == 1
    assert re.search(r"^PROBLEM  programs cannot meet: .*\n +-> name a folder of your own", done.stdout, re.MULTILINE)
