"""showimage: tells of each picture that comes, and shows it in a window.

What it does without a screen is the rule of `programs/_without_screen.py`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs._without_screen import say_there_is_none
from day6_core.ros.programs.image_tools._components import ShowImage
from day6_core.ros.programs.image_tools._running import run

if TYPE_CHECKING:
    from day6_core.ros.programs.image_tools.shown_image import ImageWindow
    from day6_core.session.session import Session
    from rclpy.node import Node

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
    def component(node: Node, window: ImageWindow) -> ShowImage:
        made = ShowImage(node, session.print_error, window.show)
        if made.shows and session.display is None:
            say_there_is_none(node)
        return made

    return await run(session, USAGE, ShowImage.NAME, component)
