"""Which plugins rqt has, in the groups and order of its menu."""

from __future__ import annotations

from typing import NamedTuple

from day6_core.ros.program_index import executables


class Entry(NamedTuple):
    """One plugin, as the `plugin.xml` of its package describes it."""

    group: str
    title: str
    name: str
    """`<package>/<class>`, by which perspectives name it."""
    type: str
    """Module and class of the real plugin, which `rqt --list-plugins` prints and `rqt --standalone` looks in."""

    @property
    def package(self) -> str:
        return self.name.partition("/")[0]


KNOWN = (
    Entry("Actions", "Action Type Browser", "rqt_action/ActionPlugin", "rqt_action.action_plugin.ActionPlugin"),
    Entry("Configuration", "Dynamic Reconfigure", "rqt_reconfigure/Param", "rqt_reconfigure.param_plugin.ParamPlugin"),
    Entry("Introspection", "Node Graph", "rqt_graph/RosGraph", "rqt_graph.ros_graph.RosGraph"),
    Entry("Logging", "Bag", "rqt_bag/Bag", "rqt_bag.bag.Bag"),
    Entry("Logging", "Console", "rqt_console/Console", "rqt_console.console.Console"),
    Entry("Logging", "Logger Level", "rqt_logger_level/LoggerLevel", "rqt_logger_level.logger_level.LoggerLevel"),
    Entry("Miscellaneous Tools", "Python Console", "rqt_py_console/PyConsole", "rqt_py_console.py_console.PyConsole"),
    Entry("Miscellaneous Tools", "Shell", "rqt_shell/Shell", "rqt_shell.shell.Shell"),
    Entry("Robot Tools", "Robot Steering", "rqt_robot_steering/RobotSteering",
          "rqt_robot_steering.robot_steering.RobotSteering"),
    Entry("Services", "Service Caller", "rqt_service_caller/ServiceCaller",
          "rqt_service_caller.service_caller.ServiceCaller"),
    Entry("Services", "Service Type Browser", "rqt_srv/Services", "rqt_srv.services.Services"),
    Entry("Topics", "Message Publisher", "rqt_publisher/Publisher", "rqt_publisher.publisher.Publisher"),
    Entry("Topics", "Message Type Browser", "rqt_msg/Messages", "rqt_msg.messages.Messages"),
    Entry("Topics", "Topic Monitor", "rqt_topic/TopicPlugin", "rqt_topic.topic.Topic"),
    Entry("Visualization", "Image View", "rqt_image_view/ImageView", "rqt_image_view/ImageView"),
    Entry("Visualization", "Plot", "rqt_plot/Plot", "rqt_plot.plot.Plot"),
    Entry("Visualization", "TF Tree", "rqt_tf_tree/RosTfTree", "rqt_tf_tree.tf_tree.RosTfTree"),
)  # fmt: skip


def plugins() -> tuple[Entry, ...]:
    """Return the plugins that there are here, in the order of the menu."""
    return tuple(entry for entry in KNOWN if entry.package in executables(entry.package))


def matching(word: str) -> list[Entry]:
    """Return the plugins that a word of the command line may name: it is a part of their name or type, in any case."""
    return [entry for entry in plugins() if word.lower() in entry.name.lower() or word.lower() in entry.type.lower()]
