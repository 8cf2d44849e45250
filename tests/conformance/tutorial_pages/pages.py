"""Which pages are played, which share a home, and what a reader knows that no rule finds in their words."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from tests.conformance.tutorial_pages.documentation import Block


@dataclass(frozen=True)
class Page:
    """A page; those of one `chain` are played one after the other in one home: each takes up what the one before has left."""

    path: str
    chain: str

    @property
    def name(self) -> str:
        return self.path.removesuffix(".rst").rpartition("/")[2]

    @property
    def section(self) -> str:
        return self.path.removeprefix("source/Tutorials/").partition("/")[0]


@dataclass(frozen=True)
class Hand:
    """What to do at a block: `block` is looked for in its text.

    `file`: the block belongs there (or to several, between spaces), `how` says in which way (see `Workspace.write`). `at`: the
    folder in which to type it. `instead`: pairs of a pattern and what to type for it. `interrupt`: a pattern of running commands
    that get Ctrl-C before, `before`: commands that are typed before. `of`: the command whose output the block is.
    `skip`: why it is not played. `lasts`: for how many seconds a reader lets it run before going on.
    """

    block: str
    tab: str = ""
    heading: str = ""
    file: str = ""
    how: str = "whole"
    at: str = ""
    instead: Sequence[tuple[str, str]] = ()
    interrupt: str = ""
    before: Sequence[str] = ()
    of: str = ""
    skip: str = ""
    lasts: float = 0.0

    def fits(self, block: Block) -> bool:
        return (
            (not self.tab or self.tab.lower() == block.tab.lower())
            and (not self.heading or re.search(self.heading, block.heading) is not None)
            and re.search(self.block, block.text, re.M) is not None
        )


_CHAINED = ("Beginner-Client-Libraries", "Intermediate/Launch", "Intermediate/Tf2", "Intermediate/URDF")
"""Folders whose pages build on each other."""

ORDER = (
    "Beginner-CLI-Tools/Configuring-ROS2-Environment",
    "Beginner-CLI-Tools/Introducing-Turtlesim/Introducing-Turtlesim",
    "Beginner-CLI-Tools/Understanding-ROS2-Nodes/Understanding-ROS2-Nodes",
    "Beginner-CLI-Tools/Understanding-ROS2-Topics/Understanding-ROS2-Topics",
    "Beginner-CLI-Tools/Understanding-ROS2-Services/Understanding-ROS2-Services",
    "Beginner-CLI-Tools/Understanding-ROS2-Parameters/Understanding-ROS2-Parameters",
    "Beginner-CLI-Tools/Understanding-ROS2-Actions/Understanding-ROS2-Actions",
    "Beginner-CLI-Tools/Using-Rqt-Console/Using-Rqt-Console",
    "Beginner-CLI-Tools/Launching-Multiple-Nodes/Launching-Multiple-Nodes",
    "Beginner-CLI-Tools/Recording-And-Playing-Back-Data/Recording-And-Playing-Back-Data",
    "Beginner-Client-Libraries/Colcon-Tutorial",
    "Beginner-Client-Libraries/Creating-A-Workspace/Creating-A-Workspace",
    "Beginner-Client-Libraries/Creating-Your-First-ROS2-Package",
    "Beginner-Client-Libraries/Writing-A-Simple-Cpp-Publisher-And-Subscriber",
    "Beginner-Client-Libraries/Writing-A-Simple-Py-Publisher-And-Subscriber",
    "Beginner-Client-Libraries/Writing-A-Simple-Cpp-Service-And-Client",
    "Beginner-Client-Libraries/Writing-A-Simple-Py-Service-And-Client",
    "Beginner-Client-Libraries/Custom-ROS2-Interfaces",
    "Beginner-Client-Libraries/Single-Package-Define-And-Use-Interface",
    "Beginner-Client-Libraries/Using-Parameters-In-A-Class-CPP",
    "Beginner-Client-Libraries/Using-Parameters-In-A-Class-Python",
    "Beginner-Client-Libraries/Getting-Started-With-Ros2doctor",
    "Beginner-Client-Libraries/Pluginlib",
    "Intermediate/Rosdep",
    "Intermediate/Creating-an-Action",
    "Intermediate/Writing-an-Action-Server-Client/Cpp",
    "Intermediate/Writing-an-Action-Server-Client/Py",
    "Intermediate/Writing-a-Composable-Node",
    "Intermediate/Composition",
    "Intermediate/Monitoring-For-Parameter-Changes-CPP",
    "Intermediate/Monitoring-For-Parameter-Changes-Python",
    "Intermediate/Launch/Creating-Launch-Files",
    "Intermediate/Launch/Launch-system",
    "Intermediate/Launch/Using-Substitutions",
    "Intermediate/Launch/Using-Event-Handlers",
    "Intermediate/Launch/Using-ROS2-Launch-For-Large-Projects",
    "Intermediate/Tf2/Introduction-To-Tf2",
    "Intermediate/Tf2/Writing-A-Tf2-Static-Broadcaster-Py",
    "Intermediate/Tf2/Writing-A-Tf2-Broadcaster-Py",
    "Intermediate/Tf2/Writing-A-Tf2-Listener-Py",
    "Intermediate/Tf2/Adding-A-Frame-Py",
    "Intermediate/Tf2/Learning-About-Tf2-And-Time-Py",
    "Intermediate/Tf2/Time-Travel-With-Tf2-Py",
    "Intermediate/Tf2/Debugging-Tf2-Problems",
    "Intermediate/Tf2/Quaternion-Fundamentals",
    "Intermediate/Tf2/Using-Stamped-Datatypes-With-Tf2-Ros-MessageFilter",
    "Intermediate/Tf2/Writing-A-Tf2-Static-Broadcaster-Cpp",
    "Intermediate/Tf2/Writing-A-Tf2-Broadcaster-Cpp",
    "Intermediate/Tf2/Writing-A-Tf2-Listener-Cpp",
    "Intermediate/Tf2/Adding-A-Frame-Cpp",
    "Intermediate/Tf2/Learning-About-Tf2-And-Time-Cpp",
    "Intermediate/Tf2/Time-Travel-With-Tf2-Cpp",
    "Intermediate/Testing/CLI",
    "Intermediate/Testing/Python",
    "Intermediate/Testing/Cpp",
    "Intermediate/URDF/Building-a-Visual-Robot-Model-with-URDF-from-Scratch",
    "Intermediate/URDF/Building-a-Movable-Robot-Model-with-URDF",
    "Intermediate/URDF/Adding-Physical-and-Collision-Properties-to-a-URDF-Model",
    "Intermediate/URDF/Using-Xacro-to-Clean-Up-a-URDF-File",
    "Intermediate/URDF/Using-URDF-with-Robot-State-Publisher",
    "Intermediate/URDF/Exporting-an-URDF-File",
    "Intermediate/RViz/RViz-User-Guide/RViz-User-Guide",
    "Intermediate/RViz/RViz-Custom-Display/RViz-Custom-Display",
    "Advanced/Recording-A-Bag-From-Your-Own-Node-CPP",
    "Advanced/Recording-A-Bag-From-Your-Own-Node-Py",
    "Advanced/Reading-From-A-Bag-File-CPP",
    "Advanced/Reading-From-A-Bag-File-Python",
    "Demos/Quality-of-Service",
    "Demos/Managed-Nodes",
    "Demos/Logging-and-logger-configuration",
    "Demos/Intra-Process-Communication",
    "Demos/Content-Filtering-Subscription",
    "Demos/Service-Introspection",
    "Demos/dummy-robot-demo",
)
"""Below source/Tutorials, in the order in which they are to be read. Pages that a branch lacks are left out."""

GUIDES = (
    "Concepts/Basic/About-Command-Line-Tools",
    "Concepts/Basic/About-Parameters",
    "Concepts/Intermediate/About-RQt",
    "How-To-Guides/Launch-file-different-formats",
    "How-To-Guides/Launching-composable-nodes",
    "How-To-Guides/Node-arguments",
    "How-To-Guides/Overriding-QoS-Policies-For-Recording-And-Playback",
    "How-To-Guides/Using-callback-groups",
    "How-To-Guides/Using-ros2-param",
)
"""Below source: what else a learner is sent to that needs neither C++ nor another machine."""


def pages(paths: Sequence[str]) -> list[Page]:
    """Return those of ORDER and GUIDES that a branch has, where it has them."""
    found = []
    for name in (*(f"Tutorials/{name}" for name in ORDER), *GUIDES):
        path = _place(f"source/{name}.rst", paths)
        name = name.removeprefix("Tutorials/")
        if path:
            chain = next((folder for folder in _CHAINED if name.startswith(folder)), name)
            if name.endswith("Colcon-Tutorial"):
                chain = name  # its clone has C++ packages, which no later page wants
            if name.startswith("Intermediate/Testing"):
                chain = _CHAINED[0]
            if name.startswith("Intermediate/") and ("Action" in name):
                chain = "Intermediate/Actions"
            if name in ("Advanced/Recording-A-Bag-From-Your-Own-Node-Py", "Advanced/Reading-From-A-Bag-File-Python"):
                chain = "Advanced/Bags"  # the second one reads what the first one has written
            found.append(Page(path, chain))
    return found


def _place(path: str, paths: Sequence[str]) -> str:
    """Return where a branch has a page, '' without it: Lyrical's documentation has moved most, and kept their names."""
    if path in paths:
        return path
    folder, name = path.split("/")[-2:]
    end = f"/{folder}/{name}" if name in _COMMON_NAMES else f"/{name}"
    return next((each for each in paths if each.endswith(end)), "")


_COMMON_NAMES = ("CLI.rst", "Cpp.rst", "Py.rst", "Python.rst")
"""Names of pages that say nothing without their folder."""

_PUBSUB = "ros2_ws/src/py_pubsub"
_SRVCLI = "ros2_ws/src/py_srvcli"

_NODE_WITH_LOGGER_SERVICE = (
    "printf '%s\\n' 'import rclpy' 'from rclpy.node import Node' 'rclpy.init()' "
    "\"node = Node('NodeWithLoggerService', enable_logger_service=True)\" 'rclpy.spin(node)' > node.py"
)

HANDS: dict[str, tuple[Hand, ...]] = {
    "Creating-Your-First-ROS2-Package": (
        Hand(r"ros2 pkg create", tab="CMake", skip="the tab for C++; a reader of Python takes the other"),
        Hand(r".", tab="CMake", skip="the tab for C++; a reader of Python takes the other"),
    ),
    "Custom-ROS2-Interfaces": (
        Hand(r"class MinimalPublisher\(Node", file=f"{_PUBSUB}/py_pubsub/publisher_member_function.py"),
        Hand(r"class MinimalSubscriber\(Node", file=f"{_PUBSUB}/py_pubsub/subscriber_member_function.py"),
        Hand(r"class MinimalService\(Node", file=f"{_SRVCLI}/py_srvcli/service_member_function.py"),
        Hand(r"class MinimalClientAsync\(Node", file=f"{_SRVCLI}/py_srvcli/client_member_function.py"),
        Hand(r"<exec_depend>tutorial_interfaces", heading="pub/sub", file=f"{_PUBSUB}/package.xml", how="manifest"),
        Hand(
            r"<exec_depend>tutorial_interfaces", heading="service/client", file=f"{_SRVCLI}/package.xml", how="manifest"
        ),
        Hand(
            r"<depend>tutorial_interfaces", heading="pub/sub", file="ros2_ws/src/cpp_pubsub/package.xml", how="manifest"
        ),
        Hand(
            r"<depend>tutorial_interfaces",
            heading="service/client",
            file="ros2_ws/src/cpp_srvcli/package.xml",
            how="manifest",
        ),
        Hand(r"add_executable\(talker", skip="C++"),
        Hand(r"add_executable\(server", skip="C++"),
    ),
    "Py": (
        Hand(r"class FibonacciActionServer[\s\S]*def main", file="fibonacci_action_server.py"),
        Hand(r"class FibonacciActionClient[\s\S]*def main", file="fibonacci_action_client.py"),
    ),
    "Configuring-ROS2-Environment": (
        Hand(r"export ROS_DOMAIN_ID=<", instead=[("<your_domain_id>", "7")]),
        Hand(r"echo .export ROS_DOMAIN_ID=<", instead=[("<your_domain_id>", "7")]),
    ),
    "Understanding-ROS2-Topics": (Hand(r"^geometry_msgs/msg/Twist$", skip="only names a type"),),
    "Using-Rqt-Console": (Hand(r"^Fatal$", skip="names of levels"),),
    "Getting-Started-With-Ros2doctor": (
        Hand(r"^UserWarning: Publisher without", of="ros2 doctor"),
        Hand(r"^UserWarning: Subscriber without", of="ros2 doctor"),
        Hand(r"^distribution name", of="ros2 doctor --report"),
    ),
    "Launch-system": (
        Hand(r"install\(DIRECTORY", file="launch_ws/src/cpp_launch_example/CMakeLists.txt", how="cmake"),
        *(
            Hand(
                pattern,
                heading="Writing",
                file=" ".join(
                    f"launch_ws/src/{package}/launch/{name}" for package in ("py_launch_example", "cpp_launch_example")
                ),
            )
            for pattern, name in (
                (r"^import launch", "my_script_launch.py"),
                (r"<launch>", "my_script_launch.xml"),
                (r"^launch:", "my_script_launch.yaml"),
            )
        ),
    ),
    "Monitoring-For-Parameter-Changes-Python": (
        Hand(
            r"self\.callback_handle = self",
            heading="3.1",
            file="ros2_ws/src/python_parameter_event_handler/python_parameter_event_handler/parameter_event_handler.py",
            how=r"after ^        \)(?=\n\n    def callback)",
        ),
    ),
    "Composition": (
        Hand(r"ros2 component load /ComponentManager .*(Cam2Image|--node-name talker2)", interrupt="MyContainer"),
        Hand(r"ros2 run rclcpp_components component_container", interrupt="composition"),
        Hand(r"ros2 component (list|load)", interrupt="composition_demo"),
    ),
    "Logging-and-logger-configuration": (
        Hand(
            r"ros2 service list",
            # The page shows the line that makes the node; a reader puts it into the smallest program.
            before=(
                _NODE_WITH_LOGGER_SERVICE,
                "python3 node.py &",
                "until ros2 node list | grep -q NodeWith; do sleep 0.2; done",
            ),
        ),
    ),
    "Service-Introspection": (
        Hand(
            r"ros2 service echo",
            before=(
                "ros2 param set /introspection_service service_configure_introspection contents",
                "ros2 param set /introspection_client client_configure_introspection metadata",
            ),
        ),
    ),
    "Quality-of-Service": (
        Hand(
            r"tc qdisc",
            skip="system: would disturb the network of the machine that plays, which messages do not use here",
        ),
    ),
    "dummy-robot-demo": (
        Hand(r"process started with pid", of="ros2 launch dummy_robot_bringup dummy_robot_bringup_launch.py"),
    ),
    "Recording-A-Bag-From-Your-Own-Node-Py": (Hand(r"data_generator_node$", lasts=12.0),),
    "Recording-And-Playing-Back-Data": (
        Hand(
            r"ros2 bag (info|play) .*<bag_file_name>",
            instead=[("<bag_file_name>", "<BAG>")],
            interrupt="ros2 bag record",
        ),
    ),
    "Launch-file-different-formats": (
        Hand(r"def generate", tab="Python", file="example_launch.py"),
        Hand(r"<launch>", tab="XML", file="example_launch.xml"),
        Hand(r"^launch:", tab="YAML", file="example_launch.yaml"),
        Hand(
            r"background_r:=255",
            heading="arguments",
            instead=[
                ("<package_name> <launch_file_name>", "example_launch.xml"),
                ("<path_to_launch_file>", "example_launch.py"),
            ],
        ),
        Hand(r"ros2 launch <path", instead=[("<path_to_launch_file>", "example_launch.yaml")]),
    ),
    "Launching-composable-nodes": (
        Hand(r"LoadComposableNodes\(", file="load_launch.py"),
        *(
            Hand(r"image_container", tab=tab, file=f"container_launch.{kind}")
            for tab, kind in (("Python", "py"), ("XML", "xml"), ("YAML", "yaml"))
        ),
        Hand(r"ros2 launch <path", instead=[("<path_to_launch_file>", "load_launch.py")]),
    ),
    "Node-arguments": (
        Hand(
            r"my_package node_executable|package_name executable_name", skip="page: only shows how such commands look"
        ),
        Hand(r"^parameter_blackboard:", file="demo_params.yaml"),
    ),
    "Overriding-QoS-Policies-For-Recording-And-Playback": (
        Hand(r"transient_local\n", file="durability_override.yaml"),
        Hand(r"reliability: best_effort", file="reliability_override.yaml"),
        Hand(r"ros2 bag record", lasts=3.0),
        Hand(r"ros2 bag play", interrupt="ros2 bag record"),
    ),
    "Using-callback-groups": (
        Hand(r"class ServiceNode", file="service.py"),
        Hand(r"class CallbackGroupDemo", file="client.py"),
    ),
    "Using-ros2-param": (
        Hand(
            r"ros2 param list /my_node",
            before=(
                "ros2 run demo_nodes_cpp parameter_blackboard --ros-args -r __node:=my_node -p my_string:=hello &",
                "until ros2 node list | grep -q my_node; do sleep 0.2; done",
            ),
        ),
        Hand(r"^ros param", skip="page: a misprint, 'ros' for 'ros2'"),
        Hand(r"ros2 param load", before=("ros2 param dump /my_node > my_node.yaml",)),
    ),
}
