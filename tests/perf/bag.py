"""Measures rqt_bag on a large bag: how long it takes to open and index it, its memory, and how soon a jump is answered.

    python -m tests.perf.bag [--gigabytes 1] [--storage mcap|sqlite3] [--preset PRESET] [--small] [--jumps N] [--keep FOLDER]

The bag has images, laser scans and small messages (`--small`: only those, of 100 bytes). A jump is answered when the newest
message of every topic has come to a subscription on the same graph. The file's pages are dropped from the cache before the bag
is opened, and once more before every tenth jump ("cold"), where the system lets us.
"""

from __future__ import annotations

import argparse
import os
import random
import resource
import shutil
import statistics
import tempfile
import time
from pathlib import Path
from typing import Any

from day6_core.ros.environment import activate

activate()

import rosbag2_py  # noqa: E402 - on the path only now
from geometry_msgs.msg import Twist  # noqa: E402
from sensor_msgs.msg import Image, LaserScan  # noqa: E402
from std_msgs.msg import String  # noqa: E402

from day6_core.session.clock import WorldClock  # noqa: E402
from rclpy.serialization import serialize_message  # noqa: E402
from tests.support.stepped_machine import SteppedMachine  # noqa: E402

SECOND = 1_000_000_000
START = 1_700_000_000 * SECOND


def make_bag(folder: Path, size: int, storage: str, preset: str, *, small: bool) -> int:
    """Write a bag of about `size` bytes; returns the number of its messages."""
    noise = random.Random(5).randbytes(640 * 480 * 3)
    # Topic -> messages per second, type, content.
    content: dict[str, tuple[int, str, bytes]] = {
        "/cmd_vel": (200 if small else 20, "geometry_msgs/msg/Twist", serialize_message(Twist())),
        "/word": (1800 if small else 180, "std_msgs/msg/String", serialize_message(String(data="x" * 80))),
    }
    if not small:
        image = Image(width=640, height=480, encoding="rgb8", step=1920, data=noise)
        content["/image"] = (10, "sensor_msgs/msg/Image", serialize_message(image))
        scan = LaserScan(ranges=[1.0] * 1000)
        content["/scan"] = (40, "sensor_msgs/msg/LaserScan", serialize_message(scan))
    writer = rosbag2_py.SequentialWriter()
    writer.open(rosbag2_py.StorageOptions(str(folder), storage_id=storage, storage_preset_profile=preset))
    for id_, (topic, (_, kind, _)) in enumerate(content.items()):
        writer.create_topic(rosbag2_py.TopicMetadata(id_, topic, kind, "cdr", [rosbag2_py.QoS(10)]))
    latched = rosbag2_py.QoS(1).transient_local()
    writer.create_topic(rosbag2_py.TopicMetadata(9, "/static", "std_msgs/msg/String", "cdr", [latched]))
    writer.write("/static", serialize_message(String(data="once")), START)
    written, count, second = 0, 1, 0
    while written < size:
        for at, topic in sorted(
            (tick * SECOND // rate, topic) for topic, (rate, _, _) in content.items() for tick in range(rate)
        ):
            writer.write(topic, content[topic][2], START + second * SECOND + at)
            written += len(content[topic][2])
            count += 1
        second += 1
    writer.close()
    return count


def forget(folder: Path) -> None:
    """Drop the pages of the files from the system's cache."""
    for path in folder.iterdir():
        with path.open("rb") as file:
            os.fsync(file.fileno())
            os.posix_fadvise(file.fileno(), 0, 0, os.POSIX_FADV_DONTNEED)


def memory() -> float:
    """Resident megabytes now."""
    return int(Path("/proc/self/statm").read_text().split()[1]) * resource.getpagesize() / 1e6


def measure(folder: Path, jumps: int) -> None:
    machine = SteppedMachine(WorldClock())
    forget(folder)
    before, began = memory(), time.monotonic()
    machine.start("rqt_bag", "rqt_bag", str(folder), screen=True)
    model: Any = machine.display.windows[-1].model
    run = machine.scheduler.run
    run(lambda: model.topics, 60)
    shown = time.monotonic() - began
    run(lambda: not model.loading and bool(model.bags), 600)
    print(f"topics shown after {shown * 1000:.0f} ms, indexed after {time.monotonic() - began:.2f} s")
    print(f"memory {before:.0f} MB before, {memory():.0f} MB indexed, {model.timeline.blocks} blocks")
    heard: dict[str, int] = {}
    model.publish_all(True)
    run(lambda: len(model.player.publishing) == len(model.topics), 10)
    took: dict[str, list[float]] = {"warm": [], "cold": []}
    start, end = model.timeline.start_ns, model.timeline.end_ns
    pick = random.Random(1)
    for topic, kind_name in model.topics.items():
        from day6_core.interfaces import get_interface

        machine.node.create_subscription(
            get_interface(kind_name), topic, lambda data, topic=topic: heard.__setitem__(topic, heard.get(topic, 0) + 1),
            10, raw=True,
        )  # fmt: skip
    moving = [topic for topic in model.topics if topic != "/static"]
    for number in range(jumps):
        cold = number % 10 == 9
        if cold:
            forget(folder)
        at = pick.randrange(start + 2 * SECOND, end)
        heard.clear()
        began = time.monotonic()
        model.request(lambda at=at: model.player.jump(at))
        run(lambda: all(topic in heard for topic in moving), 20)
        took["cold" if cold else "warm"].append(1000 * (time.monotonic() - began))
    for kind_name, values in took.items():
        values.sort()
        print(
            f"jump, {kind_name}: p50 {statistics.median(values):.1f} ms, p95 {values[int(len(values) * 0.95)]:.1f} ms, "
            f"max {values[-1]:.1f} ms ({len(values)})"
        )
    print(f"memory {memory():.0f} MB after the jumps")
    machine.end()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--gigabytes", type=float, default=1.0)
    parser.add_argument("--storage", default="mcap", choices=("mcap", "sqlite3"))
    parser.add_argument("--preset", default="")
    parser.add_argument("--small", action="store_true")
    parser.add_argument("--jumps", type=int, default=300)
    parser.add_argument("--keep", type=Path, help="where the bag is made, and used again if it is there")
    args = parser.parse_args()
    base = args.keep or Path(tempfile.mkdtemp(prefix="day6-bag-"))
    folder = base / f"{args.storage}{args.preset}{'_small' if args.small else ''}_{args.gigabytes:g}"
    try:
        if not folder.exists():
            base.mkdir(parents=True, exist_ok=True)
            began = time.monotonic()
            count = make_bag(folder, round(args.gigabytes * 1e9), args.storage, args.preset, small=args.small)
            print(f"{count} messages written in {time.monotonic() - began:.0f} s")
        print(f"{folder.name}: {sum(path.stat().st_size for path in folder.iterdir()) / 1e9:.2f} GB")
        measure(folder, args.jumps)
    finally:
        if args.keep is None:
            shutil.rmtree(base, ignore_errors=True)


if __name__ == "__main__":
    main()
