"""Zenoh and our own engine side by side, in one run: `python -m tests.perf.link_engines [--rounds N]`.

Two processes of rclpy each time. Printed are the medians of the rounds, in which the engines take turns: what a message to
another process and back takes (Twist, an image of 1 MB), how many a second arrive of those that are sent without a pause, from
`import rclpy` to the first message, what the talker's process weighs (PSS), and the processor time of a talker and a listener at
50 Hz.
"""

from __future__ import annotations

import argparse
import os
import statistics
import subprocess
import sys
import tempfile
from collections import defaultdict
from collections.abc import Iterator

from day6_core.ros.environment import program_environment

ENGINES = ("on", "local", "tcp", "local-tcp")
"""Values of DAY6_LINK: Zenoh, ours, and both with TCP."""

SETTING = """
import sys, time
started, used = time.perf_counter(), time.process_time()
import rclpy
from geometry_msgs.msg import Twist
from sensor_msgs.msg import Image
rclpy.init()
node = rclpy.create_node(sys.argv[1])
Kind = {'twist': Twist, 'image': Image}[sys.argv[2]]
message = Image(data=bytes(1_000_000)) if Kind is Image else Twist()
def spin(until, seconds=30.0):
    end = time.monotonic() + seconds
    while not until() and time.monotonic() < end:
        rclpy.spin_once(node, timeout_sec=0.05)
"""
ECHO = (
    SETTING
    + """
back = node.create_publisher(Kind, 'back', 10)
node.create_subscription(Kind, 'there', back.publish, 10)
print('ready', flush=True)
rclpy.spin(node)
"""
)
ASK = (
    SETTING
    + """
got = []
node.create_subscription(Kind, 'back', lambda message: got.append(time.perf_counter()), 10)
there = node.create_publisher(Kind, 'there', 10)
spin(lambda: there.get_subscription_count() and node.count_publishers('back'))
while not got:  # the other one may not know this one's subscription yet
    there.publish(message)
    spin(lambda: got, 0.2)
spin(lambda: False, 0.5)
took = []
for number in range(520 if Kind is Twist else 70):
    sent, before = time.perf_counter(), len(got)
    there.publish(message)
    spin(lambda: len(got) > before)
    took.append(got[-1] - sent)
print(sorted(took[20:])[len(took[20:]) // 2] * 1e6)
"""
)
FLOOD = (
    SETTING
    + """
there = node.create_publisher(Kind, 'flood', 10)
spin(lambda: there.get_subscription_count())
count = 20_000 if Kind is Twist else 300
for number in range(count):
    there.publish(message)
time.sleep(0.3)
there.publish(Kind(data=b'end') if Kind is Image else Kind())
time.sleep(1.0)
"""
)
COUNT = (
    SETTING
    + """
times = []
subscription = node.create_subscription(Kind, 'flood', lambda message: times.append(time.perf_counter()), 30_000)
print('ready', flush=True)
count = 20_000 if Kind is Twist else 300
spin(lambda: len(times) > count or (times and time.perf_counter() - times[-1] > 3))
body = times[:count]
print(len(body) / (body[-1] - body[0]), len(times) - 1)
"""
)
FIRST = (
    SETTING
    + """
heard = []
node.create_subscription(Twist, 'steady', heard.append, 10)
spin(lambda: heard)
print((time.perf_counter() - started) * 1e3, (time.process_time() - used) * 1e3)
"""
)
STEADY = (
    SETTING
    + """
publisher = node.create_publisher(Twist, 'steady', 10)
node.create_timer(0.02, lambda: publisher.publish(message))
print('ready', flush=True)
spin(lambda: False, 2.0)
used = time.process_time()
spin(lambda: False, 6.0)
print((time.process_time() - used) / 6 * 100, flush=True)
pss = [int(line.split()[1]) for line in open('/proc/self/smaps_rollup') if line.startswith('Pss:')]
print(pss[0] / 1024 if pss else 0, flush=True)
rclpy.spin(node)
"""
)
HEAR = (
    SETTING
    + """
node.create_subscription(Twist, 'steady', lambda message: None, 10)
spin(lambda: False, 1.5)
used = time.process_time()
spin(lambda: False, 4.0)
print((time.process_time() - used) / 4 * 100)
"""
)


def measure(engine: str) -> Iterator[tuple[str, float]]:
    """Yield what was measured with one engine."""
    with tempfile.TemporaryDirectory(prefix="d6-") as folder:
        variables = {"DAY6_LINK": engine, "DAY6_RUNTIME_DIR": folder, "ROS_LOG_DIR": f"{folder}/log"}
        environment = {**program_environment(), **variables}

        def start(code: str, name: str, kind: str) -> subprocess.Popen[str]:
            command = [sys.executable, "-c", code, name, kind]
            return subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True)

        def numbers(code: str, name: str, kind: str) -> list[float]:
            return [float(word) for word in start(code, name, kind).communicate()[0].split()]

        for kind in ("twist", "image"):
            echo = start(ECHO, "echo", kind)
            _line(echo)
            yield f"{kind}, there and back, µs", numbers(ASK, "ask", kind)[0]
            echo.kill()
            echo.wait()
            count = start(COUNT, "count", kind)
            _line(count)
            numbers(FLOOD, "flood", kind)
            rate, arrived = map(float, count.communicate()[0].split())
            yield f"{kind}, a second", rate
            yield f"{kind}, arrived", arrived
        steady = start(STEADY, "steady", "twist")
        _line(steady)
        wall, used = numbers(FIRST, "first", "twist")
        yield "import rclpy to first message, ms", wall
        yield "import rclpy to first message, ms of the processor", used
        yield "listener at 50 Hz, % of a core", numbers(HEAR, "hear", "twist")[0]
        yield "talker at 50 Hz, % of a core", float(_line(steady))
        yield "talker, MB (PSS)", float(_line(steady))
        steady.kill()
        steady.wait()


def _line(process: subprocess.Popen[str]) -> str:
    assert process.stdout is not None
    return process.stdout.readline()


def main() -> None:
    """Measure, and print a table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--engines", nargs="*", default=ENGINES)
    options = parser.parse_args()
    found: defaultdict[str, defaultdict[str, list[float]]] = defaultdict(lambda: defaultdict(list))
    for _ in range(options.rounds):
        for engine in options.engines:
            for what, number in measure(engine):
                found[what][engine].append(number)
    print(f"{'':52}" + "".join(f"{engine:>12}" for engine in options.engines))
    for what, by_engine in found.items():
        cells = [statistics.median(by_engine[engine]) for engine in options.engines]
        print(f"{what:52}" + "".join(f"{cell:12.1f}" for cell in cells), flush=True)


if __name__ == "__main__":
    os.environ.pop("DAY6_LINK", None)
    main()
