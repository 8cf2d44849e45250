"""view_frames: draws the tree of frames (tf2_tools/view_frames.py).

It writes the tree in graphviz's language, and a PDF where graphviz's `dot` is installed.
"""

from __future__ import annotations

import shutil
import subprocess
import time
from typing import TYPE_CHECKING, Any

from tf2_msgs.srv import FrameGraph
from tf2_ros import DEFAULT_STATIC_TF_TOPIC, DEFAULT_TF_TOPIC, Buffer, TransformListener

from day6_tui.core.session.argument_parser import Parser, ParserExit
from day6_tui.core.session.harmless import quotable
from day6_tui.core.session.threads import in_thread
from day6_tui.core.whole_file import replace_file
from rclpy.task import Future
from rclpy.utilities import remove_ros_args

if TYPE_CHECKING:
    from argparse import Namespace

    from day6_tui.core.session.session import Session
    from rclpy.node import Node


def parse(session: Session) -> Namespace:
    """Return the options. Raises ParserExit."""
    description = "Create a diagram of the TF frames being broadcast over ROS"
    parser = Parser(session, prog=session.name, description=description)
    parser.add_argument(
        "--wait-time",
        "-t",
        type=float,
        default=5.0,
        help="Listen to the /tf topic for this many seconds before rendering the frame tree",
    )
    parser.add_argument("-o", "--output", help="Output filename")
    parser.add_argument("--tf_topic", help="Topic for dynamic transforms", default=DEFAULT_TF_TOPIC)
    parser.add_argument("--tf_static_topic", help="Topic for static transforms", default=DEFAULT_STATIC_TF_TOPIC)
    return parser.parse_args(remove_ros_args(args=session.argv)[1:])


def as_dot(frames: dict[str, dict[str, Any]], now: float) -> str:
    """Return the tree in graphviz's language; `now` is when it was recorded (seconds)."""
    if not frames:
        return 'digraph G { "No tf data received" }'
    lines = ["digraph G {"]
    root = None
    for frame, about in frames.items():
        label = (
            f" Broadcaster: {quotable(str(about['broadcaster']))}\\n"
            f"Average rate: {about['rate']}\\n"
            f"Buffer length: {about['buffer_length']}\\n"
            f"Most recent transform: {about['most_recent_transform']}\\n"
            f"Oldest transform: {about['oldest_transform']}\\n"
        )
        lines.append(f'"{quotable(about["parent"])}" -> "{quotable(frame)}"[label="{label}"];')
        if about["parent"] not in frames:
            root = about["parent"]
    if root is not None:  # in a loop there is none
        lines.append("edge [style=invis];")
        lines.append(' subgraph cluster_legend { style=bold; color=black; label ="view_frames Result";')
        lines.append(f'"Recorded at time: {now}"[ shape=plaintext ] ;')
        lines.append(f'}}->"{quotable(root)}";')
    return "\n".join([*lines, "}"])


async def main(session: Session) -> int:
    try:
        options = parse(session)
    except ParserExit as leave:
        return leave.status
    node = session.create_node("view_frames")
    log = node.get_logger()
    buffer = Buffer(node=node)
    TransformListener(buffer, node, tf_topic=options.tf_topic, tf_static_topic=options.tf_static_topic)
    session.executor.add_node(node)
    log.info(f"Listening to tf data for {options.wait_time} seconds...")
    await session.spin_until(Future(), max(0.0, options.wait_time))
    log.info("Generating graph...")
    # By its own service, as the original does.
    result = node.create_client(FrameGraph, "tf2_frames").call_async(FrameGraph.Request())
    await session.spin_until(result)
    await export(session, node, result.result(), options.output)
    return 0


async def export(session: Session, node: Node, answer: Any, name: str | None) -> None:
    """Write the frames as `.gv` and, by graphviz, as `.pdf` into the working directory."""
    import yaml

    log = node.get_logger()
    log.info(f"Result:{answer}")
    recorded = node.get_clock().now().nanoseconds
    if name is None:
        name = time.strftime("frames_%Y-%m-%d_%H.%M.%S", time.localtime(session.clock.now_ns() // 1_000_000_000))
    log.info(f"Exporting graph in {name}.pdf file...")
    source, drawing = session.cwd / f"{name}.gv", session.cwd / f"{name}.pdf"
    replace_file(source, as_dot(yaml.safe_load(answer.frame_yaml), recorded * 1e-9).encode("utf-8"))
    graphviz = shutil.which("dot", path=session.env.get("PATH"))
    if graphviz is None:
        # The original says nothing and leaves no drawing.
        log.warning(f"graphviz (dot) is not installed: there is {name}.gv, but no PDF of it")
        return
    command = [graphviz, "-Tpdf", str(source), "-o", str(drawing)]
    await in_thread(lambda: subprocess.run(command, stdin=subprocess.DEVNULL, check=False))
