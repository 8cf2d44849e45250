"""Which plugins rqt has, in the groups and order of its menu."""

from __future__ import annotations

from typing import NamedTuple

from day6_core.ros.program_index import executables


class PluginEntry(NamedTuple):
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
    PluginEntry("Actions", "Action Type Browser", "rqt_action/ActionPlugin", "rqt_action.action_plugin.ActionPlugin"),
    PluginEntry("Configuration", "Dynamic Reconfigure", "rqt_reconfigure/Param", "rqt_reconfigure.param_plugin.ParamPlugin"),
    PluginEntry("Introspection", "Node Graph", "rqt_graph/RosGraph", "rqt_graph.ros_graph.RosGraph"),
    PluginEntry("Logging", "Bag", "rqt_bag/Bag", "rqt_bag.bag.Bag"),
    PluginEntry("Logging", "Console", "rqt_console/Console", "rqt_console.console.Console"),
    PluginEntry("Logging", "Logger Level", "rqt_logger_level/LoggerLevel", "rqt_logger_level.logger_level.LoggerLevel"),
    PluginEntry("Miscellaneous Tools", "Python Console", "rqt_py_console/PyConsole", "rqt_py_console.py_console.PyConsole"),
    PluginEntry("Miscellaneous Tools", "Shell", "rqt_shell/Shell", "rqt_shell.shell.Shell"),
    PluginEntry("Robot Tools", "Robot Steering", "rqt_robot_steering/RobotSteering",
                "rqt_robot_steering.robot_steering.RobotSteering"),
    PluginEntry("Services", "Service Caller", "rqt_service_caller/ServiceCaller",
                "rqt_service_caller.service_caller.ServiceCaller"),
    PluginEntry("Services", "Service Type Browser", "rqt_srv/Services", "rqt_srv.services.Services"),
    PluginEntry("Topics", "Message Publisher", "rqt_publisher/Publisher", "rqt_publisher.publisher.Publisher"),
    PluginEntry("Topics", "Message Type Browser", "rqt_msg/Messages", "rqt_msg.messages.Messages"),
    PluginEntry("Topics", "Topic Monitor", "rqt_topic/TopicPlugin", "rqt_topic.topic.Topic"),
    PluginEntry("Visualization", "Image View", "rqt_image_view/ImageView", "rqt_image_view/ImageView"),
    PluginEntry("Visualization", "Plot", "rqt_plot/Plot", "rqt_plot.plot.Plot"),
    PluginEntry("Visualization", "TF Tree", "rqt_tf_tree/RosTfTree", "rqt_tf_tree.tf_tree.RosTfTree"),
)  # fmt: skip


def plugins() -> tuple[PluginEntry, ...]:
    """Return the plugins that there are here, in the order of the menu."""
    return tuple(entry for entry in KNOWN if entry.package in executables(entry.package))


def matching(word: str) -> list[PluginEntry]:
    """Return the plugins that a word of the command line may name: it is a part of their name or type, in any case."""
    return [entry for entry in plugins() if word.lower() in entry.name.lower() or word.lower() in entry.type.lower()]
