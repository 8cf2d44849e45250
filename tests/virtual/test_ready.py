# ruff: noqa: E501 (a program a line)
"""A program that begins in an interpreter that was ready finds, prints and does what it does in a new one."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

if sys.platform != "linux":
    pytest.skip("virtual time is there on Linux only", allow_module_level=True)

from day6_core.virtual.ready import forks

pytestmark = pytest.mark.process

_REPOSITORY = Path(__file__).parents[2]

PROGRAMS = {
    "main": "print(__name__, __file__, __spec__, __package__, __doc__, type(__loader__), sorted(globals()))\nimport __main__\nprint(__main__.__file__)",
    "documented": '"""Says so."""\nprint(__doc__)',
    "system": """
import sys
print(sys.argv, sys.orig_argv, sys.path, sys.executable, sys.prefix, sys.flags, sys.warnoptions, sys._xoptions)
print(sys.getrecursionlimit(), sys.getswitchinterval(), sys.dont_write_bytecode, sys.platlibdir, hash("a"))
print(hasattr(sys, "last_type"), hasattr(sys, "ps1"), sys.gettrace(), sys.getprofile())
""",
    "streams": """
import sys
for name in "stdin", "stdout", "stderr":
    stream = getattr(sys, name)
    assert stream is getattr(sys, f"__{name}__")
    print(stream, stream.encoding, stream.errors, stream.line_buffering, stream.write_through, stream.mode)
    print(type(stream.buffer), stream.fileno(), stream.isatty(), stream.newlines, stream.reconfigure)
""".replace(", stream.reconfigure", ""),
    "unbuffered": "import sys\nprint(sys.stdout.write_through, type(sys.stdout.buffer))\nprint(1, file=sys.stderr)",
    "surroundings": """
import os, resource, signal, locale, warnings, gc, threading, faulthandler
print(sorted(os.environ.items()))
print(os.getcwd(), os.umask(0), os.getpriority(0, 0), os.getsid(0) == os.getpgid(0) == os.getpid(), os.cpu_count())
for each in signal.valid_signals():
    print(each, signal.getsignal(each))
print(signal.pthread_sigmask(signal.SIG_BLOCK, []), signal.getitimer(signal.ITIMER_REAL))
for name in dir(resource):
    if name.startswith("RLIMIT"):
        print(name, resource.getrlimit(getattr(resource, name)))
print(locale.setlocale(locale.LC_ALL), locale.getpreferredencoding(), warnings.filters)
print(gc.isenabled(), gc.get_threshold(), gc.callbacks, faulthandler.is_enabled())
print(threading.enumerate()[0].name, threading.active_count(), threading.main_thread() is threading.current_thread())
""",
    "what the system shows": """
import os, pathlib, sys
own = pathlib.Path("/proc/self")
print((own / "cmdline").read_bytes().rstrip(b"\\0").split(b"\\0"))
shown = dict(each.split(b"=", 1) for each in (own / "environ").read_bytes().split(b"\\0") if each)
print(shown == os.environb, len(shown))
print(sorted(os.listdir(own / "fd"))[:4], (own / "comm").read_text(), (own / "fd").stat().st_uid)
print([line for line in (own / "status").read_text().splitlines() if line.startswith(("SigB", "SigI", "SigC", "Cap", "NoNew", "Seccomp", "Threads"))])
""",
    "modules": """
import sys, email
print([name in sys.modules for name in ("calendar", "subprocess", "secrets", "ctypes", "runpy", "resource", "shutil", "yaml", "argparse", "setuptools", "day6_core.lessons.grading.judge", "geometry_msgs.msg")])
import concurrent, xml, geometry_msgs
print(hasattr(concurrent, "futures"), hasattr(xml, "etree"), hasattr(geometry_msgs, "msg"), hasattr(email, "message"))
import concurrent.futures, xml.etree.ElementTree, geometry_msgs.msg, calendar, email.message
print(concurrent.futures.Future, xml.etree.ElementTree.Element, geometry_msgs.msg.Twist(), calendar.month_name[3])
print(sys.modules["concurrent.futures"] is concurrent.futures, concurrent.futures.__spec__.origin, concurrent.futures._base)
import importlib.util
print(importlib.reload(calendar) is calendar, importlib.import_module("calendar") is calendar, importlib.util.find_spec("calendar"))
import setuptools, distutils.core, pkgutil
print(setuptools.setup, distutils.core.setup, pkgutil.find_loader if hasattr(pkgutil, "find_loader") else "")
""".replace(', pkgutil.find_loader if hasattr(pkgutil, "find_loader") else ""', ""),
    "own module further on": """
import os, sys
os.makedirs("further/unittest", exist_ok=True)
open("further/secrets.py", "w").write("own = 1")
open("further/unittest/__init__.py", "w").write("own = 2")
sys.path.insert(0, "further")
import secrets, unittest
print(secrets.own, unittest.own)
""",
    "missing": "import calender",
    "not there": "from calendar import nothing",
    "error": "def f(n):\n    return 1 / n\n\ntry:\n    f(0)\nexcept ZeroDivisionError as error:\n    raise ValueError('zero') from error",
    "error while another": "try:\n    {}['a']\nexcept KeyError:\n    [][1]",
    "syntax": "print(1)\ndef f(:\n    pass",
    "indentation": "def f():\npass",
    "not utf-8": "# latin\nname = 'caf\udce9'",
    "null byte": "print(1)\0",
    "exit 3": "import sys\nprint('before', end='')\nsys.exit(3)",
    "exit with words": "raise SystemExit('enough')",
    "exit with nothing": "print('x'); exit()",
    "exit at once": "import os, sys\nsys.stdout.write('lost')\nos._exit(4)",
    "interrupted": "print('a', end='')\nraise KeyboardInterrupt",
    "interrupts itself": "import os, signal, time\nprint('a')\nos.kill(os.getpid(), signal.SIGINT)\ntime.sleep(5)",
    "interrupt caught": "try:\n    raise KeyboardInterrupt\nexcept KeyboardInterrupt:\n    print('caught')",
    "killed": "import os\nos.kill(os.getpid(), 9)",
    "terminated": "import os\nos.kill(os.getpid(), 15)",
    "aborted": "import os\nos.abort()",
    "own hook": "import sys\nsys.excepthook = lambda cls, value, tb: print(cls, value, tb.tb_frame.f_code.co_name, tb.tb_lineno)\n1 / 0",
    "broken hook": "import sys\ndef hook(*_):\n    raise TypeError('hook')\nsys.excepthook = hook\n1 / 0",
    "at exit": "import atexit\natexit.register(print, 'bye')\nprint('hello')",
    "error at exit": "import atexit\natexit.register(lambda: 1 / 0)",
    "left open and forgotten": "class A:\n    other = open('left2', 'w')\n    def __init__(self):\n        self.file = open('left3', 'w'); self.file.write('x'); A.other.write('y')\nheld = [A()]",
    "what it had written": "print(open('left2').read(), open('left3').read())",
    "deleted at the end": "class A:\n    def __init__(self, name):\n        self.name = name\n    def __del__(self):\n        print('del', self.name)\nc, a, _b = A('c'), A('a'), A('_b')\nd = [A('in list')]\nd.append(d)",
    "deleted at the end, without a cycle": "import types\nA = types.new_class('A', (), {}, lambda names: names.update(__del__=eval('lambda self: print(self.n)', {'print': print})))\nx = A(); x.n = 'x'\n_y = A(); _y.n = '_y'",
    "error in del": "class A:\n    def __del__(self):\n        1 / 0\na = A()",
    "registers at exit": "import atexit\natexit.register(lambda: atexit.register(print, 'again'))",
    "exit with a number too large": "raise SystemExit(2**70)",
    "exit with 259": "raise SystemExit(259)",
    "exit with -1": "raise SystemExit(-1)",
    "exit with a tuple": "raise SystemExit(1, 2)",
    "exit with an object": "raise SystemExit([1])",
    "exit in a thread": "import threading, sys\nt = threading.Thread(target=sys.exit, args=(3,))\nt.start(); t.join(); print('on')",
    "hook exits": "import sys\nsys.excepthook = lambda *_: sys.exit(9)\n1 / 0",
    "no hook": "import sys\ndel sys.excepthook\n1 / 0",
    "no stderr": "import sys\nsys.stderr = None\n1 / 0",
    "own stderr": "import sys, io\nsys.stderr = io.StringIO()\n1 / 0",
    "daemon": "import threading, time\nthreading.Thread(target=lambda: [time.sleep(0.1), print('never')], daemon=True).start()\nprint('end')",
    "interrupted with an atexit call": "import atexit\natexit.register(print, 'bye')\nraise KeyboardInterrupt",
    "group of errors": "try:\n    raise ExceptionGroup('several', [ValueError(1), TypeError(2)])\nexcept NameError:\n    print('older')",
    "error with notes": "e = ValueError('x')\nif hasattr(e, 'add_note'):\n    e.add_note('more')\nraise e",
    "exit while waiting": "import os, signal, threading, time\nthreading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()\ntime.sleep(5)",
    "no output": "import sys\nsys.stdout.close()\nprint(1)",
    "output full": "import sys\nsys.stdout = open('/dev/full', 'w')\nprint(1)",
    "thread goes on": "import threading, time\nthreading.Thread(target=lambda: (time.sleep(1), print('later'))).start()\nprint('end')",
    "error in a thread": "import threading\ndef f():\n    1 / 0\nthreading.Thread(target=f, name='mine').start()",
    "stack": "import traceback, inspect\ndef f():\n    traceback.print_stack()\n    print(len(traceback.extract_stack()), inspect.currentframe().f_code)\nf()",
    "deep": "def f():\n    f()\ntry:\n    f()\nexcept RecursionError as error:\n    print(error)",
    "warns": "import warnings\nwarnings.warn('old', DeprecationWarning)\nprint('\\d')",
    "input": "print(input('name: '))\nprint(input())\ntry:\n    input()\nexcept EOFError as end:\n    print(repr(end))",
    "lines": "import sys\nprint([line for line in sys.stdin])",
    "open files": "file = open('left', 'w')\nfile.write('x')\nprint(open('left').read())",
    "other process": "import subprocess, sys\nprint(subprocess.run([sys.executable, '-c', 'import sys; print(sys.path[1:3], 1)'], capture_output=True))",
    "shell": "import os\nprint(os.system('echo $DAY6_TIME >/dev/null; exit 3'), os.popen('echo a').read())",
    "fork": "import os\npid = os.fork()\nif pid:\n    print(os.waitpid(pid, 0)[1])\nelse:\n    os._exit(7)",
    "pool": "import multiprocessing\ndef f(x):\n    return x * x\nif __name__ == '__main__':\n    with multiprocessing.Pool(2) as pool:\n        print(pool.map(f, [1, 2, 3]))",
    "spawn": "import multiprocessing\ndef f(x):\n    print(x, __name__, flush=True)\nif __name__ == '__main__':\n    p = multiprocessing.get_context('spawn').Process(target=f, args=(3,))\n    p.start(); p.join(); print(p.exitcode)",
    "pickle": "import pickle, dataclasses\n@dataclasses.dataclass\nclass A:\n    b: int\nprint(pickle.loads(pickle.dumps(A(1))), A.__module__)",
    "types": "import typing, enum\nclass E(enum.Enum):\n    A = 1\nclass B:\n    x: 'E'\nprint(typing.get_type_hints(B), E.A, repr(E))",
    "asyncio": "import asyncio\nasync def f():\n    await asyncio.sleep(1)\n    return asyncio.get_running_loop().__class__\nprint(asyncio.run(f()))",
    "logging": "import logging\nlogging.warning('w')\nlogging.info('i')\nlogging.basicConfig(level=logging.INFO)\nprint(logging.root.handlers, logging.getLogger('x').getEffectiveLevel())",
    "chance": "import os, random\nprint(len(os.urandom(4)), random.random() == random.random())",
    "same chance": "import random\nrandom.seed(1)\nprint(random.random(), random.sample(range(100), 5))",
    "sets": "print({'a', 'b', 'c', 'd', 'e'}, sorted(map(hash, 'abc')))",
    "arguments": "import argparse\np = argparse.ArgumentParser()\np.add_argument('x', type=int)\np.parse_args()",
    "annotations": "x: int = 1\nprint(__annotations__)",
    "future": "from __future__ import annotations\ndef f(x: nothing): ...\nprint(f.__annotations__)",
    "compiled": "eval(compile('1 / 0', 'there', 'eval'))",
    "unit test": "import unittest\nclass T(unittest.TestCase):\n    def test(self):\n        self.assertEqual(1, 1)\nunittest.main(verbosity=2, argv=['x'])",
    "node": """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Talker(Node):
    def __init__(self):
        super().__init__("talker")
        self.heard = []
        self.publisher = self.create_publisher(String, "chatter", 10)
        self.create_subscription(String, "chatter", lambda message: self.heard.append(message.data), 10)
        self.create_timer(0.5, lambda: self.publisher.publish(String(data=f"hello {len(self.heard)}")))
        self.declare_parameter("rate", 2)

rclpy.init()
node = Talker()
while len(node.heard) < 3:
    rclpy.spin_once(node)
print(node.heard, node.get_parameter("rate").value, node.get_fully_qualified_name())
node.destroy_node()
rclpy.shutdown()
""",
    "nodes left over": """
import rclpy
from rclpy.node import Node

class Left(Node):
    def __del__(self):
        print("gone", flush=True)

rclpy.init()
node = Left("left")
executor = rclpy.get_global_executor()
executor.add_node(Left("in_executor"))
rclpy.spin_once(node, timeout_sec=0.1)
""",
    "node fails": """
import rclpy
rclpy.init()
node = rclpy.create_node("fails")
node.create_timer(1.0, lambda: 1 / 0)
rclpy.spin(node)
""",
    "node interrupted": """
import os, signal
import rclpy
rclpy.init()
node = rclpy.create_node("waits")
node.create_timer(1.0, lambda: os.kill(os.getpid(), signal.SIGINT))
rclpy.spin(node)
""",
}
"""By what they are about."""

GIVEN: dict[str, dict[str, Any]] = {
    "input": {"stdin": "Ada\r\nsecond\n"},
    "lines": {"stdin": "a\r\nb\n\nc"},
    "unbuffered": {"variables": {"PYTHONUNBUFFERED": "1"}},
    "arguments": {"words": ["many", "--words"]},
    "system": {"words": ["a b", "é", ""]},
}
"""What some of them are given."""


def ways(folder: Path, *programs: dict[str, Any]) -> tuple[list[Any], list[Any], int]:
    """What programs do at first and then in new interpreters, and how many of the first were ready."""
    given = "\n".join([str(folder), *map(json.dumps, programs)])
    base = {"PATH": os.environ["PATH"], "LANG": "C.UTF-8", "PYTHONPATH": str(_REPOSITORY)}
    done = subprocess.run(
        forks.command("tests.virtual.readily"),
        env=forks.environment(base), input=given, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    first, second, begun = json.loads(done.stdout)
    return first, second, begun


def test_programs_do_the_same(tmp_path: Path) -> None:
    programs = []
    for number, (name, text) in enumerate(PROGRAMS.items()):
        script = f"program{number}.py"  # the name of no module
        (tmp_path / script).write_bytes(text.encode(errors="surrogateescape"))
        given = GIVEN.get(name, {})
        programs.append({**given, "words": [script, *given.get("words", ())]})
    (tmp_path / "folder").mkdir()
    text = "\n".join([PROGRAMS["main"], PROGRAMS["system"], "1 / 0", ""])
    (tmp_path / "folder" / "__main__.py").write_text(text, encoding="utf-8")
    programs.append({"words": ["folder", "word"]})
    first, second, begun = ways(tmp_path, *programs)
    assert begun == len(programs)
    assert len(first) == len(programs)
    different = {
        name: both
        for name, *both in zip(
            [*PROGRAMS, "folder"], map(_without_addresses, first), map(_without_addresses, second), strict=True
        )
        if both[0] != both[1]
    }
    assert not different


def _without_addresses(done: list[Any]) -> list[str]:
    return [re.sub("0x[0-9a-f]+", "0x", str(each)) for each in done]


NAMESAKES: dict[str, dict[str, Any]] = {
    "beside it": {"script": "near/program.py", "own": "near/random.py"},
    "beside it, a package": {"script": "near/program.py", "own": "near/random/__init__.py"},
    "on its path": {"script": "near/program.py", "own": "far/random.py", "variables": {"PYTHONPATH": "far"}},
}
"""Where programs have a module that has the name of one that is imported already."""


@pytest.mark.parametrize("name", NAMESAKES)
def test_a_program_with_a_namesake_gets_a_new_interpreter(tmp_path: Path, name: str) -> None:
    chosen = NAMESAKES[name]
    for path, text in ((chosen["script"], "import random\nprint(random.own)"), (chosen["own"], "own = 'mine'")):
        (tmp_path / path).parent.mkdir(exist_ok=True, parents=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    first, second, begun = ways(tmp_path, {"words": [chosen["script"]], "variables": chosen.get("variables", {})})
    assert first == second == [[0, "mine\n", ""]] and begun == 0


@pytest.mark.parametrize(
    "program",
    [
        {"words": ["-c", "print(1)"]},
        {"words": ["-u", "program.py"]},
        {"words": ["program.py"], "variables": {"PYTHONHASHSEED": "1"}},
        {"words": ["program.py"], "variables": {"PYTHONWARNINGS": "error"}},
        {"words": ["program.py"], "variables": {"LANG": "C"}},
    ],
)
def test_what_begins_otherwise_gets_a_new_interpreter(tmp_path: Path, program: dict[str, Any]) -> None:
    (tmp_path / "program.py").write_text("print(1)", encoding="utf-8")
    first, second, begun = ways(tmp_path, program)
    assert first == second == [[0, "1\n", ""]] and begun == 0


def test_a_program_that_is_not_there_is_missed_by_python_itself(tmp_path: Path) -> None:
    (first,), second, begun = ways(tmp_path, {"words": ["nothing.py"]})
    assert [first] == second and begun == 0
    assert (first[0], "can't open file" in first[2]) == (2, True)


def test_an_interpreter_that_was_killed_is_missed_by_nobody(tmp_path: Path) -> None:
    (tmp_path / "program.py").write_text("print(1)", encoding="utf-8")
    program = {"words": ["program.py"]}
    first, second, begun = ways(tmp_path, {**program, "kills": 2}, program, program)
    assert first == second == [[0, "1\n", ""]] * 3 and begun == 3
