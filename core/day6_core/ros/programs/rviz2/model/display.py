"""The base of all displays: a check box, properties, statuses, a place in the .rviz file, and a part of the scene.

User interfaces on other threads change properties only; a display acts on that in `update`, on the program's thread.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_core.ros.programs.rviz2.model.properties import BOOL, Property
from day6_core.ros.programs.rviz2.model.status import ERROR, OK, Status, StatusList

if TYPE_CHECKING:
    from day6_core.ros.programs.remark import Remark
    from day6_core.ros.programs.rviz2.model.manager import RViz
    from day6_core.ros.programs.rviz2.model.scene import Scene
    from day6_urdf.model import Vector


class Display(Property):
    """One display. Its value is whether it is enabled; `type` is the last part of the class name in .rviz files."""

    type = ""
    message_type = ""
    """The type of the messages it shows, for Add by topic."""
    selectable = False
    """Whether what it shows can be picked: those that have a selection handler in RViz."""

    def __init__(self, rviz: RViz, name: str) -> None:
        super().__init__(name, BOOL, True)
        self.rviz = rviz
        self.statuses = StatusList("Status")
        self.unknown: dict[str, Any] = {}
        """What a .rviz file said that this display does not know; it is written back."""
        self._was_enabled = False
        self._fixed = ""
        self.build()

    @property
    def class_id(self) -> str:
        return f"rviz_default_plugins/{self.type}"

    @property
    def enabled(self) -> bool:
        """Whether its own check box is set, and that of every group around it."""
        return bool(self.value) and (self.parent.enabled if isinstance(self.parent, Display) else True)

    @property
    def displays(self) -> list[Display]:
        """Those of a group, in the order of the panel."""
        return [child for child in self.children if isinstance(child, Display)]

    @property
    def should_be_saved(self) -> bool:
        return False  # not as a property of its group

    # -- for subclasses ------------------------------------------------------------------------------------------------

    def build(self) -> None:
        """Add the properties."""

    def choose_topic(self, topic: str) -> None:
        """It is added to show a topic; those of none have no choice."""

    def on_enable(self) -> None:
        """The check box was set."""

    def on_disable(self) -> None:
        """The check box was cleared, or the display goes away."""

    def on_fixed_frame(self) -> None:
        """Another Fixed Frame; by default everything is forgotten, as for all displays of messages."""
        self.reset()

    def reset(self) -> None:
        """Forget what was received."""
        self.clear_statuses()

    def refresh(self) -> None:
        """Called for every picture while enabled: transforms and statuses."""

    def draw(self, scene: Scene) -> None:
        """Add to the scene; called after `refresh` while enabled."""

    def thing_at(self, key: Any, point: Vector) -> Any:
        """Which thing is at a point of what was drawn as `key`, for those that draw many as one."""
        return key

    def describe(self, key: Any) -> tuple[str, list[Property]] | None:
        """What the panel Selection says of the thing `key`: its name and its properties; None if it is gone."""
        return None

    # -- called by RViz ------------------------------------------------------------------------------------------------

    def update(self) -> None:
        """Follow what the user changed, then refresh."""
        if self.enabled != self._was_enabled:
            self._was_enabled = self.enabled
            if self.enabled:
                self._fixed = self.rviz.fixed_frame
                self.on_enable()
            else:
                self.on_disable()
                self.clear_statuses()
        if not self.enabled:
            return
        if self._fixed != self.rviz.fixed_frame:
            self._fixed = self.rviz.fixed_frame
            self.on_fixed_frame()
        self.refresh()

    def close(self) -> None:
        """The display is removed."""
        if self._was_enabled:
            self._was_enabled = False
            self.on_disable()

    # -- statuses ------------------------------------------------------------------------------------------------------

    def put_status(self, level: int, name: str, text: str) -> None:
        """Set a line of the status list; the list appears as the first property with the first line."""
        if self.statuses.put(level, name, text):
            self.rviz.tree_changed()
        if self.statuses not in self.children:
            self.add(self.statuses, 0)

    def drop_status(self, name: str) -> None:
        if self.statuses.drop(name):
            self.rviz.tree_changed()

    def clear_statuses(self) -> None:
        if self.statuses.children:
            self.statuses.clear()
            self.rviz.tree_changed()

    def status(self, name: str) -> tuple[str, str] | None:
        """Word and text of a status line: ('Ok', 'Transform OK')."""
        return self.statuses.line(name)

    def transform_ok(self) -> None:
        self.put_status(OK, "Transform", "Ok")

    def transform_missing(self, frame: str) -> None:
        self.put_status(ERROR, "Transform", f"Could not transform from [{frame}] to [{self.rviz.fixed_frame}]")

    # -- configuration -------------------------------------------------------------------------------------------------

    def save(self) -> dict[str, Any]:
        saved = {child.name: child.save() for child in self.children if child.should_be_saved}
        saved.update(self.save_extras())
        saved["Class"] = self.class_id
        saved["Name"] = self.name
        saved["Enabled"] = saved["Value"] = bool(self.value)
        return {**self.unknown, **saved}

    def load(self, config: Any) -> None:
        if not isinstance(config, dict):
            return
        known = {child.name for child in self.children} | {"Class", "Name", "Enabled", "Value"}
        for child in self.children:
            if child.name in config and child.should_be_saved:
                child.load(config[child.name])
        if "Name" in config:
            self.name = str(config["Name"])
        if "Enabled" in config:
            self.value = bool(config["Enabled"])
        self.unknown = {key: value for key, value in config.items() if key not in known}
        self.load_extras(config)

    def save_extras(self) -> dict[str, Any]:
        """What is saved beside the properties."""
        return {}

    def load_extras(self, config: dict[str, Any]) -> None:
        """Take over what `save_extras` wrote."""

    def changed(self) -> None:
        """Let a property's change be seen: for `on_change`."""
        self.rviz.touch()


class FailedDisplay(Display):
    """Stands for a display of a .rviz file that there is no class for; the file's words are kept (failed_display.cpp).

    The original says why in its description, in HTML; here it is a status.
    """

    def __init__(self, rviz: RViz, name: str, class_id: str, missing: Remark) -> None:
        self._class_id, self._missing = class_id, missing
        super().__init__(rviz, name)
        self.config: dict[str, Any] = {}

    @property
    def class_id(self) -> str:
        return self._class_id

    @property
    def missing(self) -> Remark:
        """What the class is, and that it isn't here."""
        return self._missing

    def load(self, config: Any) -> None:
        self.config = dict(config)
        self.name = str(config.get("Name", self.name))
        self.value = bool(config.get("Enabled", True))

    def save(self) -> dict[str, Any]:
        return {**self.config, "Name": self.name, "Enabled": bool(self.value), "Value": bool(self.value)}

    def refresh(self) -> None:
        self.put_status(ERROR, "Class", self._missing.text)


__all__ = ["Display", "FailedDisplay", "Status"]
