"""The part `Panels` of a .rviz file: which lines of the panel are open."""

from __future__ import annotations

from typing import Any

from day6_core.ros.programs.rviz2.model.properties import Property
from day6_core.ros.programs.rviz2.model.status import StatusList

HERE = ("Displays", "Help", "Selection", "Time", "Tool Properties", "Transformation", "Views")
"""Panels of rviz_common. Help and Transformation have nothing to choose here."""


def missing_panels(panels: Any) -> list[str]:
    """The classes of a file's panels that aren't here."""
    named = [str(panel.get("Class")) for panel in panels if isinstance(panel, dict)] if isinstance(panels, list) else []
    return [class_id for class_id in named if class_id not in {f"rviz_common/{name}" for name in HERE}]


def load_expanded(root: Property, panels: Any) -> None:
    """Open the branches that the panel `Displays` of a file names, and close the others."""
    for panel in panels if isinstance(panels, list) else ():
        tree = panel.get("Property Tree Widget") if isinstance(panel, dict) else None
        if not isinstance(tree, dict) or panel.get("Class") != "rviz_common/Displays":
            continue
        expanded = tree.get("Expanded")
        wanted = {str(path) for path in expanded} if isinstance(expanded, list) else set()
        for prop in root.walk():
            if prop is not root and prop.children:
                prop.expanded = expanded_path(prop) in wanted
        for prop in root.children:
            if isinstance(prop, StatusList):  # default.rviz calls it by an older name
                prop.expanded = bool({"/Global Status1", "/Status1"} & wanted)


def save_panels(root: Property, panels: Any) -> list[Any]:
    """The panels of a file with the branches that are open now; the other panels stay as they are."""
    expanded = [expanded_path(prop) for prop in root.walk() if prop.expanded and prop.children]
    found = list(panels) if isinstance(panels, list) else []
    for index, panel in enumerate(found):
        if isinstance(panel, dict) and panel.get("Class") == "rviz_common/Displays":
            tree = panel.get("Property Tree Widget")
            tree = {**(tree if isinstance(tree, dict) else {}), "Expanded": expanded or None}
            found[index] = {**panel, "Property Tree Widget": tree}
            return found
    tree = {"Expanded": expanded or None, "Splitter Ratio": 0.5}
    return [{"Class": "rviz_common/Displays", "Name": "Displays", "Property Tree Widget": tree}, *found]


def expanded_path(prop: Property) -> str:
    """The path of RViz's list of expanded lines: every name with its number among brothers of the same name."""
    parts = []
    each: Property | None = prop
    while each is not None and each.parent is not None:
        name = each.word if isinstance(each, StatusList) else each.name
        brothers = [other for other in each.parent.children if other.name == each.name]
        number = next((index for index, other in enumerate(brothers, 1) if other is each), 1)
        parts.append(f"{name}{number}")
        each = each.parent
    return "/" + "/".join(reversed(parts))
