"""Ends processes while messages pour in, with several Pythons: `python -m tests.perf.link_ends [--times N] [PYTHON…]`.

A thread of Zenoh that has called Python a hundred times keeps its thread state (`day6_core/link/engine_thread.py`), and has to
give way when the interpreter ends. A flooding talker and a listener are two processes; the listener ends by itself, by SIGINT,
by SIGTERM or by an exception, in turn, after it has heard some thousand messages, and the machine is busy with as many endless
loops as it has processors. Each PYTHON (by default this one) needs day6-tui. A listener that crashes, hangs for 20 s or says
anything on its standard error but what belongs to its end is printed; the status is then 1.
"""

from __future__ import annotations

import argparse
import os
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter

from day6_core.ros.environment import program_environment
from tests.perf.runs import loops

TALKER = """
import rclpy
from std_msgs.msg import String
rclpy.init()
node = rclpy.create_node('talker')
publisher = node.create_publisher(String, 'flood', 10)
message = String(data='x' * 100)
node.create_timer(0.0002, lambda: publisher.publish(message))
rclpy.spin(node)
"""
LISTENER = """
import sys, rclpy
from std_msgs.msg import String
rclpy.init()
node = rclpy.create_node('listener')
heard = 0
def hear(message):
    global heard
    heard += 1
    if heard == 2000:
        print('enough', flush=True)
        if sys.argv[1] == 'itself':
            raise SystemExit(0)
        if sys.argv[1] == 'exception':
            raise RuntimeError('enough')
node.create_subscription(String, 'flood', hear, 10)
try:
    rclpy.spin(node)
except (KeyboardInterrupt, rclpy.executors.ExternalShutdownException):
    pass
"""
WAYS = {"itself": 0, "SIGINT": 0, "SIGTERM": 0, "exception": 1}
"""How a listener ends, and its status then."""
PATIENCE = 20.0


def end_once(python: str, environment: dict[str, str], way: str) -> str:
    """Start a listener and end it; returns what was wrong, or ''."""
    listener = subprocess.Popen(
        [python, "-c", LISTENER, way],
        env=environment,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert listener.stdout is not None
    if listener.stdout.readline() != "enough\n":
        listener.kill()
        return "heard nothing: " + listener.communicate()[1][-300:]
    if way.startswith("SIG"):
        listener.send_signal(getattr(signal, way))
    began = time.monotonic()
    try:
        _, errors = listener.communicate(timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        listener.kill()
        return f"hangs after {way}"
    expected = "RuntimeError: enough\n" if way == "exception" else ""
    if listener.returncode != WAYS[way] or (errors != expected if not expected else not errors.endswith(expected)):
        return f"{way}: status {listener.returncode} after {time.monotonic() - began:.1f} s, {errors[-300:]!r}"
    return ""


def main() -> int:
    """Try each Python and print a line for it."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--times", type=int, default=20, metavar="N", help="ends in each way (default: 20)")
    parser.add_argument("pythons", nargs="*", metavar="PYTHON", default=[sys.executable])
    chosen = parser.parse_args()
    good = True
    with loops(os.cpu_count() or 1):
        for python in chosen.pythons:
            with tempfile.TemporaryDirectory(prefix="d6-") as folder:
                environment = {**program_environment(), "DAY6_LINK": "on", "DAY6_RUNTIME_DIR": f"{folder}/r"}
                talker = subprocess.Popen([python, "-c", TALKER], env=environment, stdin=subprocess.DEVNULL)
                try:
                    problems = [end_once(python, environment, way) for _ in range(chosen.times) for way in WAYS]
                finally:
                    talker.kill()
                    talker.wait()
            version = subprocess.run([python, "-V"], capture_output=True, text=True).stdout.strip()
            wrong = Counter(filter(None, problems))
            print(f"{version}: {len(problems) - wrong.total()} of {len(problems)} ends were clean", flush=True)
            for problem, count in wrong.items():
                print(f"   {count} x {problem}", flush=True)
            good = good and not wrong
    return 0 if good else 1


if __name__ == "__main__":
    raise SystemExit(main())
