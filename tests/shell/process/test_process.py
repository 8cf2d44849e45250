"""A student's program as a process of its own: in a terminal, in a pipeline, in the background, and how it ends."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import threading
from pathlib import Path
from typing import Any

import pytest

from day6_core.shell.process import process
from day6_core.shell.process.output_copy import OutputCopy
from day6_core.shell.process.process import running_processes
from day6_core.shell.screen.rows import row_text
from tests.support.waiting import PATIENCE, until

PROMPT = "student@day6:~$"
posix = pytest.mark.skipif(os.name != "posix", reason="needs ptys and process groups")


def write(home: Path, name: str, text: str) -> None:
    (home / name).write_text(text, encoding="utf-8")


def gone(pid: int) -> bool:
    """Whether a process has ended (a zombie nobody has collected yet has ended too)."""
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return True
    status = Path(f"/proc/{pid}/stat")
    return status.exists() and status.read_text(encoding="utf-8").rpartition(")")[2].split()[0] == "Z"


@pytest.mark.process
def test_arguments_output_and_status_are_the_programs_own(machine: Any) -> None:
    write(machine.desk.home, "a.py", "import sys\nprint(sys.argv)\nprint('e', file=sys.stderr)\nsys.exit(3)\n")
    assert machine.run("python3 a.py 1 'b c'") == (3, "['a.py', '1', 'b c']\n", "e\n")


@pytest.mark.process
def test_a_missing_file_is_answered_by_python_itself(machine: Any) -> None:
    result = machine.run("python3 nowhere.py")
    assert result.status == 2
    assert "can't open file" in result.err
    assert "No such file or directory" in result.err


@pytest.mark.process
def test_the_traceback_is_pythons_own(machine: Any) -> None:
    write(machine.desk.home, "a.py", "def f():\n    return 1 / 0\n\nf()\n")
    result = machine.run("python3 a.py")
    assert result.status == 1
    lines = result.err.splitlines()
    assert lines[0] == "Traceback (most recent call last):"
    assert lines[-1] == "ZeroDivisionError: division by zero"
    assert not [line for line in lines if "day6_tui" in line]


@pytest.mark.process
def test_our_packages_are_on_its_path_and_the_environment_is_the_terminals(machine: Any) -> None:
    write(
        machine.desk.home,
        "a.py",
        "import os, rclpy\nprint(os.environ['COLOUR'], os.environ['ROS_DISTRO'], os.getcwd())\n",
    )
    result = machine.run("export COLOUR=red; python3 a.py")
    assert result.out == f"red jazzy {machine.desk.home}\n", result.err


@pytest.mark.process
def test_it_takes_part_in_pipelines_and_redirections(machine: Any) -> None:
    write(machine.desk.home, "up.py", "import sys\nfor line in sys.stdin: print(line.upper(), end='')\n")
    write(machine.desk.home, "count.py", "for i in range(20): print('line', i)\n")
    assert machine.run("echo abc | python3 up.py | cat").out == "ABC\n"
    assert machine.run("python3 count.py | grep 1 | wc -l").out == "11\n"
    assert machine.run("python3 count.py > f; python3 up.py < f | tail -1").out == "LINE 19\n"
    assert machine.run("python3 up.py <<< word").out == "WORD\n"


@pytest.mark.process
def test_a_reader_that_stops_early_ends_the_writer(machine: Any) -> None:
    write(machine.desk.home, "yes.py", "while True: print('y')\n")
    result = machine.run("python3 yes.py | head -2")
    assert result.out == "y\ny\n"
    assert until(lambda: not running_processes(machine.desk.scheduler))


@pytest.mark.process
def test_a_reader_that_takes_its_time_gets_everything_though_the_writer_has_long_ended(machine: Any) -> None:
    # More than waits in a pipe of ours, and the rest of it fits into one of the system.
    write(machine.desk.home, "many.py", "open('begun', 'w')\nfor n in range(5400): print('x' * 59)\n")
    program = machine.start("python3 many.py | { sleep 9; wc -l; }")
    begun = machine.desk.home / "begun"
    machine.wait(lambda: begun.exists() and not running_processes(machine.desk.scheduler))
    machine.go(9.0)
    machine.wait(lambda: program.status is not None)
    assert machine.out.text == "5400\n"


@pytest.mark.process
@posix
def test_a_reader_that_never_reads_is_waited_for_until_ctrl_c(machine: Any) -> None:
    write(machine.desk.home, "many.py", "open('begun', 'w')\nfor n in range(5400): print('x' * 59)\n")
    program = machine.start("python3 many.py | sleep 9999")
    begun = machine.desk.home / "begun"
    machine.wait(lambda: begun.exists() and not running_processes(machine.desk.scheduler))
    program.interrupt()
    machine.wait(lambda: program.status is not None)
    assert program.status == 130


@pytest.mark.process
@posix
def test_a_terminal_shows_the_end_of_the_output_though_it_is_read_late(
    seat: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    read, is_behind, over = process.read_waiting, OutputCopy.is_behind, threading.Event()

    def read_late(fd: int) -> bytes:
        assert over.wait(PATIENCE)
        return read(fd)

    def is_behind_now(copy: OutputCopy) -> bool:
        over.set()  # it has ended, and nothing that it left running is waited for any more
        return is_behind(copy)

    monkeypatch.setattr(process, "read_waiting", read_late)
    monkeypatch.setattr(OutputCopy, "is_behind", is_behind_now)
    write(seat.desk.home, "a.py", "print('the last words')\n")
    seat.line("python3 a.py")
    assert seat.wait_prompt().splitlines()[1] == "the last words"


@pytest.mark.process
@posix
@pytest.mark.parametrize(
    ("number", "status", "word"),
    [(11, 139, "Segmentation fault"), (15, 143, "Terminated"), (9, 137, "Killed"), (6, 134, "Aborted")],
)
def test_death_by_a_signal_is_told_as_bash_does(machine: Any, number: int, status: int, word: str) -> None:
    result = machine.run(f"python3 -c 'import os; os.kill(os.getpid(), {number})'; echo $?")
    assert result.out == f"{status}\n"
    assert result.err == f"{word}\n"


@pytest.mark.process
@posix
def test_in_a_terminal_it_has_a_controlling_terminal_of_the_windows_size(seat: Any) -> None:
    write(
        seat.desk.home,
        "a.py",
        "import os, sys\nprint(sys.stdin.isatty(), sys.stdout.isatty(), os.get_terminal_size())\n"
        "print(os.tcgetpgrp(0) == os.getpgrp(), os.ttyname(0) == os.ttyname(2), os.nice(0) >= 10)\n"
        "open('/dev/tty').close()\n",
    )
    seat.line("python3 a.py")
    assert seat.wait_prompt().splitlines()[1:-1] == [
        "True True os.terminal_size(columns=80, lines=24)",
        "True True True",
    ]


@pytest.mark.process
@posix
def test_it_prints_as_it_goes_and_reads_what_is_typed(seat: Any) -> None:
    write(seat.desk.home, "a.py", "name = input('name? ')\nprint('hello', name)\ninput()\n")
    seat.line("python3 a.py")
    seat.wait(lambda text: text.endswith("name?"))
    seat.type("你好\r")
    assert seat.wait(lambda text: "hello" in text).splitlines()[-2:] == ["name? 你好", "hello 你好"]
    seat.type("\r")
    seat.wait_prompt()


@pytest.mark.process
@posix
def test_ctrl_c_is_the_kernels_and_the_traceback_pythons(seat: Any) -> None:
    write(seat.desk.home, "a.py", "import time\nprint('ready')\nwhile True:\n    time.sleep(0.01)\n")
    seat.line("python3 a.py")
    seat.wait(lambda text: "ready" in text)
    seat.type("\x03")
    lines = seat.wait_prompt().splitlines()
    assert lines[2] == "^CTraceback (most recent call last):"
    assert "KeyboardInterrupt" in lines
    assert seat.line("echo $?").splitlines()[-2] == "130"


PRINTS_AND_NOTES_WHEN_IT_CANNOT = """\
import itertools, os, select, time
os.set_blocking(1, False)
for n in itertools.count():
    while True:
        try:
            os.write(1, f'line {n}\\n'.encode())
            break
        except BlockingIOError:
            if os.path.exists('pressed') and not os.path.exists('stopped'):
                open('stopped', 'w').write(f'{n}.')
            select.select([], [1], [], 0.01)
    time.sleep(0.001)
"""


@pytest.mark.process
@posix
def test_any_key_goes_on_after_ctrl_s(seat: Any) -> None:
    write(seat.desk.home, "a.py", PRINTS_AND_NOTES_WHEN_IT_CANNOT)
    seat.line("python3 a.py")
    seat.wait(lambda text: "line 3" in text)
    seat.type("\x13")
    (seat.desk.home / "pressed").touch()
    stopped = seat.desk.home / "stopped"
    seat.wait(lambda _: stopped.exists() and stopped.read_text().endswith("."))
    seat.type("a")
    after = int(stopped.read_text()[:-1])
    seat.wait(lambda text: max(map(int, re.findall(r"line (\d+)", text))) > after)
    seat.type("\x03")
    seat.wait_prompt()


@pytest.mark.process
@posix
def test_ctrl_backslash_ends_a_program_that_ignores_ctrl_c_and_leaves_no_core_file(seat: Any) -> None:
    deaf = "import signal, time\nsignal.signal(2, signal.SIG_IGN)\nprint('deaf')\nwhile True: time.sleep(9)\n"
    write(seat.desk.home, "deaf.py", deaf)
    seat.line("python3 deaf.py; echo status $?")
    seat.wait(lambda text: "\ndeaf" in text)
    for presses in (1, 2, 3):
        assert not seat.terminal.is_stubborn
        seat.type("\x03")
        seat.wait(lambda text, presses=presses: text.count("^C") == presses)
    assert seat.terminal.is_stubborn
    seat.desk.pause()  # what stands still can't hear
    assert not seat.terminal.is_stubborn
    seat.desk.resume()
    seat.type("\x1c")
    assert seat.wait_prompt().splitlines()[-3:-1] == ["^C^C^C^\\Quit", "status 131"]
    assert not seat.terminal.is_stubborn
    assert [path.name for path in seat.desk.home.iterdir() if "core" in path.name] == []


@pytest.mark.process
@posix
def test_ctrl_z_stops_it_and_fg_lets_it_go_on(seat: Any) -> None:
    write(seat.desk.home, "a.py", "print('ready')\nprint('got', input())\n")
    seat.line("python3 a.py")
    seat.wait(lambda text: "ready" in text)
    seat.type("\x1a")
    assert seat.wait_prompt().splitlines()[-2] == "[1]+  Stopped                 python3 a.py"
    (process,) = running_processes(seat.desk.scheduler)
    stat = Path(f"/proc/{process.pid}/stat")
    if stat.exists():
        assert until(lambda: stat.read_text(encoding="utf-8").rpartition(")")[2].split()[0] == "T")
    seat.line("fg")
    seat.type("x\r")
    assert "got x" in seat.wait_prompt()


@pytest.mark.process
@posix
def test_a_changed_window_reaches_it(seat: Any) -> None:
    write(
        seat.desk.home,
        "a.py",
        # A handler must not print: it may come in the middle of the program's own print.
        "import os, signal\nsignal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGWINCH])\nprint('ready')\n"
        "while True:\n    signal.sigwait([signal.SIGWINCH])\n    print(os.get_terminal_size())\n",
    )
    seat.line("python3 a.py")
    seat.wait(lambda text: "ready" in text)
    seat.terminal.resize(60, 12)
    assert "columns=60, lines=12" in seat.wait(lambda text: "columns=" in text)


@pytest.mark.process
@posix
def test_kill_takes_the_job_or_the_process_number(seat: Any) -> None:
    write(seat.desk.home, "a.py", "import time\nprint('ready')\ntime.sleep(1000)\n")
    seat.line("python3 a.py &")
    seat.wait(lambda text: "ready" in text)
    (process,) = running_processes(seat.desk.scheduler)
    seat.line("kill %1")
    seat.wait(lambda text: not seat.desk.programs.keys() - {seat.terminal.shell.pid})
    assert "[1]+  Terminated              python3 a.py" in seat.line("").splitlines()
    assert until(lambda: gone(process.pid))


@pytest.mark.process
@posix
@pytest.mark.parametrize("stubborn", ["SIGINT", "SIGINT, signal.SIGTERM"])
def test_closing_the_desk_ends_even_a_program_that_does_not_want_to(machine: Any, stubborn: str) -> None:
    write(
        machine.desk.home,
        "a.py",
        f"import signal, time\nfor s in (signal.{stubborn},): signal.signal(s, signal.SIG_IGN)\n"
        "print('ready', flush=True)\nwhile True: time.sleep(1)\n",
    )
    machine.start("python3 a.py")
    machine.wait(lambda: "ready" in machine.out.text)
    (process,) = running_processes(machine.desk.scheduler)
    closing = threading.Thread(target=machine.desk.close, daemon=True)
    closing.start()
    assert until(lambda: not closing.is_alive() and gone(process.pid))
    assert until(lambda: not running_processes(machine.desk.scheduler))


@pytest.mark.process
@posix
def test_what_a_program_started_ends_with_it(machine: Any) -> None:
    write(
        machine.desk.home,
        "a.py",
        "import subprocess, sys\nchild = subprocess.Popen([sys.executable, '-c', 'import time; time.sleep(1000)'])\n"
        "print(child.pid, flush=True)\nchild.wait()\n",
    )
    machine.start("python3 a.py")
    machine.wait(lambda: "\n" in machine.out.text)
    child = int(machine.out.text)
    machine.desk.close()
    assert until(lambda: gone(child))


@pytest.mark.process
@posix
@pytest.mark.parametrize("terminal", [True, False])
def test_no_process_outlives_a_day6_that_was_killed(tmp_path: Path, terminal: bool) -> None:
    write(
        tmp_path,
        "a.py",
        "import os, signal, time\nsignal.signal(signal.SIGHUP, signal.SIG_IGN)\n"
        "open('pid', 'w').write(str(os.getpid()))\nwhile True: time.sleep(1)\n",
    )
    script = tmp_path / "desk.py"
    write(
        tmp_path,
        "desk.py",
        "from pathlib import Path\nfrom day6_core.shell.desk import Desk\nimport threading\n"
        f"desk = Desk(Path({str(tmp_path)!r}), join_link=False)\nterminal = desk.open_terminal(80, 24)\n"
        f"terminal.run_line('python3 a.py' if {terminal} else 'python3 a.py | cat')\n"
        "desk.start()\nthreading.Event().wait()\n",
    )
    ours = subprocess.Popen([sys.executable, str(script)])
    try:
        pid_file = tmp_path / "pid"
        assert until(lambda: pid_file.exists() and pid_file.read_text(encoding="utf-8") != "")
        pid = int(pid_file.read_text(encoding="utf-8"))
        ours.send_signal(signal.SIGKILL)
        ours.wait()
        assert until(lambda: gone(pid))
    finally:
        ours.kill()


@pytest.mark.process
@posix
def test_a_flood_of_output_leaves_the_keys_alive_and_the_memory_bounded(seat: Any) -> None:
    write(seat.desk.home, "a.py", "while True: print('x' * 60)\n")
    seat.line("python3 a.py")
    seat.wait(lambda text: "xxxx" in text)
    seat.type("\x03")
    assert "KeyboardInterrupt" in seat.wait_prompt()
    assert seat.terminal._size < 512 * 1024


@pytest.mark.process
def test_a_pause_of_the_world_stops_it_too(machine: Any) -> None:
    write(machine.desk.home, "a.py", "import time\nprint('ready', flush=True)\ntime.sleep(1000)\n")
    machine.start("python3 a.py")
    machine.wait(lambda: "ready" in machine.out.text)
    (process,) = running_processes(machine.desk.scheduler)
    stat = Path(f"/proc/{process.pid}/stat")
    if not stat.exists():
        pytest.skip("no /proc to look at")
    machine.desk.pause()
    assert until(lambda: stat.read_text(encoding="utf-8").rpartition(")")[2].split()[0] == "T")
    machine.desk.resume()
    assert until(lambda: stat.read_text(encoding="utf-8").rpartition(")")[2].split()[0] == "S")


@pytest.mark.process
def test_a_file_with_a_python_first_line_runs_as_a_command(machine: Any) -> None:
    write(machine.desk.home, "a.py", "#!/usr/bin/env python3\nimport sys\nprint('ran', sys.argv[1:])\n")
    assert machine.run("chmod +x a.py; ./a.py 1 2").out == "ran ['1', '2']\n"
    write(machine.desk.home, "b.sh", "#!/bin/bash\necho script $1\nexit 5\n")
    assert machine.run("chmod +x b.sh; ./b.sh x") == (5, "script x\n", "")


DAEMON = """\
import os, sys, time
for _ in range(3):
    if os.fork() == 0:
        os.setsid()
        if os.fork() == 0:
            open('pids', 'a').write(f'{os.getpid()}\\n')
            time.sleep(1000)
        os._exit(0)
while len(open('pids').readlines() if os.path.exists('pids') else []) < 3:
    time.sleep(0.01)
print('ready', flush=True)
time.sleep(1000)
"""


@pytest.mark.process
@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere nothing tells whose a daemon is")
def test_daemons_of_a_program_end_with_it_though_they_left_its_group(machine: Any) -> None:
    write(machine.desk.home, "a.py", DAEMON)
    program = machine.start("python3 a.py")
    machine.wait(lambda: "ready" in machine.out.text)
    daemons = [int(line) for line in (machine.desk.home / "pids").read_text(encoding="utf-8").split()]
    assert len(daemons) == 3 and not any(gone(pid) for pid in daemons)
    program.interrupt()
    machine.wait(lambda: program.status is not None)
    assert until(lambda: all(gone(pid) for pid in daemons))


@pytest.mark.process
@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere nothing tells whose a daemon is")
def test_daemons_do_not_outlive_a_day6_that_was_killed(tmp_path: Path) -> None:
    write(tmp_path, "a.py", DAEMON)
    write(
        tmp_path,
        "desk.py",
        "from pathlib import Path\nfrom day6_core.shell.desk import Desk\nimport threading\n"
        f"desk = Desk(Path({str(tmp_path)!r}), join_link=False)\n"
        "desk.open_terminal(80, 24).run_line('python3 a.py')\ndesk.start()\nthreading.Event().wait()\n",
    )
    ours = subprocess.Popen([sys.executable, str(tmp_path / "desk.py")])
    pids = tmp_path / "pids"
    try:
        assert until(lambda: pids.exists() and len(pids.read_text(encoding="utf-8").split()) == 3)
    finally:
        ours.kill()
        ours.wait()
    assert until(lambda: all(gone(int(pid)) for pid in pids.read_text(encoding="utf-8").split()))


@pytest.mark.process
@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere data is not limited")
def test_a_program_that_eats_memory_gets_a_memory_error(machine: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DAY6_MEMORY_LIMIT", "300")
    write(machine.desk.home, "a.py", "kept = []\nwhile True:\n    kept.append(bytearray(10_000_000))\n")
    result = machine.run("python3 a.py; echo $?")
    assert result.out == "1\n"
    if sys.version_info < (3, 14):
        assert result.err.splitlines()[-1] == "MemoryError"
    else:  # it may have too little memory left for the last line of its own traceback
        assert {"MemoryError", "object type name: MemoryError"} & set(result.err.splitlines())


def test_the_memory_of_a_program_is_limited_by_the_machine_and_by_wish(monkeypatch: pytest.MonkeyPatch) -> None:
    from day6_core.shell.process.memory import LEAST, memory_limit

    monkeypatch.delenv("DAY6_MEMORY_LIMIT", raising=False)
    assert memory_limit() == 0 or memory_limit() >= LEAST
    monkeypatch.setenv("DAY6_MEMORY_LIMIT", "0")
    assert memory_limit() == 0
    monkeypatch.setenv("DAY6_MEMORY_LIMIT", "256")
    assert memory_limit() == 256 * 2**20


@pytest.mark.process
@posix
def test_what_nobody_looked_at_is_dropped_and_the_terminal_says_how_much(
    seat: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("day6_core.shell.terminal.PAUSE", 0.0)
    write(seat.desk.home, "a.py", "for number in range(20_000): print(f'line {number:70}')\nopen('done', 'w')\n")
    seat.terminal.send("python3 a.py\r")

    def printed() -> bool:
        seat.desk.scheduler.advance()
        return (seat.desk.home / "done").exists() and not running_processes(seat.desk.scheduler)

    assert until(printed)
    assert seat.terminal._size <= 256 * 1024
    said: list[str] = []
    while seat.terminal.has_more:
        seat.terminal.update()
        said += [row for row in map(row_text, seat.terminal.screen.scrollback) if "dropped" in row]
    assert re.fullmatch(r"… \d{5} lines dropped *", said[0])
    assert "19999" in seat.wait_prompt()


@pytest.mark.process
@posix
def test_what_is_typed_while_a_program_runs_and_it_does_not_read_is_the_shells(seat: Any) -> None:
    write(seat.desk.home, "a.py", "import os, time\nprint('ready')\nwhile not os.path.exists('go'): time.sleep(0.01)\n")
    seat.line("python3 a.py")
    seat.wait(lambda text: "ready" in text)
    seat.type("echo typed ahead; echo 你好\recho un")
    (seat.desk.home / "go").touch()
    seat.wait(lambda text: "typed ahead" in text.splitlines() and text.endswith(f"{PROMPT} echo un"))
    assert "你好" in seat.look().splitlines()


_WAITS = "import pathlib, os, time\npathlib.Path('started').touch()\nwhile not os.path.exists('go'): time.sleep(0.01)\n"


@pytest.mark.process
@posix
def test_what_is_typed_ahead_is_not_for_a_program_in_the_background(seat: Any) -> None:
    write(seat.desk.home, "a.py", _WAITS)
    seat.type("python3 a.py & sleep 50\recho for the shell\r")
    seat.wait(lambda _: (seat.desk.home / "started").exists())
    seat.settle(60)
    assert seat.look().splitlines()[-2:] == ["for the shell", PROMPT]
    (seat.desk.home / "go").touch()
    assert until(lambda: not running_processes(seat.desk.scheduler), meanwhile=seat.desk.scheduler.advance)


@pytest.mark.process
@posix
def test_what_is_typed_ahead_reaches_a_program_that_comes_to_the_foreground(seat: Any) -> None:
    write(seat.desk.home, "a.py", _WAITS + "print('read', input())\n")
    seat.type("python3 a.py & sleep 50; fg\r")
    seat.wait(lambda _: (seat.desk.home / "started").exists())
    seat.type("mine\r")
    seat.settle(60)
    (seat.desk.home / "go").touch()
    seat.wait(lambda text: "read mine" in text)
