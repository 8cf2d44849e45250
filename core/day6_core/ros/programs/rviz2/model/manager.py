"""RViz itself: the displays, the Fixed Frame, the view, the configuration (rviz_common/visualization_manager.cpp).

All of it lives on the program's thread, where `tick` follows what changed. A user interface on another thread reads `scene`,
`root` and `view`, changes the view directly, and everything else by `request`.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from day6_core.ros.programs.rviz2.model.config import read_config
from day6_core.ros.programs.rviz2.model.display import Display, FailedDisplay
from day6_core.ros.programs.rviz2.model.displays import display_class, type_of, types_for
from day6_core.ros.programs.rviz2.model.frames import FrameBuffer, FrameLookups
from day6_core.ros.programs.rviz2.model.missing import missing_class
from day6_core.ros.programs.rviz2.model.panels import load_expanded, missing_panels, save_panels
from day6_core.ros.programs.rviz2.model.properties import (
    COLOUR,
    ENUM,
    FIXED_FRAME,
    FRAME,
    GROUP,
    INT,
    TEXT,
    Property,
)
from day6_core.ros.programs.rviz2.model.scene import Scene
from day6_core.ros.programs.rviz2.model.selection import Selection
from day6_core.ros.programs.rviz2.model.status import ERROR, OK, WARN, Status, StatusList
from day6_core.ros.programs.rviz2.model.tools.toolbox import Toolbox
from day6_core.ros.programs.rviz2.model.views import VIEWS, Orbit, SavedView, View, copied, type_property
from day6_core.session.task import Signal
from rclpy.clock import ClockChange, JumpThreshold, TimeJump
from rclpy.duration import Duration

if TYPE_CHECKING:
    from day6_core.ros.programs.remark import Remark
    from rclpy.node import Node

QUALITIES = ("High", "Medium", "Low")

TIMES = ("ROS Time", "ROS Elapsed", "Wall Time", "Wall Elapsed")
"""The lines of RViz's Time panel."""

RobotReader = Callable[[str, str, bool, Callable[[Any], None], Callable[[], bool]], None]
MeshReader = Callable[[str, bool, Callable[[Any], None]], None]
"""Take, beside a text or URI, whether it came from this machine (see `MeshStore`)."""


class RViz:
    """One RViz.

    `timer_ns` is the time that timers run by, by which things in the picture grow old; `system_ns` is the machine's.
    """

    def __init__(
        self, node: Node, buffer: FrameBuffer, timer_ns: Callable[[], int], system_ns: Callable[[], int]
    ) -> None:
        self.node = node
        self.timer_ns = timer_ns
        self._system_ns = system_ns
        self.frames = FrameLookups(buffer)
        self.scene = Scene()
        self.version = 0
        """Grows with every new scene or status."""
        self.tree_version = 0
        """Grows when lines of the panel come, go or change their words."""
        self.loaded = 0
        """Grows with every configuration that is loaded."""
        self.wake: Callable[[], None] = lambda: None
        """Asks for a tick soon; any thread."""
        self.urgent = Signal()
        """Set when a user asked for something."""
        self.pace = 0.0
        """Seconds between two pictures that the viewer can show."""
        self.read_robot: RobotReader = lambda text, folder, trusted, done, cancelled: None
        self.read_mesh: MeshReader = lambda uri, trusted, done: None
        self.is_of_this_machine: Callable[[bytes | None], bool] = lambda gid: False
        """Says of the gid of a publisher whether it belongs to a process of this user on this machine."""
        self.read_file: Callable[[str, Callable[[str], None]], None] = lambda path, done: None
        self.path: Callable[[str], Path] = Path
        """The file that a name means to the program."""
        self.write_file: Callable[[Path, str], None] = lambda path, text: None
        self.interaction = False
        """Whether the controls of interactive markers can be used, and are seen."""
        self.menu: list[tuple[str, Callable[[], object]]] | None = None
        """Titles and actions that the user shall choose from, until a window shows them."""
        self.progress = ""
        """What is being loaded, and how much of it."""
        self.message: tuple[str, dict[str, Any]] | None = None
        """A sentence for the user: key of the catalogue and parameters."""
        self.config_file: Path | None = None
        self.default_file: Path | None = None
        """Where Save puts a configuration that was never named."""
        self.modified = False
        self._config: dict[str, Any] = {}
        self._missing: set[Remark] = set()
        """Classes of the file that were told of."""
        self._requests: deque[Callable[[], object]] = deque()
        self._dirty = True
        self._redraw = True
        self._shown: object = None
        """Where the view is, and every value of the panel, as of the present scene."""
        buffer.on_data = self._data_came
        self._build()
        threshold = JumpThreshold(min_forward=None, min_backward=Duration(nanoseconds=-1), on_clock_change=True)
        self._jumps = node.get_clock().create_jump_callback(threshold, post_callback=self._time_jumped)

    def _build(self) -> None:
        self.root = Property("root")
        self.options = self.root.add(Property("Global Options", GROUP))
        self.fixed = self.options.add(
            Property("Fixed Frame", FRAME, "base_link", options=self.frame_names, on_change=self._fixed_changed)
        )
        self.background = self.options.add(Property("Background Color", COLOUR, (48, 48, 48), on_change=self.touch))
        self.frame_rate = self.options.add(Property("Frame Rate", INT, 30, low=1, high=60, on_change=self.touch))
        self.options.expanded = True
        self.statuses = StatusList("Global Status")
        self.statuses.expanded = True
        self.root.add(self.statuses)
        # The article's "Performance"; RViz has no such group, so it is written only when somebody used it.
        self.performance = self.root.add(Property("Performance", GROUP))
        self.quality = self.performance.add(
            Property("Quality", ENUM, QUALITIES[0], options=QUALITIES, on_change=self.touch)
        )
        self.time = Property("Time", GROUP)
        self._times = [self.time.add(Property(name, TEXT, "", read_only=True)) for name in TIMES]
        self._began: tuple[int, int] | None = None
        self.view_type = type_property(self._view_type_changed)
        self.views = Property("Views", GROUP)
        self.view: View = Orbit(self.frame_choices, self._view_touched)
        self.views.add(self.view_type)
        self.views.add(self.view)
        self.view_version = 0
        self.tools = Toolbox(self)
        self.selection = Selection(self)
        self.frames.fixed = self.fixed_frame

    # -- what displays ask for -----------------------------------------------------------------------------------------

    @property
    def fixed_frame(self) -> str:
        return str(self.fixed.value)

    @property
    def displays(self) -> list[Display]:
        """In the order of the panel: groups, and what is in them after them."""
        found, waiting = [], self.outermost[::-1]
        while waiting:
            display = waiting.pop()
            found.append(display)
            waiting += display.displays[::-1]
        return found

    @property
    def outermost(self) -> list[Display]:
        """Those that are in no group."""
        return [child for child in self.root.children if isinstance(child, Display)]

    @property
    def panels(self) -> list[Property]:
        """The lines of all panels: Displays, Views, Selection, Tool Properties, Time."""
        shown = [panel for panel in (self.selection.properties, self.tools.properties) if panel.children]
        return [*self.root.children, self.views, *shown, self.time]

    def now_ns(self) -> int:
        """ROS time, for what is measured."""
        return int(self.node.get_clock().now().nanoseconds)

    def frame_names(self) -> list[str]:
        """Choices for the Fixed Frame: the frames in /tf."""
        return self.frames.names()

    def frame_choices(self) -> list[str]:
        """Choices for the frame of a display: `<Fixed Frame>`, and the frames in /tf."""
        return [FIXED_FRAME, *self.frames.names()]

    def topics(self) -> list[tuple[str, list[str]]]:
        """Topics with publishers or subscriptions, and their types."""
        return self.node.get_topic_names_and_types()

    def touch(self) -> None:
        """Something changed that may be seen."""
        self._dirty = True
        self.wake()

    def tree_changed(self) -> None:
        """Lines of the panel are others now."""
        self.tree_version += 1
        self._redraw = True

    def log_info(self, text: str) -> None:
        self.node.get_logger().info(text)

    def log_error(self, text: str) -> None:
        self.node.get_logger().error(text)

    def log_missing(self, missing: Remark) -> None:
        """Tell of a class of the file that isn't here, once."""
        if missing not in self._missing:
            self._missing.add(missing)
            self.log_error(missing.text)

    def hint(self, key: str, **parameters: Any) -> None:
        """Show the user a message in the window, in plain words."""
        self.message = (key, parameters)
        self._redraw = True

    # -- user interfaces -----------------------------------------------------------------------------------------------

    def request(self, action: Callable[[], object]) -> None:
        """Do something on the program's thread; any thread."""
        self._requests.append(action)
        self.urgent.set()
        self.wake()

    def edit(self, prop: Property, value: Any) -> None:
        """Set a property's value; raises BadValue at once for one it cannot have."""
        checked = prop._checked(value)

        def change() -> None:
            prop.set(checked)
            self.modified = True
            self.tree_changed()

        if prop in self.view.children:
            prop.set(checked)
            self.tree_changed()
            self.touch()  # another target frame is somewhere else
        else:
            self.request(change)

    def edit_text(self, prop: Property, text: str) -> None:
        """Set a property from what somebody typed. Raises BadValue."""
        self.edit(prop, prop._read(text.strip()))

    def _view_touched(self) -> None:
        self.view_version += 1

    def _view_type_changed(self) -> None:
        self.set_view(str(self.view_type.value))

    def set_view(self, type_name: str, mimic: bool = True) -> None:
        """Look through another view controller."""
        if type_name not in VIEWS or type_name == self.view.type:
            return
        view = VIEWS[type_name](self.frame_choices, self._view_touched)
        view.expanded = self.view.expanded
        if mimic:
            copied(self.view, view)
        self.view_type.value = type_name
        self.views.remove(self.view)
        self.views.add(view, 1)
        self.view = view
        self._view_touched()
        self.tree_changed()
        self.touch()

    @property
    def saved_views(self) -> list[SavedView]:
        """In the order of the panel."""
        return [child for child in self.views.children if isinstance(child, SavedView)]

    def save_view(self) -> SavedView:
        """Keep the view under the name of its type (view_manager.cpp, copyCurrentToList)."""
        saved = SavedView({**self.view.save(), "Name": self.view.type})
        self.views.add(saved)
        self.views.expanded = True
        self._changed_by_user()
        return saved

    def use_view(self, saved: SavedView) -> None:
        """Look as a view that was kept."""
        self.set_view(saved.view_type, mimic=False)
        self.view.load(saved.config)
        self._view_touched()
        self._changed_by_user()

    def remove_view(self, saved: SavedView) -> None:
        self.views.remove(saved)
        self._changed_by_user()

    def rename_view(self, saved: SavedView, name: str) -> None:
        saved.name = name
        self._changed_by_user()

    # -- displays ------------------------------------------------------------------------------------------------------

    def add_display(self, type_name: str, topic: str = "") -> Display:
        """Add a display of a type, on a topic; on the program's thread. Raises KeyError for an unknown type."""
        display = display_class(type_name)(self, type_name)
        if topic:
            display.choose_topic(topic)
        display.expanded = True
        self.root.add(display, len(self.root.children) - 1)
        self._changed_by_user()
        return display

    def displays_for(self, message_type: str) -> list[str]:
        """Display types that can show a topic of this type."""
        return types_for(message_type)

    def remove_display(self, display: Display) -> None:
        """Take a display away, a group with all that is in it."""
        display.close()
        assert display.parent is not None
        display.parent.remove(display)
        self._changed_by_user()

    def duplicate_display(self, display: Display) -> Display:
        """A copy with the same settings, at the end of where it is."""
        copy = self._make(display.class_id, display.name)
        copy.load(display.save())
        place = display.parent
        assert place is not None
        place.add(copy, len(place.children) - (place is self.root))
        self._changed_by_user()
        return copy

    def rename_display(self, display: Display, name: str) -> None:
        display.name = name
        self._changed_by_user()

    def move_display(self, display: Display, step: int) -> None:
        """Move a display up (-1) or down (1) in the list: into a group that is open, and out of one at its end."""
        old = display.parent
        assert old is not None
        index = old.children.index(display) + step
        beside = old.children[index] if 0 <= index < len(old.children) else None
        if isinstance(beside, Display) and beside.type == "Group" and beside.expanded:
            new: Property = beside
            target = len(beside.children) - (len(beside.displays) if step > 0 else 0)
        elif isinstance(beside, Display):
            new, target = old, index
        elif isinstance(old, Display) and old.parent is not None:
            new, target = old.parent, old.parent.children.index(old) + (step > 0)
        else:
            return
        old.remove(display)
        new.add(display, target)
        self._changed_by_user()

    def _changed_by_user(self) -> None:
        self.modified = True
        self.tree_changed()
        self.touch()

    def _make(self, class_id: str, name: str) -> Display:
        type_name = type_of(class_id)
        if type_name is not None:
            return display_class(type_name)(self, name)
        missing = missing_class(class_id)
        self.log_missing(missing)
        return FailedDisplay(self, name, class_id, missing)

    def make_displays(self, config: Any) -> list[Display]:
        """Make the displays of a list in a .rviz file; what isn't a map in it is passed over."""
        made = []
        for entry in config if isinstance(config, list) else ():
            if isinstance(entry, dict):
                display = self._make(str(entry.get("Class", "")), str(entry.get("Name", "")))
                display.load(entry)
                made.append(display)
        return made

    def reset(self) -> None:
        """The Reset button: forget everything that was received, transforms too."""
        for display in self.displays:
            display.reset()
        self.frames.buffer.clear()
        self._began = None
        self.touch()

    def close(self) -> None:
        self.tools.close()
        for display in self.outermost:
            display.close()

    # -- time ----------------------------------------------------------------------------------------------------------

    def _data_came(self) -> None:
        if not self._dirty:
            self.touch()

    def _fixed_changed(self) -> None:
        # A slash in front is taken away, as tf2 does not want it.
        self.fixed.value = self.fixed.value.removeprefix("/")
        self.frames.fixed = self.fixed_frame
        self.touch()

    def _time_jumped(self, jump: TimeJump) -> None:
        logger = self.node.get_logger()
        if jump.clock_change in (ClockChange.ROS_TIME_ACTIVATED, ClockChange.ROS_TIME_DEACTIVATED):
            logger.warning("Detected time source change. Resetting RViz.")
        else:
            logger.warning("Detected jump back in time. Resetting RViz.")
        self.reset()

    def tick(self) -> bool:
        """Do what was asked for, follow what changed, and make the new scene; False if everything looks as before."""
        self._redraw |= bool(self._requests)
        while self._requests:
            self._requests.popleft()()
        self._dirty = False
        self.frames.forget()
        for display in self.displays:
            display.update()
        self._judge_fixed_frame()
        if self.time.expanded:
            self._tell_time()
        target = self.frames.pose(self.view.target.value)
        if target is not None:
            self.view.origin = target.xyz
            x, y, z, w = target.rotation
            self.view.heading = math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))
        scene = Scene(self.background.value)
        for display in self.displays:
            if display.enabled:
                scene.begin(display if display.selectable else None)
                display.draw(scene)
        scene.begin(None)
        self.selection.update()
        self.selection.draw(scene)
        self.tools.draw(scene)
        shown = (
            self.view.origin,
            self.view.heading,
            [each.value for top in (self.root, self.time) for each in top.walk()],
        )
        if not self._redraw and shown == self._shown and scene.looks_like(self.scene):
            return False
        self.scene, self._shown = scene, shown
        self.version += 1
        self._redraw = False
        return True

    def _tell_time(self) -> None:
        ros, wall = self.now_ns(), self._system_ns()
        if self._began is None:
            self._began = (ros, wall)
        numbers = (ros, ros - self._began[0], wall, wall - self._began[1])
        for line, number in zip(self._times, numbers, strict=True):
            line.value = f"{number / 1e9:.2f}"

    @property
    def restless(self) -> bool:
        """Whether the picture, or the panel, changes by time alone."""
        return self.time.expanded or any(
            getattr(display, "fading", False) for display in self.displays if display.enabled
        )

    def _judge_fixed_frame(self) -> None:
        problem = self.frames.frame_problem(self.fixed_frame)
        if problem is None:
            changed = self.statuses.put(OK, "Fixed Frame", "OK")
        elif not self.frames.names():
            changed = self.statuses.put(WARN, "Fixed Frame", f"No tf data.  Actual error: {problem}")
        else:
            changed = self.statuses.put(ERROR, "Fixed Frame", problem)
        if changed:
            self.tree_changed()

    def problems(self) -> list[tuple[str, Status]]:
        """Every status of RViz and its enabled displays that is not well, with whose it is, in the order of the panel."""
        shown = [(display.name, display.statuses) for display in self.displays if display.enabled]
        owners = [(self.statuses.word, self.statuses), *shown]
        return [(owner, line) for owner, statuses in owners for line in statuses.lines if line.level > OK]

    # -- configuration -------------------------------------------------------------------------------------------------

    def check_text(self, text: str) -> dict[str, Any]:
        """Read the text of a .rviz file; any thread. Raises ConfigError."""
        return read_config(text)

    def load_text(self, text: str) -> None:
        """Become what a .rviz file says. Raises ConfigError, and then nothing has changed."""
        self.load_config(read_config(text))

    def load_config(self, config: dict[str, Any], path: Path | None = None) -> None:
        """Become what a file says that was read already."""
        if path is not None:
            self.config_file = path
        self._config = config
        self._missing.clear()
        manager = config.get("Visualization Manager")
        manager = manager if isinstance(manager, dict) else {}
        for display in self.outermost:
            display.close()
            self.root.remove(display)
        self.options.load(manager.get("Global Options"))
        self.performance.load(manager.get("Performance"))
        for display in self.make_displays(manager.get("Displays")):
            self.root.add(display, len(self.root.children) - 1)
        self.selection.replace(())
        self.tools.load(manager.get("Tools"))
        views = manager.get("Views")
        current = views.get("Current") if isinstance(views, dict) else None
        if isinstance(current, dict):
            self.set_view(str(current.get("Class", "")).rpartition("/")[2], mimic=False)
            self.view.zero()  # what the file does not say is as at the start
            self.view.load(current)
        for saved in self.saved_views:
            self.views.remove(saved)
        kept = views.get("Saved") if isinstance(views, dict) else None
        for entry in kept if isinstance(kept, list) else ():
            if isinstance(entry, dict):
                self.views.add(SavedView(entry))
        load_expanded(self.root, config.get("Panels"))
        for class_id in missing_panels(config.get("Panels")):
            self.log_missing(missing_class(class_id))
        self.modified = False
        self.loaded += 1
        self.tree_changed()
        self.touch()

    def save(self) -> dict[str, Any]:
        """What a .rviz file holds, with everything of the loaded one that is not ours kept."""
        config = dict(self._config)
        old = config.get("Visualization Manager")
        manager = dict(old) if isinstance(old, dict) else {}
        manager["Displays"] = [display.save() for display in self.outermost]
        unknown = manager.get("Global Options")
        options = {child.name: child.save() for child in self.options.children}
        manager["Global Options"] = {**(unknown if isinstance(unknown, dict) else {}), **options}
        if self.quality.value != self.quality.default:
            manager["Performance"] = self.performance.save()
        else:
            manager.pop("Performance", None)
        manager["Tools"] = self.tools.save()
        kept = [saved.config for saved in self.saved_views]
        manager["Views"] = {"Current": self.view.save(), "Saved": kept or None}
        manager.setdefault("Class", "")
        manager.setdefault("Enabled", True)
        manager.setdefault("Name", "root")
        manager.setdefault("Value", True)
        config["Visualization Manager"] = manager
        config["Panels"] = save_panels(self.root, config.get("Panels"))
        return config
