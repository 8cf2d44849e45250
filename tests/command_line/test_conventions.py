"""What people expect of any command: `--lang` anywhere, `-V`, `help`, suggestions, refusals before anything has begun."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from day6_core.language import VARIABLE
from day6_tui.commands.table import commands
from day6_tui.main import main

NEEDS_NOTHING = [command.name for command in commands() if command.group != "ros" and command.name]


def said(capsys: pytest.CaptureFixture[str], *words: str) -> tuple[int, str, str]:
    """Status, output and errors of `day6-tui WORDS…`."""
    try:
        status = main(list(words))
    except SystemExit as end:
        status = int(end.code or 0)
    return (status, *capsys.readouterr())


@pytest.mark.parametrize("name", NEEDS_NOTHING)
def test_the_language_may_be_named_before_and_after_a_command(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    english = said(capsys, name, "--help")
    for words in (
        ("--lang", "zh", name, "--help"),
        ("--lang=zh", name, "-h"),
        (name, "--lang", "zh", "--help"),
        (name, "--lang=zh", "-h"),
        ("--distro", "humble", "--lang", "zh", name, "--help"),
        ("help", name, "--lang", "zh"),
        ("help", "--lang", "zh", name),
        ("--lang", "zh", "help", name),
    ):
        status, out, err = said(capsys, *words)
        assert (status, err) == (0, "") and out.startswith(f"用法：day6-tui {name}"), words
    assert english[1].startswith(f"usage: day6-tui {name}")
    os.environ[VARIABLE] = "zh"
    assert said(capsys, name, "--help")[1] == out
    assert said(capsys, name, "--help", "--lang", "en") == english


def test_a_language_before_a_command_of_ros_is_for_the_hints_below_its_errors(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert said(capsys, "--lang", "zh", "ros2", "topic", "--help")[1].startswith("usage: ros2 topic")
    assert os.environ[VARIABLE] == "zh"


@pytest.mark.parametrize("words", [("-V",), ("--version",), ("--lang", "zh", "-V"), ("demo", "-V"), ("class", "-V")])
def test_the_version_is_printed(words: tuple[str, ...], capsys: pytest.CaptureFixture[str]) -> None:
    from importlib.metadata import version

    assert said(capsys, *words) == (0, f"day6-tui {version('day6-tui')}\n", "")


@pytest.mark.parametrize(
    ("words", "as_words"),
    [
        (("help",), ("--help",)),
        (("help", "serve"), ("serve", "--help")),
        (("help", "lessons", "new"), ("lessons", "new", "--help")),
        (("help", "ros2", "topic"), ("ros2", "topic", "--help")),
        (("help", "help"), ("help", "--help")),
    ],
)
def test_help_is_the_same_as_the_option(
    words: tuple[str, ...], as_words: tuple[str, ...], capsys: pytest.CaptureFixture[str]
) -> None:
    found = said(capsys, *words)
    assert found == said(capsys, *as_words) and found[0] == 0 and "usage: " in found[1]


REFUSED = [
    (("serv",), "day6-tui: there is no command 'serv'; did you mean serve?"),
    (("help", "serv"), "day6-tui: there is no command 'serv'; did you mean serve?"),
    (("rqt_grap",), "day6-tui: there is no command 'rqt_grap'; did you mean rqt_graph?"),
    (("qqqqqq",), "day6-tui: there is no command 'qqqqqq'; day6-tui --help lists them"),
    (("--scen", "car"), "day6-tui: error: unrecognized arguments: --scen car; did you mean --scene?"),
    (
        ("--theme", "dark", "serve"),
        "day6-tui: error: the command serve comes first, its options after it: day6-tui serve …",
    ),
    (("--scene", "cars"), "invalid choice: 'cars' (choose from turtle, car, world, empty); did you mean car?"),
    (
        ("--distro", "jazy", "env"),
        "invalid choice: 'jazy' (choose from humble, jazzy, kilted, lyrical, rolling); did you mean jazzy?",
    ),
    (("--lang", "fr", "why"), "day6-tui: error: argument --lang: invalid choice: 'fr' (choose from zh, en)"),
    (("--robot", "nofile"), "day6-tui: error: argument --robot: there is no file 'nofile'"),
    (("--robot", "."), "day6-tui: error: argument --robot: '.' is a folder; a file is needed"),
    (("--lesson", "day99"), "there is no lesson 'day99'; the lessons are day1, day2, day3, day4, day5, day6 ("),
    (("--lesson", "daay1"), "day6-tui: error: argument --lesson: there is no lesson 'daay1'; did you mean day1?"),
    (
        ("--lessons", "mine", "--lesson", "day1"),
        "argument --lesson: there is no lesson 'day1'; the lessons are turtle_letter",
    ),
    (("--lessons", "empty", "--lesson", "day1"), "argument --lesson: there is no lesson 'day1', nor any other"),
    (("--lessons", "nowhere"), "day6-tui: error: argument --lessons: 'nowhere' isn't a folder"),
    (("demo",), "day6-tui demo: error: the following arguments are required: DAY"),
    (("demo", "9"), "day6-tui demo: error: argument DAY: there is no lesson 'day9'; the lessons are day1,"),
    (("--home", "afile"), "day6-tui: error: argument --home: 'afile' isn't a folder, and can't become one"),
    (("--detach", "--home", "afile"), "day6-tui: error: argument --home: 'afile' isn't a folder"),
    (("attach", "--home", "afile"), "day6-tui attach: error: argument --home: 'afile' isn't a folder"),
    (("exec", "--home", "afile"), "day6-tui exec: error: argument --home: 'afile' isn't a folder"),
    (("export", "--home", "afile"), "day6-tui export: error: argument --home: 'afile' isn't a folder"),
    (("submit", "--home", "afile"), "day6-tui submit: error: argument --home: 'afile' isn't a folder"),
    (("report", "--home", "afile"), "day6-tui report: error: argument --home: 'afile' isn't a folder"),
    (("serve", "--home", "afile", "--proxied"), "day6-tui serve: error: argument --home: 'afile' isn't a folder"),
    (("serve", "--home", "new"), "day6-tui serve: error: argument --home: needs --proxied"),
    (("serve", "--isolation", "bubble"), "did you mean bubblewrap?"),
    (("--secret", "longenough"), "day6-tui: error: argument --secret: needs --listen, --connect"),
    (("--fps", "0"), "day6-tui: error: argument --fps: '0' isn't a number from 1 to 120"),
    (("exec", "--timeout", "soon"), "day6-tui exec: error: argument --timeout: 'soon' isn't a number of seconds"),
    (("grade", "x.zip", "--jobs", "0"), "day6-tui grade: error: argument --jobs: '0' isn't a number from 1 to 64"),
    (("lessons",), "day6-tui lessons: error: the following arguments are required: VERB"),
    (("wheelhouse",), "day6-tui wheelhouse: error: the following arguments are required: DIR"),
    (("cast", "x", "--at", "nan"), "day6-tui cast: error: argument --at: 'nan' isn't a number of seconds"),
    ((), "day6-tui: the desktop needs a terminal; day6-tui exec runs commands without one"),
]


@pytest.mark.parametrize(("words", "reason"), REFUSED, ids=[" ".join(words) for words, _ in REFUSED])
def test_what_cannot_be_is_refused_at_once_in_one_line(
    words: tuple[str, ...],
    reason: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    (tmp_path / "afile").touch()
    (tmp_path / "empty").mkdir()
    (tmp_path / "mine").mkdir()
    assert main(["lessons", "new", "mine/turtle_letter.md"]) == 0
    capsys.readouterr()
    monkeypatch.setattr("day6_tui.detached.client.start", lambda *words: pytest.fail("a desktop was started"))
    status, out, err = said(capsys, *words)
    assert (status, out, err.count("\n")) == (2, "", 1)
    assert reason in err
    if "--lang" not in words:
        status, out, err = said(capsys, *words, "--lang", "zh")
        assert (status, out, err.count("\n")) == (2, "", 1)
        assert any("\u4e00" <= char <= "\u9fff" for char in err), err


@pytest.mark.process
def test_python_m_day6_tui_is_the_command(tmp_path: Path) -> None:
    done = subprocess.run([sys.executable, "-m", "day6_tui", "serv"], capture_output=True, text=True, cwd=tmp_path)
    assert (done.returncode, done.stdout) == (2, "") and "did you mean serve?" in done.stderr
    done = subprocess.run([sys.executable, "-m", "day6_tui", "help"], capture_output=True, text=True, cwd=tmp_path)
    assert done.returncode == 0 and done.stdout.startswith("usage: day6-tui [OPTION ...]\n")


@pytest.mark.process
def test_python_takes_only_its_own_options_in_front_of_the_file(tmp_path: Path) -> None:
    (tmp_path / "words.py").write_text("import os, sys; print(sys.argv[1:], os.environ.get('DAY6_LANG'))")
    for words, out in (
        (["--lang", "zh", "words.py", "--lang", "en", "-h"], "['--lang', 'en', '-h'] zh\n"),
        (["words.py", "--help"], "['--help'] None\n"),
        (["-c", "print(7)", "-h"], "7\n"),
    ):
        done = subprocess.run(
            [sys.executable, "-m", "day6_tui", "python", *words], capture_output=True, text=True, cwd=tmp_path
        )
        assert (done.returncode, done.stdout, done.stderr) == (0, out, "")


@pytest.mark.process
@pytest.mark.skipif(sys.platform == "win32", reason="a pipe without a reader is a different error on Windows")
@pytest.mark.parametrize("words", ["doctor", "uninstall", "lessons help", "lessons list", "--version"])
def test_a_reader_that_has_seen_enough_ends_the_command_in_silence(words: str, tmp_path: Path) -> None:
    reading, writing = os.pipe()
    os.close(reading)
    command = [sys.executable, "-m", "day6_tui", *words.split()]
    done = subprocess.run(command, stdout=writing, stderr=subprocess.PIPE, text=True, cwd=tmp_path)
    os.close(writing)
    assert (done.returncode, done.stderr) == (128 + 13, "")


@pytest.mark.process
@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="this system has no disk that is always full")
@pytest.mark.parametrize("words", ["doctor", "uninstall", "lessons help", "lessons list", "--version", "help serve"])
def test_a_full_disk_is_reported_in_one_line(words: str, tmp_path: Path) -> None:
    command = [sys.executable, "-m", "day6_tui", *words.split()]
    with open("/dev/full", "wb") as full:
        done = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, text=True, cwd=tmp_path)
    assert (done.returncode, done.stderr) == (1, "day6-tui: write error: No space left on device\n")
