"""`/dev/stdout` and its like are a command's own streams: nothing reaches the terminal the desktop itself runs in."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Any

import pytest

from day6_core.session.streams import FileInput, FileOutput
from day6_core.shell.own_streams import TTY, stream_number
from day6_core.whole_file import replace_file

pytestmark = pytest.mark.skipif(os.name != "posix", reason="Windows has no /dev")

OUT = ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1", "//dev/../dev/stdout"]
ERR = ["/dev/stderr", "/dev/fd/2", "/proc/self/fd/2", pytest.param(f"/proc/{os.getpid()}/fd/2", id="by its number")]


@pytest.mark.parametrize("name", OUT)
@pytest.mark.parametrize(
    "line", ["echo hi > {}", "echo hi >> {}", "echo hi | tee {} > /dev/null", "cp f {}", "sort -o {} f", "cat f &> {}"]
)
def test_out_is_the_commands_own(machine: Any, tmp_path: Path, line: str, name: str, capfd: Any) -> None:
    (tmp_path / "f").write_text("hi\n")
    result = machine.run(f'cd "{tmp_path}"\nx=$({line.format(name)} 2>&1); echo "got $x"')
    wanted = "got \n" if "tee" in line else "got hi\n"
    assert (result.out, result.err) == (wanted, "")
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("name", ERR)
def test_err_is_the_commands_own(machine: Any, name: str, capfd: Any) -> None:
    result = machine.run(f"echo hi > {name}; echo two | tee {name}")
    assert (result.out, result.err) == ("two\n", "hi\ntwo\n")
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize(
    "line", ["cat {}", "cat < {}", "wc -l {}", "diff {} g", "cp {} h; cat h", "source {}", "bash {}"]
)
@pytest.mark.parametrize("name", ["/dev/stdin", "/dev/fd/0"])
def test_in_is_the_commands_own(machine: Any, tmp_path: Path, line: str, name: str) -> None:
    (tmp_path / "g").write_text("echo hi\n")
    result = machine.run(f"cd '{tmp_path}'\necho 'echo hi' | " + "{ " + line.format(name) + "; }")
    expected = {"wc": f"1 {name}\n", "di": "", "so": "hi\n", "ba": "hi\n"}.get(line[:2], "echo hi\n")
    assert (result.out, result.err, result.status) == (expected, "", 0)


def test_a_redirection_means_the_streams_as_they_are_by_then(machine: Any, tmp_path: Path) -> None:
    machine.run(f"cd '{tmp_path}'\nls nope > f 2> /dev/stdout; echo three 3> g > /dev/fd/3")
    assert "nope" in (tmp_path / "f").read_text() and (tmp_path / "g").read_text() == "three\n"


def test_what_is_not_there_is_told(machine: Any) -> None:
    result = machine.run("echo a > /dev/fd/7; echo b > /dev/tty; cat /dev/tty")
    assert result.err == (
        "bash: /dev/fd/7: No such file or directory\n"
        "bash: /dev/tty: No such device or address\n"
        "cat: /dev/tty: No such device or address\n"
    )
    assert result.out == ""


def test_the_terminal_is_the_simulated_one(seat: Any) -> None:
    assert "one\n" in seat.line("x=$(echo one 2> /dev/null > /dev/tty)")
    assert "two" in seat.line("(echo t''wo > /dev/tty) > /dev/null 2> /dev/null")
    seat.line("cat /dev/tty > got")
    seat.line("typed")
    seat.type("\x04")
    assert "typed" in seat.line("clear; cat got")


def test_a_link_to_a_stream_is_that_stream(machine: Any, tmp_path: Path, capfd: Any) -> None:
    (tmp_path / "out").symlink_to("/dev/stdout")
    (tmp_path / "again").symlink_to("out")
    result = machine.run(f"cd '{tmp_path}'; echo hi > again")
    assert result.out == "hi\n" and capfd.readouterr() == ("", "")


def test_ordinary_files_are_no_streams(tmp_path: Path) -> None:
    (tmp_path / "loop").symlink_to("loop")
    for path in (tmp_path / "f", tmp_path / "loop", Path("/dev/null"), Path("/proc/1/fd/1"), Path("/dev/fd/x")):
        assert stream_number(path) is None
    assert stream_number(Path("/dev/tty")) == TTY


@pytest.mark.process
@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="by the numbers of Linux' devices")
def test_a_device_that_is_our_own_terminal_is_refused_under_every_name(tmp_path: Path) -> None:
    import pty
    import subprocess

    code = (
        "import os, sys; from pathlib import Path\n"
        "from day6_core.session.streams import FileInput, FileOutput\n"
        "from day6_core.whole_file import replace_file\n"
        "place = Path(os.ttyname(0))\n"
        "for act in (FileInput, FileOutput, lambda path: replace_file(path, b'WRITTEN')):\n"
        "    try: act(place); print('opened')\n"
        "    except OSError as error: print(error.errno)\n"
    )
    master, slave = pty.openpty()
    done = subprocess.run(
        [sys.executable, "-c", code], stdin=slave, stdout=subprocess.PIPE, stderr=slave, text=True, check=True
    )
    os.close(slave)
    os.close(master)
    assert done.stdout == "6\n6\n6\n"


def test_other_devices_and_files_are_opened(tmp_path: Path) -> None:
    FileOutput(Path("/dev/null")).close()
    FileInput(Path("/dev/null")).close()
    replace_file(tmp_path / "f", b"x")
    assert (tmp_path / "f").read_bytes() == b"x"
