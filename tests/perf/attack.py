"""Attacks the desktop at a real terminal with keys, mouse, pastes, bytes and hostile programs. Linux only, by hand.

    python -m tests.perf.attack [--minutes 10 | --runs N] [--jobs 1] [--seed 1] [--first N] [--only N]

Every run is one desktop: some bursts of random deeds, after each of which a new terminal must answer `echo`; then ^Q, whose
questions are answered. `--seed` and a run's number give the same deeds again (`--only N` plays that run alone and prints
them; the machine's speed still decides what meets what). A run is good when the desktop lived until it was told to end, answered
in time, wrote nothing to the terminal but text and what our renderer makes (`tests/e2e/hostile.py`), logged no exception
(DAY6_LOG), printed no traceback outside its own screen, ended with status 0, gave the terminal back, and left neither a process
nor a temporary file. The exit status is 1 if any run was not good.
"""

from __future__ import annotations

import contextlib
import os
import re
import select
import signal
import sys
import time
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import pyte

from tests.e2e.hostile import HOSTILE, SEQUENCES, SHORT, foreign, whole
from tests.perf.ends import KEYS, LINES, PROGRAMS
from tests.perf.random_runs import RandomRun, options_of, played
from tests.perf.screen import set_window_size

START = """\
import asyncio, faulthandler, signal, sys
stacks = open({stacks!r}, "w")
faulthandler.register(signal.SIGUSR1, file=stacks, all_threads=True)
from day6_tui.app import Day6App
from day6_tui.main import main
attach = Day6App._attend_the_end

def attend(app):
    def tell():
        print("leaving:", app._exit, "focus:", app.focused, "overlay:", app.desktop.overlay, app.size, file=stacks)
        for task in asyncio.all_tasks():
            task.print_stack(file=stacks)
        stacks.flush()
    asyncio.get_running_loop().add_signal_handler(signal.SIGUSR2, tell)
    attach(app)

Day6App._attend_the_end = attend
sys.argv[1:] = {words!r}
sys.exit(main())
"""
"""The installed command, which moreover writes the stacks of its threads on SIGUSR1, of its tasks on SIGUSR2."""

ANSWER_SECONDS = 30.0
"""Within which a new terminal answers; the machine may be full of programs that spin."""
END_SECONDS = 15.0
SLOW_SECONDS = 8.0
"""After which the stacks of a desktop that does not answer are written down."""

FUNCTION_KEYS = (
    "\x1bOP", "\x1bOQ", "\x1bOR", "\x1bOS", "\x1b[15~", "\x1b[17~", "\x1b[18~", "\x1b[19~", "\x1b[20~", "\x1b[21~",
    "\x1b[23~", "\x1b[24~", "\x1b[1;2R",
)  # fmt: skip
CURSOR_KEYS = "ABCDFH"
REPORTS = (
    b"\x1b[I", b"\x1b[O", b"\x1b[?2026;2$y", b"\x1b[?2048;0$y", b"\x1b[1;1R", b"\x1b[9999;9999R", b"\x1b[?1;2c",
    b"\x1b[>1;10;0c", b"\x1b]10;rgb:ffff/0000/0000\x1b\\", b"\x1b]52;c;b3duZWQ=\x07", b"\x1bP1$r0m\x1b\\",
    b"\x1bP>|evil(1)\x1b\\", b"\x1b_Gi=1;OK\x1b\\", b"\x1b[?0u", b"\x1b[97;5u", b"\x1b[97;1:3u", b"\x1b[57441;2u",
    b"\x1b[13;5u", b"\x1b[127;3u", b"\x1b[1114112u", b"\x1b[55296;1;57343u", b"\x1b[;;u", b"\x1b[27;5;9~",
    b"\x1b[8;10;10t", b"\x1b[48;24;80;0;0t", b"\x1b[M   ", b"\x1b[<35;-1;0M", b"\x1b[<0;99999;1M", b"\x1b[200~",
    b"\x1b[201~", b"\x1b[", b"\x1b]", b"\x1bP", b"\x1b", b"\x1b\x1b[A", b"\x1b[Z", b"\x9b1A", b"\x00", b"\x1bO",
)  # fmt: skip
"""What terminals answer, asked or not, whole or cut, and keys in the newer ways of writing them."""
BAD_BYTES = (b"\xff\xfe", b"\xc3", b"\x80\x81", "中文路径".encode("gbk"), "é".encode("latin-1"), b"\xed\xa0\x80")
PALETTE = (
    "language",
    "theme",
    "glyphs",
    "grow",
    "shrink",
    "copy",
    "paste",
    "clear",
    "close",
    "step",
    "faster",
    "motion",
)

_COPIED = re.compile(rb"\x1b\]52;c;[A-Za-z0-9+/=]*\x07")
"""What the user has marked with the mouse goes to the clipboard."""

_LAST = b"\x1b[?1049l"
NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
rclpy.init()
node = Node('evil')
publisher = node.create_publisher(String, 'chatter', 10)
def tick():
    node.get_logger().info(EVIL)
    publisher.publish(String(data=EVIL))
node.create_timer(0.02, tick)
rclpy.spin(node)
"""
MORE_PROGRAMS = {
    "evil": f"EVIL = {HOSTILE!a}\n{NODE}",
    "titles": f"import sys\nwhile True:\n    sys.stdout.write({HOSTILE!a} + '\\x1b[5;5Htext')\n",
    "binary": "import os\nwhile True: os.write(1, os.urandom(4096))\n",
    "alternate": "print('\\x1b[?1049h\\x1b[?1003h\\x1b[?2004h\\x1b[3;1r', end='', flush=True)\nimport time\ntime.sleep(99)\n",
    "dies": "import os, signal\nos.kill(os.getpid(), signal.SIGSEGV)\n",
    "asks": "while True: print(repr(input('? ')))\n",
}
MORE_LINES = (
    *(f"python3 {name}.py" for name in MORE_PROGRAMS),
    *(f"python3 {name}.py &" for name in ("evil", "dies", "asks")),
    "ros2 run turtlesim turtle_teleop_key",
    "ros2 run turtlesim draw_square &",
    "ros2 launch turtlesim multisim.launch.py &",
    "ros2 launch day6_world world.launch.py &",
    "ros2 run day6_bot car_view &",
    "rqt_console &",
    "rqt_plot /turtle1/pose/x &",
    "rqt &",
    "rqt_topic",
    "python3",
    "nano evil.txt",
    "nano *.py",
    "nano nowhere/x.py",
    "cat evil.txt",
    "cat /dev/urandom | head -c 200000",
    "ls -la; ls *; echo *",
    "cd ~/*'[@click=app.quit]'",
    "bg",
    "fg",
    "jobs; kill %1",
    "kill -STOP %1; kill -CONT %1",
    "cd ros2_ws && colcon build --symlink-install",
    "ros2 pkg create --build-type ament_python --node-name n p",
    "ros2 node list; ros2 topic list -t",
    "ros2 topic hz /turtle1/pose",
    "ros2 service call /reset std_srvs/srv/Empty",
    "ros2 service call /kill turtlesim/srv/Kill \"{name: turtle1}\"",
    "xterm -e nano talker.py",
    "exit",
    "clear",
    "cat",
    "cat << EOF",
    "for i in 1 2 3; do sleep 0.1; echo $i; done &",
    "echo $((",
    "rm -rf ~/nano* ; mkdir -p x/y/z; cd x/y/z; rm -rf ~/x",
)  # fmt: skip


@dataclass
class Attack(RandomRun):
    """One desktop under attack."""

    slowest_answer: float = 0.0
    size: tuple[int, int] = (80, 24)

    # -- a run ---------------------------------------------------------------------------------------------------------

    def play(self) -> None:
        self.prepare({**PROGRAMS, **MORE_PROGRAMS})
        (self.home / "evil.txt").write_text(HOSTILE + "\n", encoding="utf-8", newline="")
        (self.home / SHORT).mkdir()
        with open(os.fsencode(self.home) + b"/b\xff\xe1", "wb"):
            pass
        words = ["--home", str(self.home), "--lang", self.random.choice(["en", "zh"])]
        for option, values in (
            ("--scene", [None, "turtle", "car", "world", "empty", "empty"]),
            ("--glyphs", [None, None, "ascii", "braille", "cell"]),
        ):
            value = self.random.choice(values)
            words += [] if value is None else [option, value]
        self.size = self.random.choice([(80, 24), (120, 40)])
        self.note(f"{' '.join(words[2:])}, {self.size[0]}x{self.size[1]}")
        self.log = self.folder / "log"
        self.start(START, words, self.size, DAY6_LOG=str(self.log))
        with contextlib.suppress(TimeoutError, OSError):
            self.screen.first_frame()
        for _ in range(self.random.randint(2, 6)):
            for _ in range(self.random.randint(1, 12)):
                self.random.choice(DEEDS)(self)
                self.look(self.random.uniform(0, 0.4))
            if not self.answers():
                break
        if self.status is None and not self.troubles:
            self.leave()
        elif self.status is None:
            self.kill()
        self.check_output()
        self.look_for_leftovers()
        with contextlib.suppress(OSError):
            os.close(self.screen._fd)

    # -- the terminal --------------------------------------------------------------------------------------------------

    def send(self, data: bytes | str) -> None:
        """Send bytes, taking meanwhile what is drawn, as a terminal does."""
        rest = data.encode("utf-8", "surrogateescape") if isinstance(data, str) else data
        end = time.monotonic() + ANSWER_SECONDS
        os.set_blocking(self.screen._fd, False)
        while rest and self.status is None and time.monotonic() < end:
            try:
                rest = rest[os.write(self.screen._fd, rest[:4000]) :]
            except BlockingIOError:
                select.select([], [self.screen._fd], [], 0.02)
            except OSError:
                break
            self.look(0)
        if rest and self.status is None:
            self.troubles.append(f"takes no keys for {ANSWER_SECONDS} s")
        os.set_blocking(self.screen._fd, True)

    def look(self, seconds: float) -> None:
        """Read what is drawn for so long."""
        end = time.monotonic() + seconds
        while select.select([self.screen._fd], [], [], max(0.0, end - time.monotonic()))[0]:
            try:
                data = os.read(self.screen._fd, 65536)
            except OSError:
                data = b""
            self.screen.output += data
            if not data:
                time.sleep(0.02)
                break
            if time.monotonic() > end:
                break
        if self.status is None:
            pid, status = os.waitpid(self.screen.pid, os.WNOHANG)
            if pid:
                self.status = os.waitstatus_to_exitcode(status)

    def resize(self, columns: int, rows: int) -> None:
        self.size = (columns, rows)
        set_window_size(self.screen._fd, columns, rows)

    # -- what must hold ------------------------------------------------------------------------------------------------

    def answers(self) -> bool:
        """Whether a new terminal says what it is told to."""
        if self.status is not None:
            return self.has_left()
        self.note("answers?")
        self.send(b"\x1b[201~")
        self.look(0.2)
        picture: Any = pyte.Screen(100, 30)
        stream: Any = pyte.ByteStream(picture)
        self.resize(100, 30)
        began = time.monotonic()
        fed = len(self.screen.output)
        marker = f"{self.number}x{self.random.randint(0, 10**9)}"
        asked_stacks = tries = 0
        while time.monotonic() - began < ANSWER_SECONDS:
            tries += 1
            for keys in ("\x1b", "\x1b", "n", "\x1b", "\x1bOQ") if tries > 1 else ("\x1b", "\x1b", "\x1bOQ"):
                self.send(keys)
                self.look(0.3)
            self.send(f"echo {marker[:-2]}''{marker[-2:]}\r")
            until = min(time.monotonic() + 5 * tries, began + ANSWER_SECONDS)
            while time.monotonic() < until:
                self.look(0.05)
                data = bytes(self.screen.output[fed:])
                fed += len(data)
                stream.feed(re.sub(rb"\x1b\[[<>=?][0-9;]*(?:\$p|[uqcmn])", b"", data))
                if any(marker in line for line in picture.display):
                    self.slowest_answer = max(self.slowest_answer, time.monotonic() - began)
                    return True
                if self.status is not None:
                    return self.has_left()
                if not asked_stacks and time.monotonic() - began > SLOW_SECONDS:
                    asked_stacks = 1
                    os.kill(self.screen.pid, signal.SIGUSR1)
                    os.kill(self.screen.pid, signal.SIGUSR2)
        shown = "\n".join(line.rstrip() for line in picture.display)
        self.troubles.append(
            f"no answer within {ANSWER_SECONDS} s\n{shown}\n{self.stacks.read_text()}\n{self.log_text()[-2000:]}"
        )
        return False

    def has_left(self) -> bool:
        """It ended before it was told to: a click on the key bar, Ctrl+Q in another way of writing or the palette may do that."""
        if self.status:
            self.troubles.append(f"ended by itself with status {self.status}")
        return False

    def leave(self) -> None:
        """Press ^Q and answer what is asked, as often as a person would."""
        began = time.monotonic()
        for keys in ("\x11", "y", "\x1b", "\x11", "y", "\x1b", "\x1b", "\x11", "y"):
            self.send(keys)
            end = time.monotonic() + 2.5
            while self.status is None and time.monotonic() < end:
                self.look(0.05)
            if self.status is not None:
                break
        if self.status is None:
            os.kill(self.screen.pid, signal.SIGUSR1)
        while self.status is None and time.monotonic() - began < END_SECONDS + 10:
            self.look(0.1)
        if self.status is None:
            self.troubles.append(f"does not end\n{self.stacks.read_text()}")
            self.kill()
            return
        self.look(0.1)
        if self.status:
            self.troubles.append(f"status {self.status}")
        self.check_terminal()

    def check_output(self) -> None:
        data = whole(bytes(self.screen.output))
        if _LAST in data:  # what comes behind it is the echo of the terminal itself
            data = data[: data.rindex(_LAST) + len(_LAST)]
        if b"\x1b]52;c;b3duZWQ=\x07" in data:
            self.troubles.append("somebody wrote to the clipboard")
        if found := foreign(_COPIED.sub(b"", data), desktop=True):
            self.troubles.append(f"reached the terminal: {found[:5]}")
        outside = re.sub(rb"\x1b\[\?1049h.*?(?:\x1b\[\?1049l|\Z)", b"", data, flags=re.DOTALL)
        if b"Traceback" in outside or b"Error" in outside or b"Exception" in outside:
            self.troubles.append(f"printed\n{outside.decode('utf-8', 'replace')[-3000:]}")
        if "Traceback" in (text := self.log_text()):
            self.troubles.append(f"logged\n{text[-5000:]}")

    def log_text(self) -> str:
        """What our own parts have logged."""
        return self.log.read_text(encoding="utf-8", errors="replace") if self.log.exists() else ""


# -- deeds -------------------------------------------------------------------------------------------------------------


def line(attack: Attack) -> None:
    """A command, with its keys as quickly as they come."""
    text = attack.random.choice(LINES + MORE_LINES)
    attack.note(f"line {text[:60]}")
    attack.send(text + "\r")


def keys(attack: Attack) -> None:
    chosen = "".join(attack.random.choices(KEYS, k=attack.random.randint(1, 12)))
    attack.note(f"keys {chosen!r}")
    attack.send(chosen)


def modified(attack: Attack) -> None:
    chosen = []
    for _ in range(attack.random.randint(1, 6)):
        modifier = attack.random.randint(2, 16)
        chosen.append(
            attack.random.choice(
                [
                    f"\x1b[1;{modifier}{attack.random.choice(CURSOR_KEYS)}",
                    f"\x1b[{attack.random.randint(1, 24)};{modifier}~",
                    f"\x1b[{attack.random.randint(1, 200)};{modifier}u",
                    "\x1b" + chr(attack.random.randint(1, 126)),
                    chr(attack.random.choice([n for n in range(1, 32) if n != 17])),
                    attack.random.choice(FUNCTION_KEYS),
                ]
            )
        )
    attack.note(f"modified {chosen!r}")
    attack.send("".join(chosen))


def mouse(attack: Attack) -> None:
    columns, rows = attack.size
    x, y = attack.random.randint(1, columns), attack.random.randint(1, rows)
    button = attack.random.choice([0, 0, 0, 1, 2, 4, 8, 16, 64, 65, 66])
    report = f"\x1b[<{button};{x};{y}M"
    for _ in range(attack.random.choice([0, 0, 1, 5])):
        x = min(columns, max(1, x + attack.random.randint(-20, 20)))
        y = min(rows, max(1, y + attack.random.randint(-8, 8)))
        report += f"\x1b[<{32 + button};{x};{y}M"
    attack.note(f"mouse {report!r}")
    attack.send(report + f"\x1b[<{button};{x};{y}m")


def every_cell(attack: Attack) -> None:
    """Click into many cells, row by row, as a bored child does."""
    columns, rows = attack.size
    step = max(1, columns * rows // 150)
    begin = attack.random.randrange(step)
    attack.note(f"clicks {begin} {step}")
    for cell in range(begin, columns * rows, step):
        x, y = cell % columns + 1, cell // columns + 1
        attack.send(f"\x1b[<0;{x};{y}M\x1b[<0;{x};{y}m")


def paste(attack: Attack) -> None:
    text = attack.random.choice(
        [
            "echo pasted\n" * attack.random.randint(1, 60),
            HOSTILE,
            "x" * attack.random.choice([100, 5000, 100_000]),
            "\x00" * 50,
            "for i in 1 2 3\ndo\n echo $i\ndone\n",
            "中文 é \U0001f600\u0301" * 30,
            attack.random.choice(list(SEQUENCES.values())) * 20,
            "\udcff\udce1",
        ]
    )
    marks = attack.random.random() < 0.8
    attack.note(f"paste {text[:30]!r}… of {len(text)}, marks {marks}")
    text = text.replace("\x11", "")
    attack.send("\x1b[200~" + text + "\x1b[201~" if marks else text[:3000].replace("\x1b", ""))


def raw_bytes(attack: Attack) -> None:
    data = b"".join(attack.random.choices(REPORTS + BAD_BYTES, k=attack.random.randint(1, 6)))
    attack.note(f"bytes {data!r}")
    attack.send(data)


def noise(attack: Attack) -> None:
    """Bytes that mean nothing, without ^Q, which would end it."""
    data = attack.random.randbytes(attack.random.randint(1, 300)).replace(b"\x11", b"")
    attack.note(f"noise {data!r}")
    attack.send(data)


def resize(attack: Attack) -> None:
    columns, rows = attack.random.choice(
        [(1, 1), (500, 200), (2, 2), (80, 24), (120, 40), (attack.random.randint(1, 200), attack.random.randint(1, 60))]
    )
    attack.note(f"resize {columns}x{rows}")
    attack.resize(columns, rows)


def palette(attack: Attack) -> None:
    word = attack.random.choice(PALETTE)
    attack.note(f"palette {word}")
    attack.send("\x1b[18~")
    attack.look(0.2)
    attack.send(word)
    attack.look(0.1)
    attack.send("\r")


def completion(attack: Attack) -> None:
    text = attack.random.choice(
        [
            "ros2 ",
            "ros2 topic echo /",
            "cd ",
            "nano ",
            "python3 b",
            "ros2 run ",
            "cat b\x16",
            "$",
            "echo ${",
            "~/",
            "'",
            "l",
        ]
    )
    back = attack.random.randint(0, len(text))
    attack.note(f"completion {text!r} {back}")
    attack.send(text + "\x1b[D" * back + "\t\t" + attack.random.choice(["", "\r", "\x03", "\x12ec\r", "\x15"]))


def edit(attack: Attack) -> None:
    """Type into a file, and save it or not."""
    attack.note("edit")
    attack.send(f"nano {attack.random.choice(['talker.py', 'evil.txt', 'new.txt', 'floods.py'])}\r")
    attack.look(0.5)
    text = "".join(
        attack.random.choices(("a", "中", "\r", "\t", "\x1b[A", "\x1b[B", "\x1b[3~", "\x7f", "\x0b", "\x15"), k=20)
    )
    attack.send(text + attack.random.choice(["", "\x13", "\x0f\r", "\x18n", "\x18y\r", "\x06a\r", "\x1f9\r", "\x1a"]))


def stop(attack: Attack) -> None:
    attack.note("^Z, bg, fg")
    attack.send("\x1abg\rfg\r" if attack.random.random() < 0.5 else "\x1afg\r\x03")


DEEDS: tuple[Callable[[Attack], None], ...] = (
    line, line, line, line, keys, keys, modified, mouse, mouse, every_cell, paste, raw_bytes, noise, resize, palette,
    completion, edit, stop,
)  # fmt: skip


def main() -> int:
    """Play the runs; print what was not good."""
    counts: Counter[str] = Counter()
    for attack in played(Attack, options_of(__doc__, runs=None, jobs=1, minutes=10.0)):
        counts["runs"] += 1
        counts["deeds"] += len(attack.deeds)
        counts["bytes"] += len(attack.screen.output)
        counts["slowest ms"] = max(counts["slowest ms"], int(1000 * attack.slowest_answer))
        if attack.troubles:
            counts["bad"] += 1
            told = [
                f"run {attack.number}: {'; '.join(attack.deeds)}",
                *(f"    {trouble}" for trouble in attack.troubles),
            ]
            print("\n".join(told), flush=True)
        else:
            print(f"{attack.number} …", flush=True)
    print(
        f"{counts['runs']} runs, {counts['deeds']} deeds, {counts['bytes'] / 1e6:.0f} MB drawn, slowest answer "
        f"{counts['slowest ms'] / 1000:.1f} s, {counts['bad']} not good",
        flush=True,
    )
    return 1 if counts["bad"] else 0


if __name__ == "__main__":
    sys.exit(main())
