"""Measures how costs grow with nodes, topics, processes, windows, lines, frames and markers. One table.

    python -m tests.perf.scale [--only CASE …] [--rounds 3] [--profile CASE SIZE]

Each case is played with several sizes, each in a process of its own. Printed are the CPU time of one item at each size, and how
that grows from the last size but one to the last: linear is 1.0, and up to 1.3 is kept. What costs next to nothing as a whole
(below 2 ms) isn't judged. The least of several rounds counts. Status 1 if something grows faster. Linux only.

`--profile CASE SIZE` prints where the time of one goes.
"""

from __future__ import annotations

import argparse
import asyncio
import gc
import json
import os
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Awaitable, Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from types import SimpleNamespace
from typing import Any

from day6_core.ros.environment import program_environment
from tests.perf.hostile_machine import cpu

SIZES = (10, 100, 1000)
MOST_GROWTH = 1.3
TOO_LITTLE = 0.002
"""Seconds of CPU that say nothing."""

TALKER = """
import sys
import rclpy
from std_msgs.msg import String
rclpy.init()
name, topics = sys.argv[1], int(sys.argv[2])
node = rclpy.create_node(f'scale_{name}')
publishers = [node.create_publisher(String, f'scale_{name}_{number}', 10) for number in range(topics)]
print(flush=True)
rclpy.spin(node)
"""


class Steps:
    """The steps of a case, of each the seconds of CPU (of this process and its children that ended) and of wall time."""

    def __init__(self) -> None:
        self.found: dict[str, tuple[float, float]] = {}

    @contextmanager
    def __call__(self, what: str, times: int = 1) -> Iterator[None]:
        """Measure a step that does the same so many times."""
        gc.collect()
        gc.freeze()  # What the steps before have left isn't looked through in this one.
        cpu, wall = cpu_seconds(), time.perf_counter()
        yield
        self.found[what] = (cpu_seconds() - cpu) / times, (time.perf_counter() - wall) / times


def cpu_seconds() -> float:
    ended = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.process_time() + ended.ru_utime + ended.ru_stime


# -- the graph ---------------------------------------------------------------------------------------------------------


def nodes(size: int, step: Steps) -> None:
    """Nodes of one process."""
    from std_msgs.msg import String

    import rclpy
    from rclpy.executors import SingleThreadedExecutor

    rclpy.init()
    executor = SingleThreadedExecutor()
    got: list[Any] = []
    with step("nodes of one process: made"):
        made = [rclpy.create_node(f"scale_{number}") for number in range(size)]
    with step("  listed", 10):
        for _ in range(10):
            made[0].get_node_names_and_namespaces()
    for node in made:
        node.create_subscription(String, f"{node.get_name()}/in", got.append, 10)
    publishers = [made[0].create_publisher(String, f"{node.get_name()}/in", 10) for node in made]
    with step("  added to an executor"):
        for node in made:
            executor.add_node(node)
        executor.spin_once(timeout_sec=0)
    with step("  a message to each, spun"):
        for publisher in publishers:
            publisher.publish(String(data="x"))
        while len(got) < size:
            executor.spin_once(timeout_sec=0)
    with step("  a thousand messages to one of them*"):
        for number in range(1000):
            publishers[0].publish(String(data="x"))
            while len(got) <= size + number:
                executor.spin_once(timeout_sec=0)
    executor.shutdown()
    with step("  destroyed"):
        for node in made:
            node.destroy_node()


def topics(size: int, step: Steps) -> None:
    """Topics of one node, each with a publisher and a subscription; who looks at all of them."""
    from std_msgs.msg import String

    import rclpy
    from day6_core.graph.graph import graph_for_domain
    from day6_core.ros.programs.rqt_graph.model.drawing import UNICODE, draw
    from day6_core.ros.programs.rqt_graph.model.fit import fitted
    from day6_core.ros.programs.rqt_graph.model.rqt_graph import RqtGraph
    from day6_core.ros.programs.rqt_topic.model import TopicMonitor

    rclpy.init()
    node = rclpy.create_node("scale")
    far = rclpy.create_node("far")
    with step("topics: a publisher and a subscription made"):
        publishers = [node.create_publisher(String, f"topic_{number}", 10) for number in range(size)]
        subscriptions = [far.create_subscription(String, f"topic_{number}", print, 10) for number in range(size)]
    with step("  names and types", 10):
        for _ in range(10):
            node.get_topic_names_and_types()
    with step("  information of each"):
        for number in range(size):
            node.get_publishers_info_by_topic(f"/topic_{number}")
    monitor = TopicMonitor(node, time.time_ns)
    with step("  rqt_topic: read", 3):
        for _ in range(3):
            monitor.refresh()
    model = RqtGraph(node, graph_for_domain(0), Path)
    with step("  rqt_graph: read"):
        model.refresh()
    with step("  rqt_graph: laid out and drawn"):
        draw(fitted(model.content.boxes, model.content.edges, 120, 40), UNICODE).rows()
    with step("  destroyed"):
        for publisher, subscription in zip(publishers, subscriptions, strict=True):
            node.destroy_publisher(publisher)
            far.destroy_subscription(subscription)


def chain(size: int, step: Steps) -> None:
    """A graph as a robot has it: each node hears its neighbours."""
    from day6_core.ros.programs.rqt_graph.model.content import GraphContent, GraphOptions, select
    from day6_core.ros.programs.rqt_graph.model.drawing import UNICODE, draw
    from day6_core.ros.programs.rqt_graph.model.fit import fitted

    facts = GraphContent(
        {f"/topic_{n}": (f"/node_{n}",) for n in range(size)},
        {f"/topic_{n}": tuple(f"/node_{m}" for m in (n + 1, n + 3) if m < size) for n in range(size)},
    )
    with step("rqt_graph, nodes in a chain: chosen"):
        content = select(facts, GraphOptions())
    with step("  laid out and drawn"):
        draw(fitted(content.boxes, content.edges, 120, 40), UNICODE).rows()


def fan_out(size: int, step: Steps) -> None:
    """One topic with many subscriptions."""
    from std_msgs.msg import String

    import rclpy
    from rclpy.executors import SingleThreadedExecutor

    rclpy.init()
    node, executor = rclpy.create_node("scale"), SingleThreadedExecutor()
    executor.add_node(node)
    got: list[Any] = []
    publisher = node.create_publisher(String, "topic", 10)
    with step("subscriptions of one topic: made"):
        ends = [node.create_subscription(String, "topic", got.append, 10) for _ in range(size)]
    with step("  a message to all of them", 5):
        for number in range(5):
            publisher.publish(String(data="x"))
            while len(got) < size * (number + 1):
                executor.spin_once(timeout_sec=0)
    with step("  destroyed"):
        for end in ends:
            node.destroy_subscription(end)


class Linked:
    """Programs on the link, in processes of their own."""

    def __init__(self) -> None:
        self._folder = tempfile.TemporaryDirectory(prefix="d6-")
        self.env = program_environment({**os.environ, "DAY6_LINK": "on", "DAY6_RUNTIME_DIR": self._folder.name})
        self.running: list[subprocess.Popen[bytes]] = []

    def __enter__(self) -> Linked:
        return self

    def __exit__(self, *_: object) -> None:
        for each in self.running:
            each.kill()
            each.wait()
        self._folder.cleanup()

    def start(self, name: str, topics: int = 1) -> None:
        """Start one, and wait until it spins."""
        command = [sys.executable, "-c", TALKER, name, str(topics)]
        self.running.append(subprocess.Popen(command, stdout=subprocess.PIPE, env=self.env))
        assert self.running[-1].stdout is not None
        self.running[-1].stdout.readline()

    def cpu(self) -> float:
        """Seconds that all of them have used so far."""
        return sum(cpu(each.pid) for each in self.running)

    def ros2(self, *words: str) -> str:
        """Run a command of `ros2`, which prints."""
        command = [sys.executable, "-m", "day6_tui.main", "ros2", *words]
        return subprocess.run(command, stdout=subprocess.PIPE, env=self.env, encoding="utf-8", check=True).stdout


def processes(size: int, step: Steps) -> None:
    """Programs on the link."""
    with Linked() as linked:
        with step("processes: started one after the other, until all spin"):
            for number in range(size):
                linked.start(str(number))
        for verb in ("node", "topic"):
            with step(f"  ros2 {verb} list"):
                seen = linked.ros2(verb, "list").count("scale_")
            assert seen == size, f"{seen} of {size} seen"
        spent = linked.cpu()
        # Each knows all others, so that what each costs is what grows with their number.
        step.found["  CPU of each until here"] = spent / size, spent / size
        time.sleep(5)
        later = linked.cpu()
        step.found["  CPU of all in 5 s in which nothing happens"] = later - spent, later - spent


def linked_topics(size: int, step: Steps) -> None:
    """Topics of a program on the link."""
    with Linked() as linked:
        linked.start("near", 1)
        linked.start("far", size)
        for words in (("topic", "list"), ("topic", "info", "-v", "/scale_far_0"), ("node", "info", "/scale_far")):
            with step(f"topics on the link: ros2 {' '.join(words)}"):
                printed = linked.ros2(*words)
            assert "far" in printed
        assert linked.ros2("topic", "list").count("scale_far") == size


# -- windows -----------------------------------------------------------------------------------------------------------


def shown(kind: str, model: Any, keys: Callable[[Any], Awaitable[None]]) -> None:
    """Open a window on a stepped desktop of 120x40."""
    from tests.tui.screens import ToolWindow, use_window

    use_window((kind, kind, model), keys, (120, 40), ToolWindow)


def console(size: int, step: Steps) -> None:
    """Log messages in rqt_console, ten for each item."""
    from day6_core.ros.programs.rqt_console.model import Console
    from tests.tui.screens import step as frame

    model, count = Console(), 10 * size
    stamp = SimpleNamespace(sec=5, nanosec=0)
    logs = [
        SimpleNamespace(stamp=stamp, level=20, name=f"n{n % 7}", msg=f"Hello {n}", file="t.py", function="f", line=n)
        for n in range(count)
    ]
    with step("rqt_console, ten messages each: received"):
        for log in logs:
            model.receive(log)
    with step("  looked through"):
        model.shown()
        while model.is_behind:
            model.shown()

    async def act(tool: Any) -> None:
        with step("  20 messages and frames more*"):
            for log in logs[:20]:
                model.receive(log)
                await frame(tool.app, tool.pilot)
        with step("  20 keys up*"):
            await tool.press(*["up"] * 20)

    shown("rqt_console", model, act)


def rqt_topic(size: int, step: Steps) -> None:
    """Topics in the window of the topic monitor."""
    from day6_core.ros.programs.rqt_topic.model import MonitoredEndpoint, Topic

    ends = (MonitoredEndpoint("/talker", "RELIABLE VOLATILE KEEP_LAST (10)"),)
    model = SimpleNamespace(
        version=1,
        topics=tuple(Topic(f"/topic_{n}", ("std_msgs/msg/String",), ends, ()) for n in range(size)),
        last_message=lambda _: None,
        toggle=lambda _: None,
    )

    async def act(tool: Any) -> None:
        with step("rqt_topic: 20 keys down*"):
            await tool.press(*["down"] * 20)
        with step("  20 changes*"):
            for _ in range(20):
                model.version += 1
                await tool.press("down")

    shown("rqt_topic", model, act)


def editor(size: int, step: Steps) -> None:
    """A file in the editor, ten lines for each item."""
    from tests.tui.fakes import FakeDesk
    from tests.tui.screens import opened
    from tests.tui.screens import step as frame

    async def act(folder: Path) -> None:
        from day6_core.shell.editing.model import Editor

        path = folder / "long.py"
        path.write_text("".join(f"value_{n} = {{'name': {n}}}  # line {n}\n" for n in range(10 * size)))
        desk = FakeDesk()
        model = Editor(folder, folder / "state", "nano")
        with step("editor, ten lines each: read"):
            model.open(path)
        desk.display.open("editor", "nano", model)
        with step("  window opened"):
            async with opened(desk, 120, 40, scene="empty", lang="en") as (app, pilot):
                await frame(app, pilot)
                app.desktop.focus_pane(app.query_one("EditorPane"))
                await frame(app, pilot)
                with step("  20 letters typed at the top*"):
                    for _ in range(20):
                        await pilot.press("x")
                        await frame(app, pilot)
                with step("  to the end*"):
                    app.query_one("EditorPane").area.move_cursor((10 * size, 0))
                    await frame(app, pilot)
                with step("  20 letters typed at the end*"):
                    for _ in range(20):
                        await pilot.press("x")
                        await frame(app, pilot)

    with tempfile.TemporaryDirectory() as folder:
        asyncio.run(act(Path(folder)))


def windows(size: int, step: Steps) -> None:
    """Windows on one desktop of 200x60."""
    from day6_core.ros.programs.rqt_topic.model import MonitoredEndpoint, Topic
    from tests.tui.fakes import FakeDesk
    from tests.tui.screens import opened
    from tests.tui.screens import step as frame

    topic = Topic("/a", ("std_msgs/msg/String",), (MonitoredEndpoint("/talker", "RELIABLE"),), ())
    models = [
        SimpleNamespace(version=1, topics=(topic,), last_message=lambda _: None, toggle=lambda _: None)
        for _ in range(size)
    ]

    async def act() -> None:
        desk = FakeDesk()
        async with opened(desk, 200, 60, scene="empty", lang="en") as (app, pilot):
            for model in models[:-5]:
                desk.display.open("rqt_topic", "rqt_topic", model)
                await frame(app, pilot)
            # Each window makes room for the next: one more costs what there are.
            with step("windows: five more"):
                for model in models[-5:]:
                    desk.display.open("rqt_topic", "rqt_topic", model)
                    await frame(app, pilot)
            with step("  20 frames in which one changes"):
                for _ in range(20):
                    models[0].version += 1
                    await frame(app, pilot)
            with step("  a change in all of them, drawn"):
                for model in models:
                    model.version += 1
                await frame(app, pilot)
            with step("  to the next, 20 times"):
                for _ in range(20):
                    await pilot.press("f3")
                    await frame(app, pilot)

    asyncio.run(act())


# -- terminals ---------------------------------------------------------------------------------------------------------


def scrollback(size: int, step: Steps) -> None:
    """Lines of a terminal's output, ten for each item."""
    from day6_core.shell.screen.screen import Screen

    screen = Screen(80, 24)
    with step("terminal, ten lines each: fed one after the other"):
        for number in range(10 * size):
            screen.feed(f"[INFO] [{number}.0] [talker]: Publishing: Hello World: {number}\r\n")
    with step("  wrapped for another width"):
        screen.resize(24, 41)


def history(size: int, step: Steps) -> None:
    """Commands of a terminal's history, ten for each item."""
    from day6_core.shell.line.history import History

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "history")
        path.write_text("".join(f"ros2 topic echo /topic_{n}\n" for n in range(10 * size)))
        with step("history, ten commands each: read"):
            kept = History(path)
        with step("  20 commands more*"):
            for number in range(20):
                kept.add(f"ls {number}")


# -- tf and markers ----------------------------------------------------------------------------------------------------


def frames(size: int, step: Steps) -> None:
    """Frames of TF: a wide tree and one chain."""
    from geometry_msgs.msg import TransformStamped
    from tf2_py import BufferCore

    from day6_core.ros.programs.rqt_tf_tree.model import snapshot
    from day6_core.ros.programs.tf2_tools.frame_tree import read_frames
    from rclpy.time import Time

    def stamped(parent: str, child: str, second: int) -> TransformStamped:
        message = TransformStamped()
        message.header.frame_id, message.child_frame_id = parent, child
        message.header.stamp.sec = second
        message.transform.rotation.w = 1.0
        return message

    for shape, parent_of in (("a wide tree", lambda n: f"f{n // 5}"), ("one chain", lambda n: f"f{n - 1}")):
        buffer = BufferCore()
        messages = [stamped(parent_of(n), f"f{n}", second) for second in range(1, 6) for n in range(1, size + 1)]
        with step(f"TF frames, {shape}: five transforms each set"):
            for message in messages:
                buffer.set_transform(message, "scale")
        if shape == "one chain":
            with step("  looked up from end to end", 10):
                for _ in range(10):
                    buffer.lookup_transform_core("f0", f"f{min(size, 900)}", Time())
            continue
        with step("  each looked up from the root"):
            for n in range(1, size + 1):
                buffer.lookup_transform_core("f0", f"f{n}", Time())
        with step("  view_frames and rqt_tf_tree"):
            snapshot(read_frames(buffer.all_frames_as_yaml()), 10.0)


def rviz_markers(size: int, step: Steps) -> None:
    """Markers in RViz."""
    from visualization_msgs.msg import Marker, MarkerArray

    markers = []
    for n in range(size):
        marker = Marker(ns="scale", id=n, type=Marker.CUBE)
        marker.header.frame_id = "base"
        marker.pose.position.x, marker.pose.position.y = n % 30 / 5 - 3.0, n / 150 - 3.0
        marker.pose.orientation.w = marker.color.a = marker.color.r = 1.0
        marker.scale.x = marker.scale.y = marker.scale.z = 0.1
        markers.append(marker)
    in_rviz(
        "markers",
        step,
        lambda machine: (machine.fix("base"), machine.add("MarkerArray", "/markers")),
        lambda machine: machine.publish("/markers", MarkerArray(markers=markers)),
    )


def rviz_frames(size: int, step: Steps) -> None:
    """Frames in RViz."""
    from geometry_msgs.msg import TransformStamped
    from tf2_msgs.msg import TFMessage

    def send(machine: Any) -> None:
        sent = []
        for n in range(1, size + 1):
            stamped = TransformStamped()
            stamped.header.frame_id, stamped.child_frame_id = f"f{n // 5}", f"f{n}"
            stamped.header.stamp = machine.stamp()
            stamped.transform.translation.x, stamped.transform.rotation.w = n % 7 - 3.0, 1.0
            sent.append(stamped)
        machine.publish("/tf", TFMessage(transforms=sent))

    in_rviz("TF frames", step, lambda machine: (machine.fix("f0"), machine.add("TF")), send)


def in_rviz(what: str, step: Steps, prepare: Callable[[Any], object], send: Callable[[Any], None]) -> None:
    """Send something to RViz and turn the view of its window."""
    from tests.rviz2.rviz_machine import RVizMachine
    from tests.rviz2.rviz_walk import walking

    async def act() -> None:
        machine = RVizMachine()
        async with walking(machine) as at:
            prepare(machine)
            await at.press("tab", "left")
            with step(f"RViz: {what} received"):
                send(machine)
                machine.settle()
            with step("  sent again", 5):
                for _ in range(5):
                    send(machine)
                    machine.settle()
            seen = {at.screen()}
            with step("  drawn from other sides", 10):
                for _ in range(10):
                    await at.press("left")
                    seen.add(at.screen())
            assert len(seen) > 3, "the window shows the same all the time"
        machine.end()

    asyncio.run(act())


CASES: dict[Callable[[int, Steps], None], tuple[int, ...]] = {
    nodes: SIZES,
    topics: SIZES,
    chain: SIZES,
    fan_out: SIZES,
    linked_topics: SIZES,
    processes: (10, 30, 100),
    rqt_topic: SIZES,
    console: SIZES,
    editor: SIZES,
    windows: (10, 30, 100),
    scrollback: SIZES,
    history: SIZES,
    frames: SIZES,
    rviz_markers: SIZES,
    rviz_frames: SIZES,
}
BY_NAME = {case.__name__: case for case in CASES}


def play(name: str, size: int | str, *words: str) -> str:
    """Play a case in a process of its own, by `python` with some words before; return what it prints."""
    env = program_environment({**os.environ, "DAY6_LINK": "off", "PYTHONWARNINGS": "ignore"})
    command = [sys.executable, *words, "-m", "tests.perf.scale", "--play", name, str(size)]
    return subprocess.run(command, stdout=subprocess.PIPE, env=env, encoding="utf-8", check=True).stdout


def table(names: list[str], rounds: int) -> int:
    """Print the table; return how many rows grow too fast."""
    grown = 0
    print("| CPU of one item, wall of all | few | more | many | growth | kept |\n| --- | --- | --- | --- | --- | --- |")
    for name in names:
        sizes = CASES[BY_NAME[name]]
        played = [[json.loads(play(name, size)) for size in sizes] for _ in range(rounds)]
        for what in played[0][0]:
            cpu, wall = ([min(each[at][what][kind] for each in played) for at in range(len(sizes))] for kind in (0, 1))
            # A step with a star does the same at each size: all of it is one item.
            items = [1] * len(sizes) if what.endswith("*") else list(sizes)
            cells = [
                f"{size:,}: {spent / count * 1e6:.3g} µs, {whole * 1e3:.3g} ms"
                for size, spent, whole, count in zip(sizes, cpu, wall, items, strict=True)
            ]
            growth = (cpu[-1] / items[-1]) / max(cpu[-2] / items[-2], 1e-9)
            kept = growth <= MOST_GROWTH or cpu[-1] < TOO_LITTLE
            grown += not kept
            print(
                f"| {what.rstrip('*')} | {' | '.join(cells)} | {growth:.2f} | {'yes' if kept else '**no**'} |",
                flush=True,
            )
    return grown


def main() -> int:
    """Print the table, or play one case."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", nargs="+", choices=BY_NAME, default=list(BY_NAME), metavar="CASE")
    parser.add_argument("--rounds", type=int, default=3)
    for word in ("--play", "--profile"):
        parser.add_argument(
            word, nargs=2, metavar=("CASE", "SIZE"), help=argparse.SUPPRESS if word == "--play" else None
        )
    options = parser.parse_args()
    if options.play:
        name, size = options.play
        steps = Steps()
        BY_NAME[name](int(size), steps)
        print(json.dumps(steps.found))
        return 0
    if options.profile:
        print(play(*options.profile, "-m", "cProfile", "-s", "tottime"))
        return 0
    return int(table(options.only, options.rounds) > 0)


if __name__ == "__main__":
    sys.exit(main())
