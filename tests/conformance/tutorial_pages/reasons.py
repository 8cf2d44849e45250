"""Why a command does not run here, or prints something else than its page shows.

Each reason was looked up: in the sources of the real tool of that distribution, in what the real tools were recorded to print
(`tests/conformance/golden`), or in the page itself. Its first word is its kind: C++, hardware, network, system, page (the page is
older than its distribution, or shows what it does not run), words (ours).
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from tests.conformance.tutorial_pages.judge import masked

if TYPE_CHECKING:
    from tests.conformance.tutorial_pages.player import Row

_OLDER = "page: recorded before get_type_description and its parameter came (Iron)"

KNOWN: dict[str, tuple[tuple[str, str], ...]] = {
    "": (
        (r"^RMW_IMPLEMENTATION", "system: one middleware, whatever is asked for"),
        (r"rclcpp|_cpp\b|cpp_", "C++"),
        (r"^git clone|^wget", "network: the clone in the mirror has no such branch or file"),
        (r"ros2 (node info|service list)", _OLDER),
        (r"turtle_teleop_key", "page: recorded before the keys' names were small letters (turtlesim 1.8.3)"),
        (r"service call /spawn turtlesim_msgs", "page: the answer was recorded before turtlesim_msgs (Kilted)"),
        (
            r"ros2 topic info .*--verbose",
            "page: recorded with rmw_zenoh; Fast DDS doesn't tell the depth, and the order is chance",
        ),
        (
            r"\\'linear:",
            r"page: shows how bash completes a newline; typed, `\^J` is two characters, which ros2 refuses too",
        ),
        (r"ros2 action echo", "page: the events of two processes and of five topics come in an order that is chance"),
        (r"ros2 topic bw", "page: older than Lyrical, which names the topic only beside others (ros2cli#1124)"),
        (r"image_tools cam2image$", "hardware: a camera"),
        (r"intra_process_demo", "C++: shows the addresses of messages that are moved instead of copied"),
    ),
    "Understanding-ROS2-Parameters": (
        (r"ros2 param list", "page: recorded before start_type_description_service (Iron) and turtlesim's holonomic"),
        (r"ros2 param load", "page: recorded before start_type_description_service (Iron) and turtlesim's holonomic"),
    ),
    "Node-arguments": ((r"ros2 param list", "page: recorded before start_type_description_service (Iron)"),),
    "Recording-And-Playing-Back-Data": (
        (r"ros2 bag .*(--action|--send-actions|info actions)", "missing: actions in bags, when this was played"),
        (
            r"subset_split",
            "page: recorded with Kilted: Lyrical's recorder also says where it records, and when discovery starts and ends",
        ),
        (
            r"ros2 bag record",
            "page: recorded with Dashing: today's recorder logs by its own name, and how it opens a database (of SQLite)",
        ),
        (r"ros2 bag info <", "page: recorded with Rolling, whose name it shows"),
        (
            r"ros2 bag info",
            "page: recorded with Dashing: no number of the file, no colon after End, no distribution and services (Jazzy)",
        ),
        (
            r"ros2 bag play",
            "page: recorded with Dashing; the player of today names its rate and keys, and logs how it shows progress",
        ),
    ),
    "Colcon-Tutorial": (
        (r"colcon test$", "C++: its tests are skipped"),
        (r"^cd ", "page: a picture of folders"),
    ),
    "Creating-A-Workspace": ((r"colcon build", "network: the clone in the mirror has no such branch"),),
    "Creating-Your-First-ROS2-Package": (
        (r"ros2 pkg create", "page: the listing was made without the licence that its command names"),
    ),
    "Single-Package-Define-And-Use-Interface": ((r"/address_book", "C++: its publisher"),),
    "Using-Parameters-In-A-Class-Python": (
        (r"ros2 run", "page: the listing names a node that its program does not have"),
        (r"ros2 launch", "page: the listing leaves out launch's prefix"),
    ),
    "Getting-Started-With-Ros2doctor": (
        (r"ros2 doctor --report", "page: asks the internet for the distribution's state; here nothing is asked"),
        (r"ros2 doctor", "page: shows the warnings and leaves out doctor's last line"),
    ),
    "Composition": (
        (r"dlopen", "C++: loads shared libraries, and says so"),
        (r"component unload", "page: older; ros2component adds 'node' in Humble, Jazzy and Rolling"),
    ),
    "dummy-robot-demo": (
        (r"^source", "page: of a build from source; here the packages are ready-made"),
        (r"ros2 launch", "page: recorded with Bouncy, whose robot_state_publisher printed all it did"),
    ),
    "Quality-of-Service": (
        (r"image_tools cam2image$", "hardware: a camera"),
        (r"image_tools", "page: recorded when the programs printed instead of logging"),
    ),
    "Introduction-To-Tf2": (
        (r"view_frames", "page: recorded when view_frames printed instead of logging (before Humble)"),
    ),
    "Debugging-Tf2-Problems": (
        (r"turtle_tf2 ", "page: a package of ROS 1, and the frames are C++'s"),
        (r"tf2_echo|tf2_monitor", "C++: the node that is debugged is learning_tf2_cpp's"),
    ),
}
"""By page, or '' for all (looked at last): a pattern of commands and the reason."""


def reason(page: str, row: Row) -> str:
    """Return the reason of a row, '' where there is none to be told."""
    if row.reason and row.verdict not in ("run", "window"):
        return row.reason
    if row.command.startswith("ros2 bag record") and "unrecognized arguments: /" in row.output:
        return "page: older than Lyrical, where the topics stand behind --topics (the reader types that then)"
    if row.command.startswith("colcon build") and "day6-tui has no C++ compiler" in row.output:
        return "C++: says which programs it leaves out"
    if row.command.startswith("ros2 interface show") and _only_comments_differ(row):
        return "words: the comments of interfaces are our own"
    for pattern, text in (*KNOWN.get(page, ()), *KNOWN[""]):
        if re.search(pattern, row.command):
            return text
    return "C++" if re.search(r"Cpp|CPP", page) else ""


def _only_comments_differ(row: Row) -> bool:
    bare = [
        [line.partition("#")[0].strip() for line in masked(text) if line.partition("#")[0].strip()]
        for text in (row.listing or "", row.output)
    ]
    return bool(bare[0]) and bare[0] == bare[1]
