"""Which plugins rqt has, in the groups and order of its menu."""

from __future__ import annotations

from typing import NamedTuple

from day6_tui.core.ros.program_index import executables


class Entry(NamedTuple):
    """One plugin: its group in rqt's menu, its title there, and its name in ROS, `<package>/<class>`.

    The package's executable of the same name runs it alone; that module's `Plugin` subclass is named by `class_name`.
    """

    group: str
    title: str
    name: str
    class_name: str

    @property
    def package(self) -> str:
        return self.name.partition("/")[0]


KNOWN = (
    Entry("Actions", "Action Type Browser", "rqt_action/ActionPlugin", "ActionPlugin"),
    Entry("Configuration", "Dynamic Reconfigure", "rqt_reconfigure/Param", "ReconfigurePlugin"),
    Entry("Introspection", "Node Graph", "rqt_graph/RosGraph", "RosGraphPlugin"),
    Entry("Logging", "Bag", "rqt_bag/Bag", "BagPlugin"),
    Entry("Logging", "Console", "rqt_console/Console", "ConsolePlugin"),
    Entry("Logging", "Logger Level", "rqt_logger_level/LoggerLevel", "LoggerLevelPlugin"),
    Entry("Miscellaneous Tools", "Shell", "rqt_shell/Shell", "ShellPlugin"),
    Entry("Services", "Service Caller", "rqt_service_caller/ServiceCaller", "ServiceCallerPlugin"),
    Entry("Services", "Service Type Browser", "rqt_srv/ServiceTypeBrowser", "ServiceTypePlugin"),
    Entry("Topics", "Message Publisher", "rqt_publisher/Publisher", "PublisherPlugin"),
    Entry("Topics", "Message Type Browser", "rqt_msg/Messages", "MessageTypePlugin"),
    Entry("Topics", "Topic Monitor", "rqt_topic/TopicPlugin", "TopicMonitorPlugin"),
    Entry("Visualization", "Image View", "rqt_image_view/ImageView", "ImageViewPlugin"),
    Entry("Visualization", "Plot", "rqt_plot/Plot", "PlotPlugin"),
    Entry("Visualization", "TF Tree", "rqt_tf_tree/RosTfTree", "TfTreePlugin"),
)
"""The `plugin.xml` of each package names them, with their groups."""


def plugins() -> tuple[Entry, ...]:
    """Return the plugins that there are here, in the order of the menu."""
    return tuple(entry for entry in KNOWN if entry.package in executables(entry.package))


def find(word: str) -> Entry | None:
    """Return the plugin that a word of the command line names: a package, a plugin's name, or a part that only one has."""
    fitting = [entry for entry in plugins() if word.lower() in f"{entry.name} {entry.title}".lower()]
    exact = [entry for entry in fitting if word in (entry.package, entry.name)]
    return (exact or fitting)[0] if exact or len(fitting) == 1 else None
