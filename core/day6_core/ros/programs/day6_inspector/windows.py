"""What the open windows show that is wrong: RViz's statuses, and the remarks below the world."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, cast

from day6_core.ros.programs.day6_inspector.facts import RVizView

if TYPE_CHECKING:
    from day6_core.ros.programs.day6_world.model import WorldModel
    from day6_core.ros.programs.rviz2.model.displays.robot_model import RobotModelDisplay
    from day6_core.ros.programs.rviz2.model.manager import RViz
    from day6_core.session.display import Window

ROBOT_MODEL = "RobotModel"


def rviz_views(windows: Sequence[Window[object]]) -> tuple[RVizView, ...]:
    """Return the facts about the RViz windows."""
    return tuple(_rviz_view(cast("RViz", each.model)) for each in windows if each.kind == "rviz2")


def _rviz_view(rviz: RViz) -> RVizView:
    enabled = [display for display in rviz.displays if display.enabled]
    models = [cast("RobotModelDisplay", each) for each in enabled if each.type == ROBOT_MODEL]
    lost = sorted({link for model in models for link in model.lost})
    return RVizView(
        rviz.fixed_frame,
        tuple(rviz.frame_names()),
        tuple(each.type for each in enabled),
        any(model.parts.robot is not None for model in models),
        str(models[0].topic.value) if models else "",
        tuple(lost),
    )


def world_remarks(windows: Sequence[Window[object]]) -> tuple[tuple[str, tuple[tuple[str, object], ...]], ...]:
    """Return the errors and warnings below the worlds."""
    return tuple(
        (remark.id, remark.parameters)
        for each in windows
        if each.kind == "world"
        for remark in cast("WorldModel", each.model).snapshot().status
        if remark.level in ("error", "warning")
    )


def watched(windows: Sequence[Window[object]]) -> int:
    """Return how many windows these two functions look at."""
    return sum(each.kind in ("rviz2", "world") for each in windows)
