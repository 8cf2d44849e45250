"""Keys for a program that does not read them: nobody waits for it, nothing is lost, Ctrl-C goes through."""

from __future__ import annotations

import sys
import threading
from typing import Any

import pytest

from day6_core.shell.process import process, pty_keys
from day6_core.shell.process.process import Process, running_processes
from day6_core.shell.process.readiness import has_output
from tests.support.waiting import Deadline, until

pytestmark = [pytest.mark.process, pytest.mark.skipif(sys.platform == "win32", reason="there are no ptys")]

SLEEPER = """\
import sys, termios, time, tty
{mode}
print("ready", flush=True)
while True:
    time.sleep(0.05)
"""
READER = """\
import os, sys, time, tty
tty.setraw(0)
print("ready", flush=True)
while not os.path.exists("go"):
    time.sleep(0.01)
left = {size}
with open("got", "wb") as file:
    while left:
        data = os.read(0, 1000)
        file.write(data)
        left -= len(data)
"""
SHORT = """\
import os, time
print("ready", flush=True)
while not os.path.exists("go"):
    time.sleep(0.01)
"""
COPY_OF_A_FULL_PIPE = """\
import fcntl, sys, termios, time
while int.from_bytes(fcntl.ioctl(0, termios.FIONREAD, bytes(4)), sys.byteorder) < 16_000:
    time.sleep(0.01)
open("copy.txt", "w").write(sys.stdin.read())
"""
MODES = {"cooked": "", "cbreak": "tty.setcbreak(0)", "raw": "tty.setraw(0)"}


def returns(function: Any) -> None:
    """Fail, rather than hang, if `function` does not return."""
    worker = threading.Thread(target=function, daemon=True)
    worker.start()
    until(lambda: not worker.is_alive(), told=lambda: "it blocks")


@pytest.mark.parametrize("mode", MODES)
def test_a_paste_into_a_program_that_does_not_read_stops_nobody(seat: Any, mode: str) -> None:
    (seat.desk.home / "sleeper.py").write_text(SLEEPER.format(mode=MODES[mode]))
    seat.line("python3 sleeper.py")
    seat.wait(lambda text: "ready" in text)
    other = type(seat)(seat.desk)
    seat.terminal.paste(("some text" + "\n" * (mode != "raw")) * 20_000)
    returns(seat.desk.scheduler.advance)
    assert "42" in other.line("echo $((6*7))").split("\n")
    if mode != "raw":
        seat.terminal.send("\x03")
        assert "KeyboardInterrupt" in seat.wait(lambda text: "$" in text.split("\n")[-1] and "Interrupt" in text)
    else:
        other.line("killall -9 python3")  # then the text is the shell's, as in any terminal
        seat.wait(lambda text: "some text" in text)


def test_a_program_that_reads_late_gets_every_key_in_its_order(seat: Any) -> None:
    text = "".join(f"{number:07}\r" for number in range(50_000))
    (seat.desk.home / "reader.py").write_text(READER.format(size=len(text)))
    seat.line("python3 reader.py")
    seat.wait(lambda shown: "ready" in shown)
    for at in range(0, len(text), 100_000):
        seat.terminal.send(text[at : at + 100_000])
    returns(seat.desk.scheduler.advance)
    (seat.desk.home / "go").touch()
    seat.wait_prompt()
    assert (seat.desk.home / "got").read_bytes().decode() == text


def test_keys_typed_as_soon_as_a_program_has_shown_something_are_not_taken_for_a_line(
    seat: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    """However long this machine takes to make the keyboard the program's after it has begun to copy what it writes."""
    (seat.desk.home / "reader.py").write_text(READER.format(size=4))
    (seat.desk.home / "go").touch()
    read = Process._read

    def read_and_stand_still(self: Process, *words: Any) -> None:
        read(self, *words)
        until(lambda: "ready" in "".join(shown))
        seat.terminal.send("abc\r")

    shown: list[str] = []
    write = seat.terminal.write
    monkeypatch.setattr(seat.terminal, "write", lambda text: (shown.append(text), write(text)))
    monkeypatch.setattr(Process, "_read", read_and_stand_still)
    seat.line("python3 reader.py")
    seat.wait(lambda text: "ready" in text)
    seat.wait_prompt()
    assert (seat.desk.home / "got").read_bytes() == b"abc\r"


def test_a_key_that_is_no_character_becomes_a_question_mark(seat: Any) -> None:
    """A terminal can name half of a pair (`CSI 57343 u`); bytes that aren't UTF-8 go through as they are."""
    (seat.desk.home / "reader.py").write_text(READER.format(size=4))
    (seat.desk.home / "go").touch()
    seat.line("python3 reader.py")
    seat.wait(lambda shown: "ready" in shown)
    seat.terminal.send("a\udfff\udcffb")
    seat.wait_prompt()
    assert (seat.desk.home / "got").read_bytes() == b"a?\xffb"


def test_a_key_that_is_no_character_becomes_a_question_mark_at_the_prompt_too(seat: Any) -> None:
    assert "a?b" in seat.line("echo a\ud83db") and not seat.terminal.closed
    seat.line("echo a\udfffb > got")
    assert (seat.desk.home / "got").read_bytes() == b"a?b\n"


def test_what_does_not_fit_beyond_all_bounds_beeps(seat: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pty_keys, "MOST_WAITING", 100_000)
    (seat.desk.home / "sleeper.py").write_text(SLEEPER.format(mode=MODES["cbreak"]))
    seat.line("python3 sleeper.py")
    seat.wait(lambda text: "ready" in text)
    written: list[str] = []
    write = seat.terminal.write
    seat.terminal.write = lambda text: (written.append(text), write(text))
    for _ in range(20):
        seat.terminal.send("x" * 10_000)
    returns(seat.desk.scheduler.advance)
    assert "\a" in written
    seat.terminal.send("\x03")
    seat.wait_prompt()


def test_keys_nobody_read_are_the_shells_also_when_they_were_many(seat: Any) -> None:
    (seat.desk.home / "short.py").write_text(SHORT)
    seat.line("python3 short.py")
    seat.wait(lambda text: "ready" in text)
    seat.terminal.send("".join(f"echo {number:04} >> out\r" for number in range(1000)))
    seat.desk.scheduler.advance()
    (seat.desk.home / "go").touch()
    out = seat.desk.home / "out"

    def meanwhile() -> None:
        seat.desk.scheduler.run(lambda: False, 0.05)
        seat.look()

    until(lambda: out.exists() and "0999" in out.read_text(), meanwhile=meanwhile, told=seat.look)
    assert out.read_text().split() == [f"{number:04}" for number in range(1000)]


def test_a_pipe_into_a_program_that_does_not_read_stops_nobody(seat: Any) -> None:
    home = seat.desk.home
    (home / "big.txt").write_text("a line of a file\n" * 60_000)
    (home / "sleeper.py").write_text("import time\nprint('ready', flush=True)\ntime.sleep(60)\n")
    seat.terminal.send("cat big.txt | python3 sleeper.py\r")
    returns(seat.desk.scheduler.advance)
    seat.wait(lambda text: "ready" in text)
    other = type(seat)(seat.desk)
    assert "42" in other.line("echo $((6*7))").split("\n")
    seat.terminal.send("\x03")
    seat.wait_prompt()


def test_a_program_behind_a_pipe_gets_everything_and_one_that_stops_early_breaks_it(seat: Any) -> None:
    home = seat.desk.home
    text = "".join(f"line {number}\n" for number in range(60_000))
    (home / "big.txt").write_text(text)
    (home / "copy.py").write_text(COPY_OF_A_FULL_PIPE)
    (home / "first.py").write_text("import sys\nprint('first:', sys.stdin.readline(), end='')\n")
    seat.line("cat big.txt | python3 copy.py")
    seat.wait_prompt()
    assert (home / "copy.txt").read_text() == text
    seat.line("cat big.txt | python3 first.py")
    assert "first: line 0" in seat.wait_prompt()


def test_what_is_typed_around_a_programs_end_arrives_in_its_order(seat: Any) -> None:
    """Some keys reach the program, some nobody, some the shell: together they are the lines that were typed."""
    (seat.desk.home / "short.py").write_text(SHORT)
    seat.line("python3 short.py")
    seat.wait(lambda text: "ready" in text)
    numbers: list[str] = []
    after = 0
    deadline = Deadline()
    while after < 100 and not deadline.is_over():
        if len(numbers) == 100:
            (seat.desk.home / "go").touch()
        numbers.append(str(len(numbers)))
        seat.terminal.send(f"echo {numbers[-1]} >> numbers\r")
        seat.desk.scheduler.run(lambda: False, 0.001)
        after += len(numbers) > 100 and not running_processes(seat.desk.scheduler)
    assert after == 100
    seat.terminal.send("echo all of ''them\r")
    seat.wait(lambda text: "all of them" in text)
    assert (seat.desk.home / "numbers").read_text().split() == numbers


def test_a_program_that_reads_ctrl_z_itself_gets_it_as_a_key(seat: Any) -> None:
    (seat.desk.home / "a.py").write_text(
        "import os, tty\ntty.setraw(0)\nprint('ready', flush=True)\nprint(repr(os.read(0, 9)), end='\\r\\n')\n",
        encoding="utf-8",
    )
    seat.line("python3 a.py")
    seat.wait(lambda text: "ready" in text)
    seat.type("a\x1ab\x03")
    seat.wait(lambda text: "\\x" in text)
    assert "b'a\\x1ab\\x03'" in seat.wait_prompt()
    assert not seat.terminal.is_stubborn and "Stopped" not in seat.look()


def test_a_kernel_that_is_slow_to_echo_ctrl_c_is_waited_for(seat: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """Asking for output waits for the thread on which Linux handles keys; it echoes nothing once ECHO is off."""
    import termios

    echoes = []

    def asked(fd: int, seconds: float | None) -> bool:
        echoes.append(bool(termios.tcgetattr(fd)[3] & termios.ECHO))
        return has_output(fd, seconds)

    monkeypatch.setattr(process, "has_output", asked)
    seat.line("yes | cat -n")
    seat.wait(lambda text: "2  y" in text)
    seat.terminal.send("\x03")
    seat.wait(lambda text: "^C" in text and text.rstrip().endswith("$"))
    assert echoes == [True]
