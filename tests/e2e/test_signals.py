"""Ctrl-C and kill as real rclpy treats them: every program was run on real rclpy 9.1.2, with the result beside it.

With DAY6_REAL_PYTHON naming an interpreter that has real rclpy, they are run on that instead.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

import pytest

from day6_core.ros.environment import program_environment
from tests.e2e.place import Place
from tests.e2e.waits import READY
from tests.support.waiting import communicate

pytestmark = [pytest.mark.person, pytest.mark.skipif(os.name != "posix", reason="the signals of Unix")]

START = (
    """\
import atexit, os, signal, sys, threading, time
import rclpy
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.signals import SignalHandlerOptions
from std_msgs.msg import String
from std_srvs.srv import Empty

def say(*words):
    print(*words, flush=True)

"""
    + READY
)
NODE = "rclpy.init(); n = Node('n')\n"
SPIN = "ready()\nrclpy.spin(n)\n"
CATCH = "except BaseException as e: say(type(e).__name__, rclpy.ok())\n"


class Case(NamedTuple):
    """A program, the signals it gets, each when it is `ready()` for it, and how it ends."""

    code: str
    signals: tuple[str, ...]
    status: int
    said: tuple[str, ...] = ()
    error: str = ""
    """The last line of what it wrote to stderr."""


KI, ESE = "KeyboardInterrupt", "rclpy.executors.ExternalShutdownException"
INVALID = "rclpy._rclpy_pybind11.RCLError: {}'s context is invalid, at "
CASES = {
    "spin": Case(NODE + SPIN, ("INT",), -2, error=KI),
    "spin, SIGTERM": Case(NODE + SPIN, ("TERM",), 1, error=ESE),
    "spin with a timer": Case(NODE + "n.create_timer(0.2, lambda: None)\n" + SPIN, ("INT",), -2, error=KI),
    "inside a callback": Case(
        NODE + "def f():\n    ready()\n    time.sleep(1000)\nn.create_timer(0.1, f)\nrclpy.spin(n)\n",
        ("INT",), -2, error=KI,
    ),
    "caught": Case(
        NODE + "ready()\ntry: rclpy.spin(n)\nexcept KeyboardInterrupt: say(rclpy.ok())\n"
        "n.destroy_node()\nrclpy.try_shutdown()\nsay('end')\n",
        ("INT",), 0, ("False", "end"),
    ),
    "caught, then shutdown": Case(
        NODE + "ready()\ntry: rclpy.spin(n)\nexcept KeyboardInterrupt: pass\n"
        "finally:\n    n.destroy_node()\n    rclpy.shutdown()\nsay('end')\n",
        ("INT",), 0, ("end",),
    ),
    "caught, SIGTERM": Case(
        NODE + f"ready()\ntry: rclpy.spin(n)\n{CATCH}", ("TERM",), 0, ("ExternalShutdownException False",)
    ),
    "with rclpy.init()": Case(
        "with rclpy.init():\n    n = Node('n')\n    ready()\n    rclpy.spin(n)\n", ("INT",), -2, error=KI
    ),
    "spin_once in a loop": Case(
        NODE + "ready()\nwhile rclpy.ok(): rclpy.spin_once(n, timeout_sec=0.1)\n", ("INT",), -2, error=KI
    ),
    "spin_once in a loop, SIGTERM": Case(
        NODE + "ready()\nwhile rclpy.ok(): rclpy.spin_once(n)\n", ("TERM",), 1, error=ESE
    ),
    "no spin at all": Case(NODE + "ready()\ntime.sleep(1000)\n", ("INT",), -2, error=KI),
    "no spin at all, SIGTERM": Case(
        NODE + "ready()\nsys.stdin.readline()\nsay(rclpy.ok())\n", ("TERM",), 0, ("False",)
    ),
    "publishing while ok, SIGTERM": Case(
        NODE + "p = n.create_publisher(String, 't', 10)\nready()\n"
        "while rclpy.ok():\n    p.publish(String(data='x'))\n    time.sleep(0.05)\nsay('left')\n",
        ("TERM",), 0, ("left",),
    ),
    "publishing afterwards": Case(
        NODE + "p = n.create_publisher(String, 't', 10)\nready()\ntry: rclpy.spin(n)\n"
        "except KeyboardInterrupt: p.publish(String(data='stop'))\n",
        ("INT",), 1, error=INVALID.format("Failed to publish: publisher"),
    ),
    "MultiThreadedExecutor": Case(
        NODE + "e = MultiThreadedExecutor(); e.add_node(n)\nready()\ne.spin()\n", ("INT",), -2, error=KI
    ),
    "SingleThreadedExecutor, SIGTERM": Case(
        NODE + "e = SingleThreadedExecutor(); e.add_node(n)\nready()\ne.spin()\n", ("TERM",), 1, error=ESE
    ),
    "waiting for a service": Case(
        NODE + "c = n.create_client(Empty, 'nope')\nready()\nwhile not c.wait_for_service(1.0): pass\n",
        ("INT",), -2, error=KI,
    ),
    "waiting for a service, SIGTERM": Case(
        NODE + "c = n.create_client(Empty, 'nope')\nready()\nwhile not c.wait_for_service(0.2): pass\n",
        ("TERM",), 1, error=INVALID.format("failed to check service availability: rcl node"),
    ),
    "waiting for a future": Case(
        NODE + "ready()\nrclpy.spin_until_future_complete(n, rclpy.task.Future())\n", ("INT",), -2, error=KI
    ),
    "without handlers, SIGTERM": Case(
        "rclpy.init(signal_handler_options=SignalHandlerOptions.NO)\nn = Node('n')\n" + SPIN, ("TERM",), -15
    ),
    "an own handler from before": Case(
        "signal.signal(signal.SIGINT, lambda number, frame: say('mine'))\n" + NODE
        + f"ready()\ntry: rclpy.spin(n)\n{CATCH}",
        ("INT",), 0, ("mine", "ExternalShutdownException False"),
    ),
    "SIGINT ignored from the start": Case(
        "#ignore\n" + NODE + f"ready()\ntry: rclpy.spin(n)\n{CATCH}",
        ("INT",), 0, ("ExternalShutdownException False",),
    ),
    "twice": Case(
        NODE + "ready()\ntry: rclpy.spin(n)\nexcept KeyboardInterrupt:\n    say('first')\n"
        "    try: ready(); time.sleep(1000)\n    except KeyboardInterrupt: say('second')\n",
        ("INT", "INT"), 0, ("first", "second"),
    ),
    "atexit": Case("atexit.register(say, 'at exit')\n" + NODE + SPIN, ("INT",), -2, ("at exit",), KI),
    "SIGHUP": Case(NODE + SPIN, ("HUP",), -1),
    "sys.exit in a callback": Case(NODE + "n.create_timer(0.1, lambda: sys.exit(3))\n" + SPIN, (), 3),
    "an error in a callback": Case(
        NODE + "n.create_timer(0.1, lambda: 1 / 0)\n" + SPIN, (), 1, error="ZeroDivisionError: division by zero"
    ),
    "shutdown in a callback": Case(
        NODE + "n.create_timer(0.1, rclpy.shutdown)\n" + SPIN + "say('end')\n", (), 0, ("end",)
    ),
}  # fmt: skip

REAL = os.environ.get("DAY6_REAL_PYTHON")


@pytest.fixture(scope="module")
def outcomes(tmp_path_factory: pytest.TempPathFactory) -> Iterator[dict[str, Future[tuple[int, list[str], str]]]]:
    """All of them at once: they mostly wait."""
    place = Place(tmp_path_factory.mktemp("signals"))
    # Here and not in the threads: pytest changes os.environ before and after every test.
    env = {name: value for name, value in {**os.environ, **place.environment()}.items() if value is not None}
    with ThreadPoolExecutor(4) as pool:
        yield {name: pool.submit(_run, place, env, number, case) for number, (name, case) in enumerate(CASES.items())}
    place.close()


@pytest.mark.parametrize("name", CASES)
def test_a_signal_ends_a_program_as_on_real_rclpy(name: str, outcomes: dict[str, Future[object]]) -> None:
    case = CASES[name]
    status, said, error = outcomes[name].result()  # type: ignore[misc]
    assert (status, tuple(said)) == (case.status, case.said), error
    assert error.startswith(case.error) if case.error else not error


THREADS = (
    NODE
    + r"""n.create_publisher(String, 't', 10).publish(String())
n.create_subscription(String, 't', print, 10)
n.create_client(Empty, 'nope').wait_for_service(0.5)
for number in os.listdir('/proc/self/task'):
    with open(f'/proc/self/task/{number}/status') as file:
        blocked = int(next(line for line in file if line.startswith('SigBlk'))[7:], 16)
    names = [name for name in ('SIGINT', 'SIGTERM', 'SIGALRM', 'SIGSEGV') if blocked >> getattr(signal, name) - 1 & 1]
    say('main' if int(number) == os.getpid() else 'other', *names)
"""
)


@pytest.mark.skipif(sys.platform != "linux" or REAL is not None, reason="what Linux says of threads of ours")
def test_no_thread_of_the_link_takes_a_signal_from_the_main_thread(tmp_path: Path) -> None:
    place = Place(tmp_path)
    env = {name: value for name, value in {**os.environ, **place.environment()}.items() if value is not None}
    status, said, error = _run(place, env, 0, Case(THREADS, (), 0))
    place.close()
    assert status == 0, error
    others = [line for line in said if line != "main"]
    assert len(others) > 3 and set(others) == {"other SIGINT SIGTERM SIGALRM"}


def _run(place: Place, env: dict[str, str], number: int, case: Case) -> tuple[int, list[str], str]:
    file = place.file(f"case{number}.py", START + case.code)
    handler = signal.SIG_IGN if "#ignore" in case.code else signal.SIG_DFL
    process = subprocess.Popen(
        [REAL or sys.executable, str(file)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env={**env, "ROS_DOMAIN_ID": "93"} if REAL else program_environment(env),
        preexec_fn=lambda: signal.signal(signal.SIGINT, handler),
        encoding="utf-8",
    )
    assert process.stdout is not None
    said = []
    for name in case.signals:
        while (line := process.stdout.readline()) not in ("", "ready\n"):
            said.append(line.rstrip())
        process.send_signal(getattr(signal, f"SIG{name}"))
    out, error = communicate(process)  # closes its standard input
    said = [line for line in said + out.splitlines() if line != "ready"]
    return process.returncode, said, error.strip().rpartition("\n")[2]
