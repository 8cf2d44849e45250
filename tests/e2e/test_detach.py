"""A desktop that outlives its terminal: what is left goes on, and comes back in any other terminal."""

from __future__ import annotations

import contextlib
import json
import os
import re
import signal
import socket
import stat
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from tests.support.waiting import until

if TYPE_CHECKING:
    from tests.e2e.place import Place
    from tests.e2e.terminal import Terminal

pytestmark = pytest.mark.person

termios = pytest.importorskip("termios", reason="this system has no pseudo-terminals to try the screen in")

ON_AND_OFF = (
    (b"\x1b[?1049h", b"\x1b[?1049l"),
    (b"\x1b[?25l", b"\x1b[?25h"),
    (b"\x1b[?1000h", b"\x1b[?1000l"),
    (b"\x1b[?1003h", b"\x1b[?1003l"),
    (b"\x1b[?2004h", b"\x1b[?2004l"),
    (b"\x1b[?7l", b"\x1b[?7h"),
)
PROMPT = "student@day6:~$"
COUNTS = """\
import time
with open("counted.txt", "w") as file:
    for n in range(10**9):
        print("count", n, flush=True)
        print(n, file=file, flush=True)
        time.sleep(0.01)
"""

NOISE = COUNTS.replace("import time", "import random").replace(
    "time.sleep(0.01)", "print(*(f'\\x1b[3{random.randrange(8)}m{random.random()}' for _ in range(99)))"
)
"""Every picture of it differs from the one before in every cell."""


def attach(place: Place, columns: int = 80, rows: int = 24, lang: str = "en", **env: str | None) -> Terminal:
    words = ["attach", "--home", str(place.home), "--lang", lang]
    return place.terminal(*words, columns=columns, rows=rows, **env)


def detach(screen: Terminal) -> None:
    """Leave by the palette, in any language, and wait for the end of the client."""
    screen.press("F7")
    screen.wait("Alt+-")
    screen.send("Detach")
    screen.wait(lambda seen: "Detach" in seen and "Alt+-" not in seen)
    screen.press("Enter")
    assert screen.wait_end() == 0


def expect_given_back(screen: Terminal, before: list[object]) -> None:
    output = bytes(screen.output)
    for on, off in ON_AND_OFF:
        assert output.rfind(on) < output.rfind(off), (on, off)
    assert b"Traceback" not in output
    assert screen.attributes() == before


def processes_of(place: Place, module: str) -> list[int]:
    return [pid for pid, words in place.processes().items() if f"day6_tui.{module}" in words]


def sockets(place: Place) -> list[Path]:
    return [path for path in place.runtime.glob("desktop-*") if stat.S_ISSOCK(path.lstat().st_mode)]


def end_all(place: Place) -> None:
    """End the desktop as its user would, and see that nothing is left."""
    with attach(place) as screen:
        screen.wait("F1")
        screen.quit()
        screen.wait_end()
    expect_nothing_left(place)


def expect_nothing_left(place: Place) -> None:
    until(lambda: place.processes() == {}, told=place.processes)
    assert sockets(place) == []


def test_what_is_left_by_the_palette_comes_back_in_another_size(place: Place) -> None:
    with place.desktop("--detach", "--scene", "empty") as screen:
        before = screen.attributes()
        screen.wait(PROMPT)
        screen.line("echo one $((1 + 1)) three")
        screen.wait("one 2 three")
        detach(screen)
        assert f"[detached: day6-tui attach --home {place.home} comes back]"[:60] in screen.look()
        expect_given_back(screen, before)
    with attach(place, 120, 40) as screen:
        screen.wait("one 2 three", PROMPT, "┓╭")  # side by side, as at this size: the terminal has its new one
        screen.line("python3 -c 'import os; print(*os.get_terminal_size())'")
        screen.wait_lines("58 36")
        screen.resize(100, 30)
        screen.wait("F2 Terminal F3")
        screen.line("python3 -c 'import os; print(*os.get_terminal_size())'")
        screen.wait_lines("48 26", PROMPT)
        screen.press("Ctrl-Q")
        assert screen.wait_end() == 0
    expect_nothing_left(place)


def pose(place: Place) -> tuple[float, ...]:
    """Of the turtle: x, y, theta, and both velocities; () if the command did not find it in its time."""
    said = place.run("ros2", "topic", "echo", "--once", "/turtle1/pose").stdout
    return tuple(float(number) for number in re.findall(r"^(?:x|y|theta|\w+_velocity): (\S+)", said, re.M))


def test_the_turtle_stands_where_it_was_left(place: Place) -> None:
    with place.desktop("--detach", "--scene", "turtle") as screen:
        screen.wait("Use arrow keys")
        screen.press("Up")
        until(lambda: pose(place)[:1] > (7.4,))
        screen.press("Left")
        there = until(lambda: (now := pose(place))[2:3] > (1.9,) and now[3:] == (0.0, 0.0) and now)
        screen.press("Ctrl-Q")
        screen.wait("D Detach")
        screen.send("d")
        assert screen.wait_end() == 0
    until(lambda: pose(place) == there)
    with attach(place, 120, 40) as screen:
        screen.wait("Use arrow keys", f"x {there[0]:.2f}"[:3])
        screen.press("Up")
        until(lambda: pose(place)[:2] not in ((), there[:2]))
        screen.quit()
        assert screen.wait_end() == 0
    expect_nothing_left(place)


@pytest.mark.parametrize("how", ["kill", "hang_up", "terminate"])
def test_a_terminal_that_is_lost_loses_nothing(place: Place, how: str) -> None:
    place.home_file("counts.py", COUNTS)
    with place.desktop("--detach", "--scene", "empty") as screen:
        before = screen.attributes()
        screen.wait(PROMPT)
        screen.line("python3 counts.py")
        until(lambda: (place.home / "counted.txt").exists() and (place.home / "counted.txt").stat().st_size > 0)
        if how == "kill":
            screen.kill()
            assert screen.wait_end() == -signal.SIGKILL
        elif how == "terminate":
            screen.kill(signal.SIGTERM)
            assert screen.wait_end() == 128 + signal.SIGTERM
            expect_given_back(screen, before)
        else:
            screen.hang_up()
            until(lambda: screen._reap() or screen.status is not None)
    size = (place.home / "counted.txt").stat().st_size
    until(lambda: (place.home / "counted.txt").stat().st_size > size)
    with attach(place) as screen:
        screen.wait("counts.py")
        screen.press("Ctrl-C")
        screen.wait("KeyboardInterrupt")
        screen.quit()
        assert screen.wait_end() == 0
    expect_nothing_left(place)


def test_who_attaches_takes_the_desktop_over(place: Place) -> None:
    with place.desktop("--detach", "--scene", "empty") as first:
        before = first.attributes()
        first.wait(PROMPT)
        first.line("echo $((40 + 2))")
        first.wait_lines("42")
        with attach(place, 100, 30) as second:
            second.wait_lines("42")
            assert first.wait_end() == 0
            assert "another terminal was attached" in first.look().replace("\n", "")
            expect_given_back(first, before)
            second.line("echo $((50 + 3))")
            second.wait_lines("53")
            second.press("Ctrl-Q")
            assert second.wait_end() == 0
    expect_nothing_left(place)


def test_attach_without_a_desktop_says_so(place: Place) -> None:
    with attach(place) as screen:
        assert screen.wait_end() == 1
        assert "day6-tui: no desktop runs that was started by" in screen.look()
    with attach(place, lang="zh") as screen:
        assert screen.wait_end() == 1
        assert "没有用 day6-tui --detach" in screen.look().replace("\n", "")


def test_a_second_desktop_for_the_same_home_is_not_started(place: Place) -> None:
    done = place.run("--detach", "--home", str(place.home), "--lang", "en")
    assert done.returncode == 0, done
    assert done.stdout == f"day6-tui: the desktop runs: day6-tui attach --home {place.home} comes to it\n"
    with place.desktop("--detach") as screen:
        assert screen.wait_end() == 1
        assert "the desktop runs already: day6-tui attach" in screen.look()
    again = place.run("--detach", "--home", f"{place.work}/../home/", "--lang", "en")
    assert (again.returncode, again.stdout) == (1, "")
    assert len(processes_of(place, "main")) == 1
    end_all(place)


def test_a_desktop_that_cannot_start_says_why(place: Place) -> None:
    place.home.mkdir()
    place.home_file("ros2_ws", "a file")
    done = place.run("--detach", "--home", str(place.home), "--lang", "en")
    assert (done.returncode, done.stdout) == (1, "")
    assert str(place.home) in done.stderr.replace("\n", "")
    assert "\x1b" not in done.stderr
    with place.desktop("--detach") as screen:
        assert screen.wait_end() == 1
        assert str(place.home)[:40] in screen.look()
    expect_nothing_left(place)


def test_what_a_killed_keeper_left_is_no_obstacle(place: Place) -> None:
    with place.desktop("--detach", "--scene", "empty") as screen:
        before = screen.attributes()
        screen.wait(PROMPT)
        (keeper,) = processes_of(place, "detached.keeper")
        os.kill(keeper, signal.SIGKILL)
        assert screen.wait_end() == 1
        assert "keeper has ended" in screen.look()
        expect_given_back(screen, before)
    until(lambda: place.processes() == {}, told=place.processes)
    assert len(sockets(place)) == 1
    with attach(place) as screen:
        assert screen.wait_end() == 1
    with place.desktop("--detach", "--scene", "empty") as screen:
        screen.wait(PROMPT)
        screen.press("Ctrl-Q")
        assert screen.wait_end() == 0
    expect_nothing_left(place)


def test_a_file_with_the_name_of_the_socket_is_told_and_kept(place: Place) -> None:
    done = place.run("--detach", "--home", str(place.home))
    (path,) = sockets(place)
    end_all(place)
    path.write_text("mine", encoding="utf-8")
    done = place.run("--detach", "--home", str(place.home), "--lang", "en")
    assert done.returncode == 1
    assert "Address already in use" in done.stderr
    assert path.read_text(encoding="utf-8") == "mine"


def test_nobody_else_can_reach_the_desktop(place: Place) -> None:
    place.run("--detach", "--home", str(place.home))
    (path,) = sockets(place)
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
    assert stat.S_IMODE(path.parent.stat().st_mode) == 0o700
    assert path.parent.stat().st_uid == os.geteuid()
    end_all(place)


NONSENSE = (
    b"",
    b"GET / HTTP/1.0\r\n\r\n",
    b"h\xff\xff\xff\xff",
    b"h\x00\x00\x00\x02{}",
    b"h\x00\x00\x00\x02[]",
    b"h\x00\x00\x00\x40" + json.dumps({"size": [99999] * 4, "environ": {}}).encode().ljust(64),
    b"h\x00\x00\x00\x40" + json.dumps({"size": None, "environ": {}}).encode().ljust(64),
    b"i\x00\x00\x00\x01\x11",
)


def test_nonsense_on_the_socket_changes_nothing(place: Place) -> None:
    with place.desktop("--detach", "--scene", "empty") as screen:
        screen.wait(PROMPT)
        (path,) = sockets(place)
        for said in NONSENSE:
            with socket.socket(socket.AF_UNIX) as stranger:
                stranger.connect(str(path))
                stranger.sendall(said)
                stranger.shutdown(socket.SHUT_WR)
                assert stranger.recv(100) == b"", said
        screen.line("echo $((40 + 2))")
        screen.wait_lines("42")
        screen.press("Ctrl-Q")
        assert screen.wait_end() == 0
    expect_nothing_left(place)


@pytest.mark.skipif(not Path("/proc/self/io").exists(), reason="this system does not tell what a process writes")
def test_programs_go_on_and_nothing_is_drawn_while_nobody_looks(place: Place) -> None:
    place.home_file("counts.py", COUNTS)
    with place.desktop("--detach", "--scene", "empty") as screen:
        screen.wait(PROMPT)
        screen.line("python3 counts.py")
        screen.wait("count 1")
        detach(screen)
    (keeper,) = processes_of(place, "detached.keeper")
    counted = place.home / "counted.txt"
    size, read = counted.stat().st_size, Path(f"/proc/{keeper}/io").read_text(encoding="utf-8")
    until(lambda: counted.stat().st_size > size + 500)
    assert Path(f"/proc/{keeper}/io").read_text(encoding="utf-8") == read  # so nothing was written to its terminal
    end_all(place)


def test_the_exit_status_of_the_desktop_is_that_of_the_client(place: Place) -> None:
    with place.desktop("--detach", "--scene", "empty") as screen:
        before = screen.attributes()
        screen.wait(PROMPT)
        (desktop,) = processes_of(place, "main")
        os.kill(desktop, signal.SIGTERM)
        assert screen.wait_end() == 128 + signal.SIGTERM
        expect_given_back(screen, before)
    expect_nothing_left(place)


def test_ending_the_keeper_ends_the_desktop_in_order(place: Place) -> None:
    place.run("--detach", "--home", str(place.home))
    (keeper,) = processes_of(place, "detached.keeper")
    os.kill(keeper, signal.SIGTERM)
    expect_nothing_left(place)


def test_a_desktop_is_not_shown_in_its_own_terminal(place: Place) -> None:
    with place.desktop("--detach", "--scene", "empty") as screen:
        screen.wait(PROMPT)
        screen.line(f"day6-tui attach --home {place.home}")
        screen.wait("this is a terminal of that desktop")
        screen.quit()
        assert screen.wait_end() == 0
    expect_nothing_left(place)


def test_a_desktop_without_a_keeper_offers_no_detaching(place: Place) -> None:
    place.home_file("counts.py", COUNTS)
    with place.desktop("--scene", "empty") as screen:
        screen.wait(PROMPT)
        screen.line("python3 counts.py")
        screen.wait("count 1")
        screen.press("Ctrl-Q")
        assert "Detach" not in screen.wait("still running")
        screen.press("Esc")
        screen.wait_gone("still running")
        screen.press("F7")
        screen.wait("Alt+-")
        screen.send("Detach")
        screen.wait(lambda seen: "Detach" in seen and "Alt+-" not in seen)
        assert "▸" not in screen.look().split("Detach", 1)[1]  # no entry
        screen.press("Esc")
        screen.quit()
        assert screen.wait_end() == 0


COLOURS = re.compile(rb"\x1b\[(?:[0-9;]*;)?(?:3[0-8]|4[0-8]|9[0-7]|10[0-7])(?:;[0-9;]*)?m")


def test_no_terminal_gets_what_it_cannot_show(place: Place) -> None:
    with place.desktop("--detach", "--scene", "turtle", lang="zh") as screen:
        screen.wait("Use arrow keys", "帮助", "┏")
        assert b"[38;2;" in screen.output
        detach(screen)
    plain: dict[str, str | None] = {"COLORTERM": None, "NO_COLOR": None}
    with attach(place, LC_ALL="C", TERM="vt100", **plain) as screen:
        screen.wait("Use arrow keys", "Help", "#")
        detach(screen)
        assert bytes(screen.output).isascii()
        assert b"8;2;" not in screen.output and b"8;5;" not in screen.output
    with attach(place, TERM="linux", LC_ALL="C.UTF-8", **plain) as screen:
        screen.wait("Use arrow keys", "Help", "╔")
        detach(screen)
        assert b"8;2;" not in screen.output and b"8;5;" not in screen.output
        assert not re.search("[一-鿿▀▄]", screen.output.decode())
    with attach(place, LC_ALL="zh_CN.UTF-8", **plain) as screen:  # TERM=xterm-256color
        screen.wait("Use arrow keys", "帮助", "┏")
        detach(screen)
        assert b"8;2;" not in screen.output and b"8;5;" in screen.output
    with attach(place, LC_ALL="zh_CN.UTF-8", NO_COLOR="1") as screen:
        screen.wait("Use arrow keys", "帮助", "┏")
        detach(screen)
        assert COLOURS.search(screen.output) is None
    with attach(place) as screen:
        screen.wait("Use arrow keys", "帮助", "┏")
        assert b"[38;2;" in screen.output
        screen.quit()
        assert screen.wait_end() == 0
    expect_nothing_left(place)


def test_a_client_that_is_stopped_gives_the_terminal_back_and_goes_on_later(place: Place) -> None:
    with place.desktop("--detach", "--scene", "empty") as screen:
        before = screen.attributes()
        screen.wait(PROMPT)
        screen.kill(signal.SIGTSTP)
        screen.wait(lambda _: screen.output.count(b"\x1b[?1049l") == 1)
        until(lambda: screen.look(0.02) is not None and screen.attributes() == before)
        until(lambda: "(stopped)" in Path(f"/proc/{screen.pid}/status").read_text(encoding="utf-8"))
        screen.kill(signal.SIGCONT)
        screen.wait(lambda _: screen.output.count(b"\x1b[?1049h") == 2)
        screen.wait(PROMPT)
        screen.line("echo $((40 + 2))")
        screen.wait_lines("42")
        screen.press("Ctrl-Q")
        assert screen.wait_end() == 0
        expect_given_back(screen, before)
    expect_nothing_left(place)


def test_a_terminal_that_takes_nothing_holds_neither_programs_nor_the_next_terminal(place: Place) -> None:
    place.home_file("counts.py", NOISE)
    counted = place.home / "counted.txt"
    with place.desktop("--detach", "--scene", "empty", columns=120, rows=40) as stuck:
        stuck.wait(PROMPT)
        stuck.line("python3 counts.py")
        stuck.wait("count")
        until(counted.exists)
        for _ in range(3):  # nothing is read from its terminal any more
            size = counted.stat().st_size
            until(lambda size=size: counted.stat().st_size > size + 1000)  # type: ignore[misc]
        with attach(place) as screen:
            screen.wait("count")
            screen.press("Ctrl-C")
            screen.wait("KeyboardInterrupt")
            assert stuck.wait_end() == 0
            screen.quit()
            assert screen.wait_end() == 0
    expect_nothing_left(place)


def has_terminal(pid: int) -> bool:
    """Whether the desktop reads its terminal key by key."""
    terminal = os.open(f"/proc/{pid}/fd/0", os.O_RDWR | os.O_NOCTTY)
    try:
        return not termios.tcgetattr(terminal)[3] & termios.ICANON
    finally:
        os.close(terminal)


def threads(pid: int) -> int:
    return len(os.listdir(f"/proc/{pid}/task"))


@pytest.mark.skipif(sys.platform != "linux", reason="the desktop is looked at in /proc")
def test_a_terminal_that_takes_nothing_is_left_and_drawn_anew_once_it_does(place: Place) -> None:
    place.home_file("counts.py", NOISE)
    with place.desktop("--detach", "--scene", "empty", columns=120, rows=40) as screen:
        screen.wait(PROMPT)
        (desktop,) = processes_of(place, "main")
        screen.line("python3 counts.py")
        screen.wait("count")
        assert has_terminal(desktop)
        until(lambda: not has_terminal(desktop))  # nothing is read from its terminal meanwhile
        screen.wait(lambda _: screen.output.count(b"\x1b[?1049h") == 2, "count")
        screen.press("Ctrl-C")
        screen.wait("KeyboardInterrupt")
        screen.quit()
        assert screen.wait_end() == 0
    expect_nothing_left(place)


@pytest.mark.skipif(sys.platform != "linux", reason="the desktop is looked at in /proc")
def test_a_desktop_that_is_stopped_while_nobody_looks_takes_its_terminal_once(place: Place) -> None:
    # Without the link, whose threads begin whenever the machine comes to it.
    with place.desktop("--detach", "--scene", "empty", DAY6_LINK="off") as screen:
        screen.wait(PROMPT)
        (desktop,) = processes_of(place, "main")
        screen.look(1.0)
        usual = min(threads(desktop) for _ in range(20))
        detach(screen)
    until(lambda: not has_terminal(desktop))
    os.kill(desktop, signal.SIGSTOP)
    os.kill(desktop, signal.SIGCONT)
    with attach(place) as screen:
        screen.wait(PROMPT)
        until(lambda: threads(desktop) <= usual)  # there is one that reads keys
        screen.line("echo $((40 + 2))")
        screen.wait_lines("42")
        screen.press("Ctrl-Q")
        assert screen.wait_end() == 0
    expect_nothing_left(place)


def test_what_is_typed_ahead_reaches_the_desktop_and_ctrl_c_does_not_end_it(place: Place) -> None:
    assert place.run("--detach", "--home", str(place.home), "--scene", "empty").returncode == 0
    with attach(place) as screen:
        screen.wait(lambda _: b"\x1b[?1049h" in screen.output)
        screen.line("\x03echo $((40 + 2))")
        screen.wait_lines("42")
        screen.send("\x1b[O")  # another window gets the keyboard
        screen.look(0.3)
        screen.kill()
        screen.wait_end()
    with attach(place) as screen:
        screen.wait(PROMPT)
        screen.line("echo $((50 + 3))")
        screen.wait_lines("53")
        screen.press("Ctrl-Q")
        assert screen.wait_end() == 0
    expect_nothing_left(place)


TERMINATED = """
import os, signal, socket, sys
from day6_tui.detached import view, wire

ours, theirs = socket.socketpair()
keeper, write = wire.Connection(theirs), os.write
keeper.send(wire.OUTPUT, b"\\x1b[?1049h" + b"." * 500 + b"\\x1b_Ga=t,f=24,i=7,s=1,v=1;AAAA\\x1b\\\\")

def write_and_be_terminated(descriptor, data):
    count = write(descriptor, data)
    if b"_Ga=t" in data:
        os.write = write
        os.kill(os.getpid(), signal.SIGTERM)
    return count

os.write = write_and_be_terminated
sys.exit(view.show(wire.Connection(ours), lambda key, **words: key, "day6-tui attach"))
"""


def test_a_picture_leaves_the_terminal_though_the_signal_comes_just_as_it_was_sent() -> None:
    ours, theirs = os.openpty()
    client = subprocess.Popen([sys.executable, "-c", TERMINATED], stdin=theirs, stdout=theirs, stderr=theirs)
    os.close(theirs)
    written = b""
    until(lambda: client.poll() is not None)
    with contextlib.suppress(OSError):  # nobody has it open any more
        while data := os.read(ours, 65536):
            written += data
    os.close(ours)
    assert client.returncode == 128 + signal.SIGTERM
    assert b"\x1b_Ga=d,d=I,i=7,q=2\x1b\\" in written and written.index(b"a=d") > written.find(b"a=t")


@pytest.mark.parametrize("how", ["leave", "terminate"])
def test_pictures_do_not_stay_in_a_terminal_and_are_drawn_in_the_next_one(place: Place, how: str) -> None:
    from tests.e2e.test_pixels import COLUMNS, ROWS, Window

    with place.desktop("--detach", "--scene", "turtle", columns=COLUMNS, rows=ROWS) as screen:
        window = Window(screen, "kitty")
        window.until(lambda: window.ground() > 400)
        if how == "leave":
            screen.press("Ctrl-Q")
            window.until(lambda: "D Detach" in screen.look())
            screen.send("d")
        else:
            window.terminal.may_break = True
            screen.kill(signal.SIGTERM)
        window.until(lambda: screen.status is not None)
        window.until(lambda: not window.terminal.images and not window.terminal.placements)
    with attach(place, COLUMNS, ROWS) as screen:
        window = Window(screen, "sixel")
        window.until(lambda: window.ground() > 400)
        screen.kill(signal.SIGTERM)
        window.until(lambda: screen.status is not None)
    with attach(place, COLUMNS, ROWS) as screen:
        window = Window(screen, "plain")
        window.until(lambda: "TurtleSim" in screen.look() and "/turtlesim" in screen.look())
        screen.press("F7")
        window.until(lambda: "Alt+-" in screen.look())  # so everything has been drawn once more
        assert window.terminal.pictures == 0
        screen.press("Esc")
        screen.wait_gone("Alt+-")
        screen.quit()
        assert screen.wait_end() == 0
    expect_nothing_left(place)


@pytest.mark.parametrize("module", ["keeper", "client", "view", "meeting"])
def test_neither_keeper_nor_client_load_the_screen(module: str) -> None:
    code = f"import sys, day6_tui.detached.{module}; print(*sorted(sys.modules))"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert not {"textual", "rich", "asyncio", "numpy", "zenoh", "yaml"} & set(loaded)
    assert len([name for name in loaded if name.startswith("day6_tui")]) < 20


def test_the_help_speaks_of_it_in_both_languages(place: Place) -> None:
    assert "--detach" in place.run("--help", "--lang", "en").stdout
    assert "终端关了" in place.run("--help", "--lang", "zh").stdout
    assert "attach  " in place.run("--help", "--lang", "en").stdout
    assert "[--home DIR]" in place.run("attach", "--help", "--lang", "en").stdout
    assert "usage: day6-tui attach" in place.run("attach", "--help", "--lang", "en").stdout
    assert "用法：day6-tui attach" in place.run("attach", "--help", "--lang", "zh").stdout
    done = place.run("attach", "--lang", "en")
    assert (done.returncode, done.stderr) == (2, "day6-tui: attach needs a terminal\n")


def test_what_was_typed_just_before_the_terminal_went_is_kept(place: Place) -> None:
    data = place.work / "data"
    with place.desktop("--detach", "--scene", "empty", XDG_DATA_HOME=str(data)) as screen:
        screen.wait(PROMPT)
        screen.line("nano work.txt")
        screen.wait("work.txt", "^X")
        screen.send("all my work")
        screen.wait("all my work")
        screen.kill()  # sooner than the copy that is made every second
        screen.wait_end()
    until(lambda: any("all my work" in path.read_text() for path in data.rglob("*.json")))
    with attach(place) as screen:
        screen.wait("all my work")
        screen.press("F2")  # in the editor ^Q would close the file
        screen.quit()
        screen.wait_end()
    expect_nothing_left(place)
