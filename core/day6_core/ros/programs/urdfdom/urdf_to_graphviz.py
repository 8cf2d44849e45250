"""`urdf_to_graphviz FILE [NAME]`: draw a robot's links and joints as a graph (urdfdom 4.0.1)."""

from __future__ import annotations

from itertools import pairwise

from day6_core.reason import reason
from day6_core.ros.programs._drawn_pdf import write_pdf
from day6_core.ros.programs.rqt_graph.model.shapes import Box, Edge
from day6_core.ros.programs.urdfdom._input import FAILED, read_robot, take_hint_option
from day6_core.session.harmless import one_line, quotable
from day6_core.session.session import Session
from day6_core.session.threads import in_thread
from day6_core.whole_file import replace_file
from day6_urdf.model import Joint, Robot


async def main(session: Session) -> int:
    """Write NAME.gv and NAME.pdf; NAME is by default the robot's name. Status 255 if the description is refused."""
    hints = take_hint_option(session)
    if not 2 <= len(session.argv) <= 3:
        session.print_error(
            "Usage: urdf_to_graphviz input.xml [OUTPUT]"
            "  Will create either $ROBOT_NAME.gv & $ROBOT_NAME.pdf in CWD  or OUTPUT.gv & OUTPUT.pdf."
        )
        return FAILED
    robot = await read_robot(session, session.argv[1], hints)
    if robot is None:
        return FAILED
    name = session.argv[2] if len(session.argv) == 3 else robot.name.replace("/", "_")
    # The original writes wherever a robot's name leads; a file from elsewhere shall not choose the place.
    graph = session.cwd / f"{name}.gv"
    try:
        await in_thread(lambda: replace_file(graph, dot_of(robot).encode("utf-8", "surrogateescape")))
    except OSError as error:
        session.print_error(f"Error: dot: can't open {name}.gv")
        if not isinstance(error, FileNotFoundError):
            return FAILED  # a full disk; where there is no such folder the original goes on, and so do we
    session.print(f"Created file {name}.gv")
    if graph.exists():
        try:
            await write_pdf(session, graph, graph_of(robot), session.print_error, _colours(robot))
        except OSError as error:
            session.print_error(f'Error: Could not open "{name}.pdf" for writing : {reason(error)}')
            return FAILED
    session.print(f"Created file {name}.pdf")
    return 0


def dot_of(robot: Robot) -> str:
    """Return the robot as DOT text: boxes for links, ellipses for joints with their origins."""
    lines = ["digraph G {", "node [shape=box];"]
    order = [robot.root, *(joint.child for joint in robot.tree())]
    lines += [f'"{name}" [label="{name}"];' for name in map(quotable, order)]
    lines.append("node [shape=ellipse, color=blue, fontcolor=blue];")
    for joint in robot.tree():
        parent, name, child = map(quotable, (joint.parent, joint.name, joint.child))
        xyz, rpy = _origin(joint)
        lines.append(f'"{parent}" -> "{name}" [label="{xyz} \\n{rpy}"]')
        lines.append(f'"{name}" -> "{child}"')
    return "\n".join([*lines, "}", ""])


def graph_of(robot: Robot) -> tuple[list[Box], list[Edge]]:
    """Return the same graph for our own layout."""
    links = [robot.root, *(joint.child for joint in robot.tree())]
    boxes = [Box(f"link {name}", (one_line(name),), "topic") for name in links]
    edges = []
    for joint in robot.tree():
        stations = f"link {joint.parent}", f"origin {joint.name}", f"joint {joint.name}", f"link {joint.child}"
        boxes.append(Box(stations[1], _origin(joint), "text"))
        boxes.append(Box(stations[2], (one_line(joint.name),), "node"))
        edges += [Edge(start, end, "", joint.name) for start, end in pairwise(stations)]
    return boxes, edges


def _colours(robot: Robot) -> dict[str, str]:
    return {f"joint {joint.name}": "#0000ff" for joint in robot.tree()}


def _origin(joint: Joint) -> tuple[str, str]:
    xyz, rpy = (" ".join(f"{value:g}" for value in values) for values in (joint.origin.xyz, joint.origin.rpy))
    return f"xyz: {xyz}", f"rpy: {rpy}"
