"""A server with two pupils, anna and bert, in one mode; run as a program it is one that is not root: `school.py MODE DEED TOP`.

Deeds print one JSON value. What is tried is asked of the system, not of the code that is tested.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import Any

from day6_core.isolation import modes
from day6_core.isolation.cell import Cell, Limits, Phrase
from day6_core.isolation.mode import Mode
from tests.support.waiting import PATIENCE, Deadline

ROOT = Path(__file__).resolve().parents[2]
PLAIN_USER = 61001
"""The server without rights, when the tests are started by root."""
LIMITS = Limits(memory=384 << 20, processes=40, disk=8 << 20, open_files=256)

ORPHANS = """
import os, sys, time
mark = sys.argv[1]
for kind in range(4):
    if os.fork() == 0:
        os.setsid()
        if os.fork():
            os._exit(0)
        for number in range(3):
            os.close(number)
        env = {} if kind % 2 else os.environ
        os.execve("/bin/sh" if kind < 2 else sys.executable, (
            ["sh", "-c", "trap '' TERM HUP INT; while :; do sleep 1; done", mark] if kind < 2 else
            ["python3", "-c", "import time; time.sleep(600)", mark]), env)
print("left", flush=True)
time.sleep(float(sys.argv[2]))
"""
"""Leaves four processes behind: out of the group, the session and the terminal, without variables, deaf to signals."""

FORKS = """
import os, time
children = 0
try:
    while children < 300:
        if os.fork() == 0:
            os.closerange(0, 3)
            time.sleep(600)
            os._exit(0)
        children += 1
except OSError:
    pass
print(children, flush=True)
"""
EATS = """
import sys
taken = []
try:
    for _ in range(100):
        taken.append(bytearray(b"x" * (16 << 20)))
except MemoryError:
    pass
print(len(taken) * 16, flush=True)
"""
WRITES = """
import signal
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
written = 0
try:
    with open("big", "wb", buffering=0) as file:
        for _ in range(64):
            written += file.write(bytes(1 << 20))
except OSError:
    pass
print(written >> 20)
"""
LESSON = """
cd ~
python3 mine.py &
timeout 200 ros2 topic echo --once /mine std_msgs/msg/String
ros2 node list
kill %1
"""
MINE = """
import rclpy
from std_msgs.msg import String
rclpy.init()
node = rclpy.create_node("mine")
publisher = node.create_publisher(String, "mine", 10)
node.create_timer(0.1, lambda: publisher.publish(String(data="from mine")))
rclpy.spin(node)
"""
MEETS = """
import sys
from day6_core.link.paths import meeting_place
meeting_place(0)
print("heard", *sys.argv[1:])
"""


class School:
    """The pupils' cells in a folder of the server."""

    def __init__(self, mode: Mode, top: Path) -> None:
        self.mode, self.top = mode, top
        for folder in (top / "homes", top / "run"):
            folder.mkdir(exist_ok=True)
            folder.chmod(0o711)

    def cell(self, name: str, limits: Limits = LIMITS) -> Cell:
        homes = self.top / "homes"
        cell = Cell(name, homes / name, self.top / "run" / name, self.mode.uid_of(name, homes), limits)
        self.mode.prepare(cell)
        return cell

    def run(self, cell: Cell, argv: list[str], **more: Any) -> subprocess.CompletedProcess[str]:
        """Run a program of the pupil's to its end."""
        options: dict[str, Any] = {"stdin": subprocess.DEVNULL} if "input" not in more else {}
        return subprocess.run(
            self.mode.command(cell, argv),
            capture_output=True,
            text=True,
            timeout=10 * PATIENCE,
            env={"PATH": "/usr/bin:/bin", "LANG": "C.UTF-8", "TOKEN_OF_SERVER": "secret"},
            start_new_session=True,
            **options,
            **more,
        )

    def python(self, cell: Cell, code: str, *words: str) -> subprocess.CompletedProcess[str]:
        return self.run(cell, [sys.executable, "-I", "-c", code, *words])


def found(mark: str) -> list[int]:
    """Find the processes of this machine that have `mark` as a word of their command line."""
    pids = []
    for name in os.listdir("/proc"):
        if name.isdigit() and int(name) != os.getpid():
            try:
                words = Path("/proc", name, "cmdline").read_bytes().split(b"\0")
                state = Path("/proc", name, "stat").read_text(errors="replace").rpartition(")")[2].split()[0]
            except OSError:
                continue
            if os.fsencode(mark) in words and state != "Z":
                pids.append(int(name))
    return pids


def attacks(mode: Mode, _top: Path) -> list[str]:
    """What went through: the survey has just tried it."""
    assert mode.open is not None
    return sorted(mode.open)


def orphans(mode: Mode, top: Path) -> list[int]:
    """How many processes a pupil left, and how many of them the end of his cell."""
    school = School(mode, top)
    cell = school.cell("anna")
    mark = f"orphan-of-{os.getpid()}"
    with subprocess.Popen(
        mode.command(cell, [sys.executable, "-I", "-c", ORPHANS, mark, "600"]),
        stdout=subprocess.PIPE,
        start_new_session=True,
    ) as process:
        assert process.stdout is not None and process.stdout.readline() == b"left\n"
        before = five(mark)
        said = mode.end(cell)
        process.wait(10 * PATIENCE)
    return [before, len(found(mark)), int(said)]


def five(mark: str) -> int:
    """Wait until there are five such processes: the first, and the four it left (one that is becoming a program has no words)."""
    deadline = Deadline()
    while (count := len(found(mark))) < 5 and not deadline.is_over():
        time.sleep(0.02)
    return min(count, 5)


def orphans_of_ended(mode: Mode, top: Path) -> list[int]:
    """The same when the first program ends by itself, with `end` after it as the server calls it."""
    school = School(mode, top)
    cell = school.cell("anna")
    mark = f"orphan-of-{os.getpid()}"
    done = school.python(cell, ORPHANS, mark, "0.3")
    mode.end(cell)
    _let_the_kernel_end(mark)
    return [len(done.stdout.split()), len(found(mark)), len(mode.processes(cell))]


def forgotten(mode: Mode, top: Path) -> list[int]:
    """The server is killed with a pupil's programs running; the next one ends them."""
    school = School(mode, top)
    cell = school.cell("anna")
    mark = f"orphan-of-{os.getpid()}"
    reading, writing = os.pipe()
    server = os.fork()
    if server == 0:
        with subprocess.Popen(
            mode.command(cell, [sys.executable, "-I", "-c", ORPHANS, mark, "600"]),
            stdout=writing,
            start_new_session=True,
        ):
            pass
        os._exit(0)
    assert os.read(reading, 5) == b"left\n"
    before = five(mark)
    os.kill(server, 9)
    os.waitpid(server, 0)
    mode.end(cell)
    _let_the_kernel_end(mark)
    return [before, len(found(mark))]


def _let_the_kernel_end(mark: str) -> None:
    """bwrap may have ended before it was looked for: then the kernel is just ending what was in its namespace."""
    deadline = Deadline()
    while found(mark) and not deadline.is_over():
        time.sleep(0.01)


FILLS = """
import os
written = 0
try:
    for number in range(10):
        with open(f"{os.environ['TMPDIR']}/{number}", "wb") as file:
            file.write(bytes(4 << 20))
        written += 4
except OSError:
    pass
print(written)
"""


def limits(mode: Mode, top: Path) -> dict[str, int]:
    """How many processes, MB of memory, MB of a file and MB of temporary files that nobody counts a pupil got.

    The others' shares are not less by it.
    """
    school = School(mode, top)
    cell = school.cell("anna")
    files = int(school.python(cell, WRITES).stdout)
    memory = school.python(cell, EATS)
    before = mode.disk_used(cell)
    temporary = int(school.python(cell, FILLS).stdout) - (mode.disk_used(cell) - before >> 20)
    taken = {"files": files, "memory": int(memory.stdout) if memory.stdout else 0, "temporary": temporary}
    if "processes" in mode.enforces:
        taken["processes"] = int(school.python(cell, FORKS).stdout)
        other = school.cell("bert")
        taken["others"] = school.python(other, "print('goes on')").returncode
        mode.end(other)
    mode.end(cell)
    return taken


def surroundings(mode: Mode, top: Path) -> dict[str, Any]:
    """What a program finds around it."""
    school = School(mode, top)
    code = (
        "import json, os, resource; print(json.dumps(dict(env=dict(os.environ), cwd=os.getcwd(), umask=os.umask(0),"
        "core=resource.getrlimit(resource.RLIMIT_CORE)[1], open=len(os.listdir('/proc/self/fd')), groups=os.getgroups())))"
    )
    cell = school.cell("anna")
    kept = os.open("/etc/passwd", os.O_RDONLY)
    os.set_inheritable(kept, True)
    done = subprocess.run(
        mode.command(cell, [sys.executable, "-I", "-c", code]),
        stdin=subprocess.DEVNULL,
        capture_output=True,
        env={"PATH": "/usr/bin:/bin", "TOKEN_OF_SERVER": "secret", "LD_PRELOAD": "", "DAY6_LANG": "zh"},
        close_fds=False,
    )
    mode.end(cell)
    found: dict[str, Any] = json.loads(done.stdout)
    return {**found, "home": str(cell.home), "runtime": str(cell.runtime)}


def lesson(mode: Mode, top: Path) -> str:
    """What a program of the pupil's own and `ros2` say to each other, by Zenoh, in the cell."""
    school = School(mode, top)
    cell = school.cell("anna", Limits())
    home = str(cell.home / "home")
    school.run(cell, ["sh", "-c", "mkdir home; cat > home/mine.py"], input=MINE)
    done = school.run(
        cell, [sys.executable, "-m", "day6_tui.main", "exec", "--home", home, "--timeout", "250", "-c", LESSON]
    )
    mode.end(cell)
    return done.stdout + done.stderr


def names(mode: Mode, top: Path) -> list[bool]:
    """Whether pupils with names that are no names stay in their places and apart."""
    school = School(mode, top)
    cells = []
    for folder, name in (("a", "../../etc"), ("b", "李 雷"), ("c", "-rf"), ("d", "$(id)\n\x1b[31m")):
        homes = top / "homes"
        cell = Cell(name, homes / folder, top / "run" / folder, mode.uid_of(folder, homes), LIMITS)
        mode.prepare(cell)
        cells.append(school.python(cell, "import os; print(os.getcwd())").stdout.strip() == str(cell.home))
        mode.end(cell)
    return cells


def graded(mode: Mode, top: Path) -> Any:
    """What a submission gets whose program meets others, in a cell as far down as the server's."""
    from tests.grading.article import write
    from tests.grading.own import own_gradings

    (top / "homes").mkdir()
    cell = Cell("g", top / "homes" / "g", top / "run" / "c12345678" / "p" / "g123456789012", None, Limits())
    mode.prepare(cell)
    own_gradings(cell.home)
    packed = write(cell.home / "s.zip", {"home/echo.py": MEETS}).read_bytes()
    job = {"size": len(packed), "seed": "s", "gradings": [str(cell.home / "own" / "own.md")], "answers": {}}
    done = subprocess.run(
        mode.command(cell, [sys.executable, "-I", "-m", "day6_core.lessons.grading.apart"]),
        input=json.dumps(job).encode() + b"\n" + packed,
        stdout=subprocess.PIPE,
        timeout=10 * PATIENCE,
        env={"PATH": "/usr/bin:/bin", "LANG": "C.UTF-8"},
        start_new_session=True,
    )
    mode.end(cell)
    report = json.loads(done.stdout)
    return [report["problem"], *(each["checks"] for each in report["scenarios"] if each["mark"] != "right")]


DEEDS: dict[str, Callable[[Mode, Path], Any]] = {
    deed.__name__: deed
    for deed in (attacks, orphans, orphans_of_ended, forgotten, limits, surroundings, lesson, names, graded)
}


@cache
def python_for_others() -> str | None:
    """Return a Python that can run this package as a user without rights: ours, or the system's with our packages."""
    if os.geteuid() != 0 or _runs(sys.executable):
        return sys.executable
    system = shutil.which(f"python3.{sys.version_info.minor}", path="/usr/local/bin:/usr/bin")
    if system is None or not _runs(system, "pass"):
        return None
    top = Path(tempfile.mkdtemp(prefix="day6-python-"))
    top.chmod(0o755)
    subprocess.run([system, "-m", "venv", "--without-pip", str(top)], check=True, timeout=10 * PATIENCE)
    packages = [path for path in sys.path if os.path.basename(path) == "site-packages"]
    (own,) = top.glob("lib/python3*/site-packages")
    lines = [f"import site; site.addsitedir({path!r})" for path in packages]
    (own / "theirs.pth").write_text("\n".join(lines) + "\n", encoding="utf-8")
    import atexit

    atexit.register(shutil.rmtree, top, True)
    return str(top / "bin" / "python3") if _runs(str(top / "bin" / "python3")) else None


def _runs(python: str, code: str = "import day6_core.isolation.modes, zenoh, textual") -> bool:
    try:
        tried = subprocess.run(
            [python, "-I", "-c", code],
            user=PLAIN_USER,
            group=PLAIN_USER,
            extra_groups=[],
            cwd="/",
            capture_output=True,
            timeout=10 * PATIENCE,
        )
    except OSError:
        return False
    return tried.returncode == 0


@contextmanager
def folder() -> Iterator[Path]:
    """A folder for one server: short, as it holds sockets, and open to pass through."""
    with tempfile.TemporaryDirectory(prefix="d6s-", dir="/tmp", ignore_cleanup_errors=True) as name:
        os.chmod(name, 0o711)
        if os.geteuid() == 0:
            os.makedirs(f"{name}/plain")
            os.chown(f"{name}/plain", PLAIN_USER, PLAIN_USER)
        yield Path(name).resolve()


def started(module: str) -> str:
    """What a Python that sees nothing of its surroundings runs to start the `main` of a module of the tests."""
    return f"import sys; sys.path.append({str(ROOT)!r}); from {module} import main; main()"


def asked(name: str, deed: str) -> Any:
    """Do a deed in a mode, as the server it is for; a text says why this machine does not have the mode."""
    python = python_for_others()
    if python is None:
        return "no Python here that other users may run"
    with folder() as top:
        as_root = os.geteuid() == 0
        plain: dict[str, Any] = {}
        if as_root and name != "users":
            plain = {"user": PLAIN_USER, "group": PLAIN_USER, "extra_groups": []}
            top = top / "plain"
            top.chmod(0o711)
        done = subprocess.run(
            [python, "-I", "-c", started(__name__), name, deed, str(top)],
            cwd="/",
            env={"PATH": "/usr/local/bin:/usr/bin:/bin", "HOME": str(top), "LANG": "C.UTF-8"},
            capture_output=True,
            text=True,
            timeout=40 * PATIENCE,
            **plain,
        )
    if done.returncode:
        raise AssertionError(done.stderr)
    return json.loads(done.stdout)


def in_words(words: Phrase) -> str:
    from day6_tui.locale import Texts

    return Texts("en")(words.key, **words.values)


def main() -> None:
    """Do one deed."""
    name, deed, top = sys.argv[1:]
    (offer,) = modes.survey((name,))
    if offer.mode is None:
        assert offer.reason is not None
        print(json.dumps(f"{name}: {in_words(offer.reason)}"))
    else:
        print(json.dumps({"got": DEEDS[deed](offer.mode, Path(top))}))
