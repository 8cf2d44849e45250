"""What a class on a network costs the teacher and each pupil: run by hand, `python -m tests.perf.class_network [PUPILS]`.

Each pupil is a process with a meeting place of its own and a graph with a driving turtle's traffic (poses at 62.5 Hz); the
teacher is one with a roster, and watches one pose topic. Printed: seconds until all are seen, CPU of the teacher and of a pupil
(share of one core), and after the teacher was killed and started again: seconds until all are seen, CPU of a pupil meanwhile.
"""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from tests.support.free_port import free_port

PUPIL = """
import sys, time
from day6_core.graph import Graph, QoS
from day6_core.interfaces import copy_message, get_message, type_hash
from day6_core.link import join
from day6_core.link.classroom.pupil import Pupil

graph, part = Graph(0), Pupil(sys.argv[1])
join(graph, connect=sys.argv[2], part=part, never_wait=True)
node = graph.create_node("turtlesim")
kind = get_message("turtlesim/msg/Pose")
pose = node.create_publisher("/turtle1/pose", "turtlesim/msg/Pose", type_hash(kind), QoS(), copy_message)
for name in ("/turtle1/cmd_vel", "/a", "/b", "/c"):
    twist = get_message("geometry_msgs/msg/Twist")
    node.create_subscription(name, "geometry_msgs/msg/Twist", type_hash(twist), QoS())
due, told = time.monotonic(), 0.0
while True:
    pose.publish(kind(x=due))
    if due - told > 0.5:
        part.tell(b'{"v": 1, "nodes": ["/turtlesim"]}')
        told = due
    due += 0.016
    time.sleep(max(0.0, due - time.monotonic()))
"""

TEACHER = """
import sys, time

begun = time.monotonic()
from day6_core.graph import Graph, QoS
from day6_core.interfaces import get_message, type_hash
from day6_core.link import join
from day6_core.link.classroom.teacher import Teacher

graph = Graph(0)
join(graph, listen=sys.argv[1], part=Teacher(), never_wait=True)
kind = get_message("turtlesim/msg/Pose")
graph.create_node("desk").create_subscription("/p0/turtle1/pose", "turtlesim/msg/Pose", type_hash(kind), QoS())
wanted = int(sys.argv[2])
while sum(node.name == "turtlesim" for node in graph.nodes) < wanted:
    time.sleep(0.02)
print(f"{time.monotonic() - begun:.2f}", flush=True)
time.sleep(3600)
"""


def cpu(pid: int) -> float:
    """Seconds of CPU of a process so far."""
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def start(code: str, runtime: Path, *words: str) -> subprocess.Popen[str]:
    environment = {**os.environ, "DAY6_RUNTIME_DIR": str(runtime), "DAY6_LINK": "on"}
    return subprocess.Popen([sys.executable, "-c", code, *words], env=environment, stdout=subprocess.PIPE, text=True)


def share(processes: list[subprocess.Popen[str]], seconds: float) -> float:
    """Share of a core that these took on average, in percent."""
    before = [cpu(each.pid) for each in processes]
    time.sleep(seconds)
    used = sum(cpu(each.pid) - start for each, start in zip(processes, before, strict=True))
    return 100 * used / seconds / len(processes)


def main() -> None:
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 30
    endpoint = f"tcp/127.0.0.1:{free_port()}"
    processes: list[subprocess.Popen[str]] = []
    with tempfile.TemporaryDirectory(prefix="d6c") as folder:
        try:
            pupils = [start(PUPIL, Path(folder) / f"p{n}", f"p{n}", endpoint) for n in range(count)]
            processes += pupils
            time.sleep(8.0)
            alone = share(pupils, 5.0)
            for round_ in ("first", "again, after kill -9"):
                teacher = start(TEACHER, Path(folder) / "t", endpoint, str(count))
                processes.append(teacher)
                assert teacher.stdout is not None
                seen = teacher.stdout.readline().strip()
                time.sleep(2.0)
                print(f"{round_}: all {count} seen after {seen} s")
                print(f"  teacher {share([teacher], 5.0):.1f} %, a pupil {share(pupils, 5.0):.1f} % of a core")
                teacher.kill()
                teacher.wait()
                print(f"  without a teacher a pupil {share(pupils, 5.0):.1f} % (before the first one {alone:.1f} %)")
        finally:
            for each in processes:
                with contextlib.suppress(ProcessLookupError):
                    each.kill()
                each.wait()


if __name__ == "__main__":
    main()
