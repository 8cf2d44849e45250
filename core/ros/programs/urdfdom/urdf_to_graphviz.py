"""`urdf_to_graphviz FILE [NAME]`: draw a robot's links and joints as a graph (urdfdom 4.0.1).

The DOT file is always written; the PDF only where graphviz's `dot` is installed.
"""

from __future__ import annotations

import shutil
import subprocess

from day6_tui.core.ros.programs.urdfdom._input import FAILED, read_robot, take_hint_option
from day6_tui.core.session.harmless import quotable
from day6_tui.core.session.session import Session
from day6_tui.core.session.threads import in_thread
from day6_tui.core.whole_file import replace_file
from day6_tui.urdf import Robot


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
    graph, picture = session.cwd / f"{name}.gv", session.cwd / f"{name}.pdf"
    try:
        replace_file(graph, dot_of(robot).encode("utf-8", "surrogateescape"))
    except OSError as error:
        session.print_error(f"Error: dot: can't open {name}.gv")
        if not isinstance(error, FileNotFoundError):
            return FAILED  # a full disk; where there is no such folder the original goes on, and so do we
    session.print(f"Created file {name}.gv")
    dot = shutil.which("dot", path=session.env.get("PATH"))
    if dot is None:
        session.print_error(f"dot is not installed here, so there is no {name}.pdf")
        return 0
    if graph.exists():
        await in_thread(lambda: subprocess.run([dot, "-Tpdf", str(graph), "-o", str(picture)], check=False))
    session.print(f"Created file {name}.pdf")
    return 0


def dot_of(robot: Robot) -> str:
    """Return the robot as DOT text: boxes for links, ellipses for joints with their origins."""
    lines = ["digraph G {", "node [shape=box];"]
    order = [robot.root, *(joint.child for joint in robot.tree())]
    lines += [f'"{name}" [label="{name}"];' for name in map(quotable, order)]
    lines.append("node [shape=ellipse, color=blue, fontcolor=blue];")
    for joint in robot.tree():
        xyz = " ".join(f"{value:g}" for value in joint.origin.xyz)
        rpy = " ".join(f"{value:g}" for value in joint.origin.rpy)
        parent, name, child = map(quotable, (joint.parent, joint.name, joint.child))
        lines.append(f'"{parent}" -> "{name}" [label="xyz: {xyz} \\nrpy: {rpy}"]')
        lines.append(f'"{name}" -> "{child}"')
    return "\n".join([*lines, "}", ""])
