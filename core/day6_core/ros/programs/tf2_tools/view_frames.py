"""view_frames: draws the tree of frames (tf2_tools/view_frames.py).

It writes the tree in graphviz's language and as a PDF.
"""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

from tf2_msgs.srv import FrameGraph
from tf2_ros import DEFAULT_STATIC_TF_TOPIC, DEFAULT_TF_TOPIC, Buffer, TransformListener

from day6_core.ros.programs._drawn_pdf import write_pdf
from day6_core.ros.programs.tf2_tools.frame_tree import as_dot, as_graph, read_frames
from day6_core.session.argument_parser import ParserExit, SessionParser
from day6_core.session.threads import in_thread
from day6_core.whole_file import replace_file
from rclpy.task import Future
from rclpy.utilities import remove_ros_args

if TYPE_CHECKING:
    from argparse import Namespace

    from day6_core.session.session import Session
    from rclpy.node import Node


def parse(session: Session) -> Namespace:
    """Return the options. Raises ParserExit."""
    description = "Create a diagram of the TF frames being broadcast over ROS"
    parser = SessionParser(session, prog=session.name, description=description)
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
    return await export(session, node, result.result(), options.output)


async def export(session: Session, node: Node, answer: Any, name: str | None) -> int:
    """Write the frames as `.gv` and `.pdf` into the working directory; return the status."""
    log = node.get_logger()
    log.info(f"Result:{answer}")
    seconds, nanoseconds = node.get_clock().now().seconds_nanoseconds()
    now = seconds + nanoseconds / 1e9  # as the original adds them
    try:
        frames = await in_thread(lambda: read_frames(answer.frame_yaml))
    except ValueError as error:  # the original ends with a traceback
        log.error(f"Service call failed {error}")
        return 1
    if name is None:
        name = time.strftime("frames_%Y-%m-%d_%H.%M.%S", time.localtime(session.clock.now_ns() // 1_000_000_000))
    log.info(f"Exporting graph in {name}.pdf file...")
    source = session.cwd / f"{name}.gv"
    await in_thread(lambda: replace_file(source, as_dot(frames, now).encode("utf-8")))
    await write_pdf(session, source, as_graph(frames, now), log.warning)
    return 0
