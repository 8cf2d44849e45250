"""`check_urdf FILE`: parse a robot description and print its tree of links (urdfdom 4.0.1)."""

from __future__ import annotations

from day6_core.ros.programs.urdfdom._input import FAILED, read_robot, take_hint_option
from day6_core.session.session import Session
from day6_urdf import Robot


async def main(session: Session) -> int:
    """Print the tree; status 255 if the description is refused."""
    hints = take_hint_option(session)
    if len(session.argv) < 2:
        session.print_error("Expect URDF xml file to parse. Use - for stdin")
        return FAILED
    robot = await read_robot(session, session.argv[1], hints)
    if robot is None:
        return FAILED
    session.print(f"robot name is: {robot.name}")
    session.print("---------- Successfully Parsed XML ---------------")
    if robot.loop:
        session.print_error(f"The links form a loop: {' -> '.join(robot.loop)} (urdfdom's own check_urdf crashes here)")
        return FAILED
    root = robot.root
    session.print(f"root Link: {root} has {len(robot.children_of(root))} child(ren)")
    _print_children(session, robot, root)
    return 0


def _print_children(session: Session, robot: Robot, root: str) -> None:
    """Print the tree below a link; without recursion, because a chain may be longer than Python's stack."""
    waiting = [(1, number, child) for number, child in _numbered(robot, root)]
    while waiting:
        depth, number, link = waiting.pop(0)
        session.print(f"{'    ' * depth}child({number}):  {link}")
        waiting[:0] = [(depth + 1, below, child) for below, child in _numbered(robot, link)]


def _numbered(robot: Robot, link: str) -> list[tuple[int, str]]:
    return list(enumerate((joint.child for joint in robot.children_of(link)), start=1))
