"""Classes of a .rviz file that aren't here: what each is, in one line of words.

The file keeps them: who opens it with a real RViz that has the plugin sees them again.
"""

from __future__ import annotations

from day6_core.ros.programs.remark import Remark
from day6_core.ros.programs.rviz2.model.displays import TYPES
from day6_core.ros.programs.rviz2.model.tools import TYPES as TOOLS

KNOWN = {
    "nav2_rviz_plugins/ParticleCloud": "particles",
    "nav2_rviz_plugins/GoalTool": "nav2_goal",
    "nav2_rviz_plugins/": "nav2",
    "moveit_rviz_plugin/": "moveit",
    "slam_toolbox::": "slam_toolbox",
    "slam_toolbox_rviz_plugin/": "slam_toolbox",
    "rviz_imu_plugin/": "imu",
    "rviz/": "ros1",
    "rviz_default_plugins/": "misspelt",
    "rviz_common/": "misspelt",
}
"""How a class begins, the longest first -> the text `rviz.missing.<…>`."""


def missing_class(class_id: str) -> Remark:
    """That the class of a display, tool or panel isn't here."""
    key = next((key for begin, key in KNOWN.items() if class_id.startswith(begin)), "plugin")
    package, _, name = class_id.partition("/")
    if key == "ros1" and name in (*TYPES, *TOOLS):
        key = "ros1_same"
    return Remark.of("error", f"rviz.missing.{key}", type=class_id, package=package or "?", name=name)
