"""`ros2 run joint_state_publisher joint_state_publisher [FILE]`: publishes every movable joint's position, at first zero."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.joint_state_publisher.other_formats import DescriptionError
from day6_core.ros.programs.joint_state_publisher.publisher import NAME, OPTIONS, JointStatePublisher
from day6_core.session.argument_parser import ParserExit, SessionParser
from day6_urdf.check import MAX_BYTES, read_description, too_large
from rclpy.utilities import remove_ros_args

if TYPE_CHECKING:
    from day6_core.session.session import Session


def make_publisher(session: Session, argument: str, about: str) -> JointStatePublisher | int:
    """Return the node for this command line, or the exit status when there is none."""
    parser = SessionParser(session, prog=session.name)
    parser.add_argument(argument, help=about, nargs="?", default=None)
    try:
        file = getattr(parser.parse_args(remove_ros_args(args=session.argv)[1:]), argument)
        text, size = (None, 0) if file is None else read_description(session.cwd / file)
        if size > MAX_BYTES:
            raise DescriptionError(str(too_large(size).diagnostics[0].text))
        return JointStatePublisher(session.create_node(NAME, **OPTIONS), text)
    except ParserExit as end:
        return end.status
    except OSError as error:
        session.print_error(f"{type(error).__name__}: [Errno {error.errno}] {error.strerror}: '{file}'")
    except DescriptionError as error:
        session.print_error(f"Exception: {error}")
    return 1


async def main(session: Session) -> int:
    publisher = make_publisher(session, "description_file", "Robot description file to use")
    if isinstance(publisher, int):
        return publisher
    try:
        await session.spin(publisher.node)
    except SystemExit as end:
        return int(end.code or 0)
    except KeyboardInterrupt:
        return 0
    return 0
