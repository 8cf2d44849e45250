"""showimage: tells of each picture that comes; there is no window of OpenCV for it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_tui.core.ros.programs._component import spin_cpp
from day6_tui.core.ros.programs.image_tools._components import ShowImage
from day6_tui.core.ros.programs.rclcpp import CppException, create_node

if TYPE_CHECKING:
    from day6_tui.core.session.session import Session

USAGE = """\
Usage: showimage [-h] [--ros-args [-p param:=value] ...]
Subscribe to an image topic and show the images.
Example: ros2 run image_tools showimage --ros-args -p reliability:=best_effort

Options:
  -h, --help\tDisplay this help message and exit

Parameters:
  reliability\tReliability QoS setting. Either 'reliable' (default) or 'best_effort'
  history\tHistory QoS setting. Either 'keep_last' (default) or 'keep_all'.
\t\tIf 'keep_last', then up to N samples are stored where N is the depth
  depth\t\tDepth of the publisher queue. Only honored if history QoS is 'keep_last'. Default value is 10
  show_image\tShow the image. Either 'true' (default) or 'false'
  window_name\tName of the display window. Default value is the topic name"""


async def main(session: Session) -> int:
    if {"-h", "--help"} & set(session.argv[1:]):
        session.print(USAGE)
        return 0
    node = create_node(session, ShowImage.NAME)
    try:
        component = ShowImage(node, session.print_error)
    except RuntimeError as error:
        raise CppException(str(error)) from None
    status = await spin_cpp(session, node)
    del component  # it lives as long as its node spins
    return status
