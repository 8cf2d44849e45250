"""Programs of the real machine run in the terminal as they do in any other; what is ours stays ours."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from day6_core.session.session import Session
from day6_core.session.streams import Captured, InputStream
from day6_core.shell.language.redirection import Streams
from day6_core.shell.line.completion import Completer
from day6_core.shell.process.real_tools import find_tool, tools_beginning_with

pytestmark = pytest.mark.skipif(os.name == "nt", reason="the programs of these tests are shell scripts")

AWK = '#!/bin/sh\necho "awk: $*"\ncat\n'


@pytest.fixture
def tool(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[str, str], Path]:
    """Puts a program on the real machine's PATH, before the desk is made."""
    folder = tmp_path / "real bin"
    folder.mkdir()
    monkeypatch.setenv("PATH", f"{folder}{os.pathsep}/usr/bin{os.pathsep}/bin")

    def put(name: str, text: str = AWK) -> Path:
        (folder / name).write_text(text)
        (folder / name).chmod(0o755)
        return folder / name

    return put


@pytest.fixture
def with_tool(tool: Callable[[str, str], Path], request: pytest.FixtureRequest) -> Any:
    """A machine with the program `zawk3`."""
    tool("zawk3", AWK)
    return request.getfixturevalue("machine")


@pytest.mark.process
def test_a_program_of_the_real_machine_runs_in_pipes_and_files(with_tool: Any) -> None:
    done = with_tool.run("printf 'a\\nb\\n' | zawk3 '{x}' | tail -n 2 > f; cat f; zawk3 1 < f | head -n 1")
    assert done == (0, "a\nb\nawk: 1\n", "")
    assert with_tool.run("zawk3 < /dev/null > /dev/null; env zawk3 2 < /dev/null").out == "awk: 2\n"


@pytest.mark.process
def test_on_the_terminal_it_has_a_pty_and_its_keys(tool: Callable[[str, str], Path], request: Any) -> None:
    tool("asks", "#!/bin/sh\ntest -t 0 && test -t 1 && echo pty\nread answer\necho got $answer\nexec sleep 1000\n")
    seat = request.getfixturevalue("seat")
    seat.line("asks")
    seat.wait(lambda text: "pty" in text)
    seat.type("yes\r")
    seat.wait(lambda text: "got yes" in text)
    seat.type("\x03")
    assert seat.wait_prompt().splitlines()[-2:] == ["^C", "student@day6:~$"]
    assert seat.line("echo $?").splitlines()[-2] == "130"


@pytest.mark.process
def test_behind_a_pipe_its_output_is_a_terminal_as_wide_as_the_window(
    tool: Callable[[str, str], Path], request: Any
) -> None:
    tool("shows", "#!/bin/sh\ntest -t 0 || test -t 1 && echo $(stty size <&2) $(cat)\n")
    seat = request.getfixturevalue("seat")
    seat.line("echo input | shows; echo input | shows | cat; echo input | shows > f; cat f")
    assert seat.wait_prompt().splitlines()[-2:] == ["24 80 input", "student@day6:~$"]


@pytest.mark.process
def test_ctrl_c_is_for_all_processes_of_a_pipeline(tool: Callable[[str, str], Path], request: Any) -> None:
    tool("endless", "#!/bin/sh\nexec sleep 1000\n")
    tool("collects", "#!/bin/sh\necho began\ncat > all\necho untrue\n")
    seat = request.getfixturevalue("seat")
    seat.line("endless | collects")
    seat.wait(lambda text: "began" in text)
    seat.type("\x03")
    assert seat.wait_prompt().splitlines()[-3:] == ["began", "^C", "student@day6:~$"]
    assert seat.line("echo $?").splitlines()[-2] == "130"


@pytest.mark.process
def test_the_machines_text_tools_speak_english_as_ours_do(tool: Callable[[str, str], Path], request: Any) -> None:
    tool("sort", "#!/bin/sh\necho $LANGUAGE\n")
    done = request.getfixturevalue("machine").run("export LANGUAGE=zh_CN:zh; sort -V; sort f; echo $LANGUAGE")
    assert done.out == "en\nzh_CN:zh\n" and done.err == "sort: cannot read: f: No such file or directory\n"


def test_every_command_that_finds_programs_agrees(with_tool: Any, tool: Callable[[str, str], Path]) -> None:
    place = tool("zawk3", AWK)
    done = with_tool.run("which zawk3; type zawk3; command -v zawk3; which nothing3; echo $?")
    assert done.out == f"{place}\nzawk3 is {place}\n{place}\n1\n"
    assert "zawk3 is already the newest version." in with_tool.run("sudo apt install zawk3").out
    assert with_tool.run("nothing3") == (127, "", "bash: nothing3: command not found\n")

    async def complete(session: Session) -> int:
        found.append(await Completer(with_tool.shell, session).complete("sudo zawk"))
        return 0

    found: list[Any] = []
    with_tool.desk.start_program(
        ["c"], complete, Streams(InputStream(), Captured(), Captured()), env={}, cwd=with_tool.desk.home
    )
    with_tool.go()
    assert found == [(["zawk3"], 5)]


@pytest.mark.parametrize("name", ["ros2", "colcon", "apt", "sudo", "ls", "rviz2"])
def test_what_is_ours_stays_ours(tool: Callable[[str, str], Path], request: Any, name: str) -> None:
    place = tool(name, AWK)
    machine = request.getfixturevalue("machine")
    assert machine.run(f"which {name}").out.strip() not in ("", str(place))
    assert "awk:" not in machine.run(f"{name} --help").out


@pytest.mark.parametrize("name", ["reboot", "shutdown", "poweroff", "su"])
def test_nothing_ends_the_real_machine(tool: Callable[[str, str], Path], request: Any, name: str) -> None:
    tool(name, AWK)
    assert request.getfixturevalue("machine").run(f"sudo {name}") == (127, "", f"bash: {name}: command not found\n")


def test_a_path_of_the_folder_one_is_in_and_odd_entries(tmp_path: Path) -> None:
    (tmp_path / "here").mkdir()
    for name in ("t1", "t2"):
        (tmp_path / "here" / name).write_text("")
    (tmp_path / "here" / "t1").chmod(0o755)
    variables = {"PATH": "/no/such/folder::here"}
    assert find_tool("t1", variables, tmp_path) == str(tmp_path / "here" / "t1")
    assert find_tool("t2", variables, tmp_path) == "" and find_tool("t1", variables, Path("/")) == ""
    assert tools_beginning_with("t", variables, tmp_path) == {"t1"}


@pytest.mark.process
def test_a_program_that_no_system_starts_says_so(tool: Callable[[str, str], Path], request: Any) -> None:
    place = tool("broken", "\x7fELF\0\0")
    done = request.getfixturevalue("machine").run('broken; echo $?; cp "$(which broken)" .; ./broken')
    assert done.out == "126\n" and done.err.count("Exec format error") == 2 and str(place) in done.err


@pytest.mark.parametrize(
    ("line", "out"),
    [
        ("head -c 4 f", "ab\nc"),
        ("head -c -3 f", "ab\ncd\n"),
        ("head -c 0 f", ""),
        ("head --bytes=1K f", "ab\ncd\nefg"),
        ("head -n -1 f", "ab\ncd\n"),
        ("tail -c 4 f", "\nefg"),
        ("tail -c +4 f", "cd\nefg"),
        ("tail -c +0 f", "ab\ncd\nefg"),
        ("tail -c 0 f", ""),
        ("tail -n +3 f", "efg"),
        ("cat f | tail -c 2 | head -c 1", "f"),
        ("printf 你好 | head -c 3", "你"),
        ("printf 你好 | tail -c +4", "好"),
    ],
)
def test_ends_of_files_by_bytes(machine: Any, line: str, out: str) -> None:
    assert machine.run(f"printf 'ab\\ncd\\nefg' > f; {line}") == (0, out, "")


def test_a_count_that_is_none(machine: Any) -> None:
    assert machine.run("head -c x") == (1, "", "head: invalid number of bytes: ‘x’\n")
    assert machine.run("tail -n 1x") == (1, "", "tail: invalid number of lines: ‘1x’\n")
