"""The tools that are there, and the one in use (rviz_common/tool_manager.cpp)."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from day6_core.ros.programs.rviz2.model.missing import missing_class
from day6_core.ros.programs.rviz2.model.properties import GROUP, Property
from day6_core.ros.programs.rviz2.model.tools import TYPES, tool_class
from day6_core.ros.programs.rviz2.model.tools.interact import Interact
from day6_core.ros.programs.rviz2.model.tools.tool import FailedTool, Tool

if TYPE_CHECKING:
    from day6_core.ros.programs.rviz2.model.manager import RViz
    from day6_core.ros.programs.rviz2.model.scene import Scene

PACKAGE = "rviz_default_plugins/"


class Toolbox:
    """All on the program's thread, but for reading. The first tool is the default one, to which a finished one gives way."""

    def __init__(self, rviz: RViz) -> None:
        self._rviz = rviz
        self.properties = Property("Tool Properties", GROUP)
        """Those of the tools that have any."""
        self.tools: list[Tool] = []
        self.current: Tool | None = None

    @property
    def default(self) -> Tool | None:
        """The first one that could be loaded."""
        return next((tool for tool in self.tools if not isinstance(tool, FailedTool)), None)

    def load(self, config: Any) -> None:
        """Replace the tools by those of a .rviz file's list."""
        self.close()
        tools: list[Tool] = []
        for entry in config if isinstance(config, list) else ():
            if isinstance(entry, dict) and "Class" in entry:
                tool = self._make(str(entry["Class"]))
                tool.load(entry)
                tool.open()
                tools.append(tool)
        self.tools = tools
        for tool in tools:
            if tool.children:
                self.properties.add(tool)
                tool.expanded = True
        self._rviz.tree_changed()
        self.choose(self.default)

    def _make(self, class_id: str) -> Tool:
        type_name = class_id.removeprefix(PACKAGE)
        if class_id.startswith(PACKAGE) and type_name in TYPES:
            return tool_class(type_name)(self._rviz)
        missing = missing_class(class_id)
        self._rviz.log_missing(missing)
        return FailedTool(self._rviz, class_id, missing)

    def save(self) -> list[dict[str, Any]]:
        """What a .rviz file holds of them."""
        return [tool.save() for tool in self.tools]

    def close(self) -> None:
        """Take all of them away."""
        self.choose(None)
        for tool in self.tools:
            tool.close()
            self.properties.remove(tool)
        self.tools = []

    @property
    def interact(self) -> Interact | None:
        """The tool for interactive markers, if there is one."""
        return next((tool for tool in self.tools if isinstance(tool, Interact)), None)

    # -- choosing ------------------------------------------------------------------------------------------------------

    def with_key(self, key: str) -> Tool | None:
        """The tool that a letter chooses."""
        return next((tool for tool in self.tools if tool.key == key), None)

    def choose(self, tool: Tool | None) -> None:
        """Use a tool from now on."""
        if self.current is not None:
            self.current.deactivate()
        self.current = tool
        if tool is not None:
            tool.activate()
        self._rviz.touch()

    def toggle(self, tool: Tool) -> None:
        """A tool's letter: the tool, or the default one if it is in use already."""
        self.choose(self.default if tool is self.current else tool)

    def to_default(self) -> None:
        """Esc."""
        self.choose(self.default)

    # -- using ---------------------------------------------------------------------------------------------------------

    def use(self, tool: Tool, action: Callable[[Tool], bool]) -> None:
        """Let a tool do something, if it is still the one in use; once it has done its work, the default one comes back."""
        if tool is not self.current:
            return
        if action(tool):
            self.to_default()
        self._rviz.touch()

    def draw(self, scene: Scene) -> None:
        """Add what the tools show; a measured line stays while another one is used."""
        for tool in self.tools:
            tool.draw(scene)
