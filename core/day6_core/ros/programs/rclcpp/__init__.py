"""What a user sees of the difference between a node of rclcpp (C++) and one of rclpy, as in Jazzy (rclcpp 28.1).

turtlesim, tf2_ros, robot_state_publisher, the demos, rviz2 and `ros2 bag` are C++ in real ROS. Their copies here are written on
rclpy and made by `create_node`, so that their parameters, their answers and the way they fail are those of C++ nodes:

- `exceptions`: an error that nothing catches ends the program by SIGABRT, in the words of C++;
- `parameters`: how parameters are declared, set, described and listed, and what refusals say;
- `qos`: the parameters `qos_overrides.…` of endpoints whose QoS may be changed from outside;
- `logger`: how a log message names its file;
- `node`: the rest: the parameters, topics and services that every node has.

SIGINT and SIGTERM (`STOPPED`) end such a program with status 0, after a line of `log_interrupt`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_core.ros import differences
from day6_core.ros.programs.rclcpp.exceptions import CppException as CppException
from day6_core.ros.programs.rclcpp.exceptions import thrown_as_cpp
from day6_core.ros.programs.rclcpp.node import CppNode
from day6_core.session.session import STOPPED as STOPPED

if TYPE_CHECKING:
    from day6_core.session.session import Session


def init(session: Session) -> None:
    """Read the program's ROS arguments, as rclcpp::init does. Raises CppException for bad ones."""
    with thrown_as_cpp():
        _ = session.context


def init_and_remove_ros_arguments(session: Session) -> list[str]:
    """Do `init` and return the words of the command line that are not for ROS, beginning with the program's name."""
    from rclpy.utilities import remove_ros_args

    init(session)
    return remove_ros_args(args=session.argv)


def create_node(session: Session, name: str, kind: type[CppNode] = CppNode, **keywords: Any) -> CppNode:
    """Return a node of this program: `kind(name, …)`, destroyed at its end. Raises CppException."""
    init(session)
    return session.keep(kind(name, context=session.context, **keywords))


def log_interrupt(session: Session) -> None:
    """Print what rclcpp's signal handler logs when a signal stops the program (rclcpp/signal_handler.cpp)."""
    session.stopping = True
    text = differences.value("rclcpp.signal").format(number=15 if session.terminated else 2)
    log(session, "INFO", "rclcpp", f"signal_handler({text})")


def log(session: Session, level: str, logger: str, text: str) -> None:
    """Log as a logger that belongs to no node; so nothing of it goes to /rosout."""
    from rclpy.impl.rcutils_logger import RcutilsLogger
    from rclpy.logging import LoggingSeverity

    RcutilsLogger._of_node(logger, session.context._logging).log(text, LoggingSeverity[level])
