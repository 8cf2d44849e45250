"""`day6-tui exec`, `shell`, `env` and the start of a student's process, in this process: options, status, messages, files."""

from __future__ import annotations

import io
import os
import signal
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from day6_core.shell.outward import execute, subshell, variables
from day6_core.shell.process import launch_process

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="signals, terminals, limits of POSIX")


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """An empty folder to be in, and this process's signals as they were."""
    monkeypatch.setenv("DAY6_LINK", "off")
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    folder = tmp_path / "here"
    folder.mkdir()
    monkeypatch.chdir(folder)
    before = {number: signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)}
    yield folder
    assert {number: signal.getsignal(number) for number in before} == before


@pytest.mark.parametrize(
    ("arguments", "stdin", "status", "out", "err"),
    [
        (["-c", "echo out; echo err >&2; exit 7"], "", 7, "out\n", "err\n"),
        (["-c", "echo $0 $1 $# \"$@\"", "a", "b c"], "", 0, "bash a 2 a b c\n", ""),
        (["-c", "pwd"], "", 0, "HERE\n", ""),
        (["file.sh", "x", "y"], "", 3, "file x y\n", ""),
        ([], "echo from $#\necho input; false", 1, "from 0\ninput\n", ""),
        (["nowhere.sh"], "", 127, "", "day6-tui exec: nowhere.sh: No such file or directory\n"),
        (["--home", "odd", "-c", "true"], "", 1, "", "day6-tui exec: the home folder cannot be used: HERE/odd/ros2_ws/src: "),
        (["--home", "h", "-c", "cd; pwd; ls"], "", 0, "HERE/h\nros2_ws\n", ""),
        (["--timeout", "0.5", "-c", "echo a; sleep 60"], "", 124, "a\n", ""),
        (["-c", "break; echo on"], "", 0, "on\n", "bash: break: only meaningful in a `for', `while', or `until' loop\n"),
        (["-c", "sleep 60 & echo behind"], "", 0, "behind\n", ""),
        (["-c", "if"], "", 2, "", "bash: syntax error: unexpected end of file\n"),
    ],
)  # fmt: skip
def test_exec_runs_lines_and_exits_with_their_status(
    here: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str],
    arguments: list[str], stdin: str, status: int, out: str, err: str,
) -> None:  # fmt: skip
    (here / "file.sh").write_text("echo file $1 $2\nexit 3\n")
    (here / "odd").mkdir()
    (here / "odd" / "ros2_ws").write_text("no folder")
    monkeypatch.setattr(sys, "stdin", io.StringIO(stdin))
    assert execute.main(arguments) == status
    said = capsys.readouterr()
    assert said.out.replace(str(here), "HERE") == out
    assert said.err.replace(str(here), "HERE").startswith(err) and bool(said.err) == bool(err)


@pytest.mark.process
def test_exec_ends_with_the_signals_that_end_a_shell(
    here: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    with open(os.devnull, encoding="utf-8") as nothing:
        monkeypatch.setattr(sys, "stdin", nothing)
        for number, status in ((signal.SIGTERM, 143), (signal.SIGHUP, 129), (signal.SIGINT, 130)):
            # What ends on its own at that moment does not end the line, as in bash: it has to be there still.
            line = f"import os, time; os.kill({os.getpid()}, {int(number)}); time.sleep(30)"
            assert execute.main(["-c", f"python3 -c '{line}'; sleep 30"]) == status


def test_env_prints_only_what_differs(here: Path, capsys: pytest.CaptureFixture[str], monkeypatch: Any) -> None:
    assert variables.main([]) == 0
    lines = capsys.readouterr().out.splitlines()
    names = [line.removeprefix("export ").partition("=")[0] for line in lines]
    assert all(line.startswith("export ") for line in lines) and {"PATH", "PYTHONPATH", "ROS_DISTRO"} <= set(names)
    monkeypatch.setenv("ROS_DISTRO", next(line for line in lines if "ROS_DISTRO" in line).partition("=")[2])
    assert variables.main([]) == 0
    assert "ROS_DISTRO" not in capsys.readouterr().out


def test_env_writes_the_settings_of_editors_and_names_the_files(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (here / "project").mkdir()
    assert variables.main(["--vscode", "project"]) == 0
    said = capsys.readouterr().out.splitlines()
    assert said[0].split(" ", 1)[1].startswith("packages of interfaces are in ")
    assert all(line.startswith("wrote ") for line in said[1:]) and (here / "project" / ".vscode/settings.json").exists()
    assert not (here / "project" / ".idea").exists()
    assert variables.main(["--pycharm", "project"]) == 0
    assert (here / "project" / ".idea").exists()
    with pytest.raises(SystemExit) as end:
        variables.main(["--vscode", "nowhere"])
    assert end.value.code == 2
    said = capsys.readouterr().err
    assert said == f"day6-tui env: error: argument FOLDER: '{here}/nowhere' isn't a folder\n"


def test_the_sub_shell_is_the_users_with_a_start_file_that_goes_away(
    here: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    calls: list[tuple[list[str], str]] = []

    def call(words: list[str], env: dict[str, str]) -> int:
        file = Path(words[2]) if len(words) > 2 else None
        calls.append((words, file.read_text() if file is not None else ""))
        return 5

    monkeypatch.setattr(signal, "signal", lambda number, handler: signal.SIG_DFL)
    monkeypatch.setattr(subshell, "call", call)
    monkeypatch.setenv("SHELL", "/usr/bin/bash")
    assert subshell.main([]) == 5
    (words, text) = calls.pop()
    assert (words[0], words[1], words[3]) == ("/usr/bin/bash", "--rcfile", "-i") and not Path(words[2]).exists()
    assert text.splitlines()[0] == "[ -f ~/.bashrc ] && . ~/.bashrc" and "PS1='(day6) '\"$PS1\"" in text
    assert capsys.readouterr().err == "ros2 and python3 are day6-tui's in this shell (bash); exit ends it.\n"
    monkeypatch.setenv("SHELL", "/bin/dash")
    assert subshell.main([]) == 5 and calls.pop()[0] == ["/bin/dash"]
    monkeypatch.delenv("SHELL")
    assert subshell.main([]) == 5 and calls.pop()[0] == ["/bin/sh"]


@pytest.mark.process
@pytest.mark.parametrize(("code", "status"), [("raise SystemExit(3)", 3), ("import os; os.kill(os.getpid(), 9)", 137)])
def test_the_status_of_a_child_that_has_the_terminal(code: str, status: int) -> None:
    assert subshell.call([sys.executable, "-S", "-c", code], dict(os.environ)) == status


def test_the_environment_of_the_sub_shell_has_our_commands_first_and_then_our_python(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("PATH", f"/a{os.pathsep}{Path(sys.executable).parent}{os.pathsep}/b")
    folders = subshell.environment()["PATH"].split(os.pathsep)
    assert folders[1:] == [str(Path(sys.executable).parent), "/a", "/b"]


@pytest.mark.parametrize(
    ("mode", "memory", "soft", "hard", "limited"),
    [("no-tty", "0", -1, -1, None), ("no-tty", "500", -1, -1, 500), ("tty", "500", -1, 400, 400),
     ("no-tty", "500", 300, 900, None), ("no-tty", "500", 600, 900, 500)],
)  # fmt: skip
def test_a_process_is_prepared_before_the_program_takes_its_place(
    monkeypatch: pytest.MonkeyPatch, mode: str, memory: str, soft: int, hard: int, limited: int | None
) -> None:
    import fcntl
    import resource
    import termios

    done: dict[str, Any] = {"limits": {}, "signals": [], "terminal": []}
    monkeypatch.setattr(sys, "argv", ["launch", mode, "7", memory, "/bin/prog", "prog", "a", "b"])
    monkeypatch.setattr(os, "nice", lambda value: done.update(nice=value))
    monkeypatch.setattr(os, "execv", lambda path, argv: done.update(program=(path, argv)))
    monkeypatch.setattr(signal, "signal", lambda number, action: done["signals"].append((number, action)))
    monkeypatch.setattr(fcntl, "ioctl", lambda *words: done["terminal"].append(words))
    monkeypatch.setattr(resource, "getrlimit", lambda kind: (soft, hard) if kind == resource.RLIMIT_DATA else (8, 9))
    monkeypatch.setattr(resource, "setrlimit", lambda kind, limits: done["limits"].update({kind: limits}))
    launch_process.main()
    assert done["program"] == ("/bin/prog", ["prog", "a", "b"]) and done["nice"] == 7
    assert dict(done["signals"]) == dict.fromkeys(
        (signal.SIGINT, signal.SIGQUIT, signal.SIGTERM, signal.SIGHUP, signal.SIGPIPE), signal.SIG_DFL
    )
    assert done["terminal"] == ([(0, termios.TIOCSCTTY, 0)] if mode == "tty" else [])
    assert done["limits"].pop(resource.RLIMIT_CORE) == (0, 9)
    assert done["limits"] == ({} if limited is None else {resource.RLIMIT_DATA: (limited, hard)})
