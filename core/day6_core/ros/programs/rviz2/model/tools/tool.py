"""The base of all tools (rviz_common/tool.cpp), and what a tool is told of the mouse."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

from day6_core.ros.programs.rclcpp import CppException
from day6_core.ros.programs.rviz2.model.properties import TOPIC, Property
from day6_core.ros.programs.rviz2.model.qos import QosProperties

if TYPE_CHECKING:
    from day6_core.ros.programs.remark import Remark
    from day6_core.ros.programs.rviz2.model.manager import RViz
    from day6_core.ros.programs.rviz2.model.scene import Scene
    from day6_urdf.model import Vector
    from rclpy.publisher import Publisher

CAMERA, GROUND, SCREEN = "camera", "ground", "screen"
"""What the arrow keys move while a tool is used: the view, a place on the ground, or a cursor over the picture."""


@dataclass(frozen=True, slots=True)
class Hit:
    """The nearest thing that can be picked: a point of its surface, whose it is, and which of the owner's things it is."""

    point: Vector
    owner: Any
    key: Any


class Pointer(NamedTuple):
    """Where the mouse points to, in the fixed frame."""

    start: Vector
    """Where the ray through the pixel begins."""
    along: Vector
    """Its direction."""
    hit: Hit | None = None
    pixel: tuple[float, float] = (0.0, 0.0)
    """Where that is in a picture of the nominal height."""
    inside: tuple[tuple[Any, Any], ...] = ()
    """Owners and keys of all things in the rectangle that was dragged, nearest first."""
    shift: bool = False
    control: bool = False

    @property
    def ground(self) -> Vector | None:
        """Where the ray meets the plane z = 0 of the fixed frame; None if it does not."""
        if self.along[2] == 0 or (distance := -self.start[2] / self.along[2]) <= 0:
            return None
        return self.start[0] + self.along[0] * distance, self.start[1] + self.along[1] * distance, 0.0

    def at(self, distance: float) -> Vector:
        """A point of the ray."""
        x, y, z = (a + b * distance for a, b in zip(self.start, self.along, strict=True))
        return x, y, z


class Tool(Property):
    """One tool; its properties are below it in `Tool Properties`. `type` is the last part of the class name in .rviz files."""

    type = ""
    title = ""
    """What the toolbar calls it."""
    short = ""
    """What a narrow toolbar calls it."""
    key = ""
    """The letter that chooses it."""
    arrows = CAMERA
    needs_hit = False
    """Whether it wants to know what is under the mouse."""
    grabs = False
    """Whether it takes the left button from the view where it `wants` to."""
    takes_right = False
    """Whether the right button is for it rather than for the view."""

    def __init__(self, rviz: RViz) -> None:
        super().__init__(self.title)
        self.rviz = rviz
        self.unknown: dict[str, Any] = {}
        self.build()

    @property
    def class_id(self) -> str:
        return f"rviz_default_plugins/{self.type}"

    def build(self) -> None:
        """Add the properties."""

    @property
    def status(self) -> str:
        """What the status bar says while it is used."""
        return ""

    def activate(self) -> None:
        """It was chosen."""

    def deactivate(self) -> None:
        """Another one was chosen."""

    def open(self) -> None:
        """It was loaded."""

    def close(self) -> None:
        """It is taken away."""

    # -- the mouse: each returns whether the tool has done its work, so that the default tool comes back -------------------

    def wants(self, pointer: Pointer) -> bool:
        """Whether the left button is the tool's there; asked on the user interface's thread."""
        return False

    def press(self, pointer: Pointer) -> bool:
        """The left button went down."""
        return False

    def menu(self, pointer: Pointer) -> bool:
        """The right button went down on what the tool `wants`."""
        return False

    def drag(self, pointer: Pointer) -> bool:
        """The mouse moved with the button down."""
        return False

    def wheel(self, notches: float) -> bool:
        """The wheel was turned with the button down."""
        return False

    def release(self, pointer: Pointer) -> bool:
        """The left button went up."""
        return False

    def hover(self, pointer: Pointer) -> bool:
        """The mouse moved with no button down."""
        return False

    def right(self) -> bool:
        """The right button went up."""
        return False

    # -- keys, for tools whose `arrows` is GROUND ------------------------------------------------------------------------

    def arrow_key(self, right: int, up: int, *, fine: bool) -> bool:
        """An arrow key; `fine` with Shift."""
        return False

    def enter_key(self) -> bool:
        """Enter."""
        return False

    # -- pictures and configuration --------------------------------------------------------------------------------------

    def draw(self, scene: Scene) -> None:
        """Add to the scene."""

    def load(self, config: Any) -> None:
        if isinstance(config, dict):
            super().load({key: value for key, value in config.items() if key != "Value"})
            known = {child.name for child in self.children}
            self.unknown = {key: value for key, value in config.items() if key not in known}

    def save(self) -> dict[str, Any]:
        saved = {child.name: child.save() for child in self.children}
        return {**self.unknown, **saved, "Class": self.class_id}


class FailedTool(Tool):
    """Stands for a tool of a .rviz file that there is no class for; the file's words are kept (failed_tool.cpp)."""

    def __init__(self, rviz: RViz, class_id: str, missing: Remark) -> None:
        super().__init__(rviz)
        self._class_id, self.missing = class_id, missing
        self.name = self.title = self.short = class_id.rpartition("/")[2]

    @property
    def class_id(self) -> str:
        return self._class_id

    @property
    def status(self) -> str:
        return self.missing.text


class ToolTopic:
    """The property `Topic` of a tool, and the publisher that follows it."""

    def __init__(self, tool: Tool, message_type: str, default: str) -> None:
        self._rviz = tool.rviz
        self._type = message_type
        self.property = tool.add(Property("Topic", TOPIC, default, on_change=self._changed))
        self._qos = QosProperties(self.property, self._changed)
        self._publisher: Publisher[Any] | None = None
        self.opened = False

    def open(self) -> None:
        """Create the publisher. A name that no topic can have is logged, and then there is none."""
        from day6_core.interfaces import get_message

        self.close()
        self.opened = True
        try:
            self._publisher = self._rviz.node.create_publisher(
                get_message(self._type), self.property.value, self._qos.profile()
            )
        except CppException as error:
            self._rviz.log_error(str(error))
            self._rviz.hint("rviz.tool.bad_topic", topic=self.property.value)

    def close(self) -> None:
        if self._publisher is not None:
            self._rviz.node.destroy_publisher(self._publisher)
            self._publisher = None

    def _changed(self) -> None:
        if self.opened:
            self.open()

    def message(self) -> Any:
        """A message of its type whose header says the fixed frame and the time."""
        from day6_core.interfaces import get_message

        message = get_message(self._type)()
        message.header.frame_id = self._rviz.fixed_frame
        message.header.stamp = self._rviz.node.get_clock().now().to_msg()
        return message

    def publish(self, message: Any) -> None:
        """Send a message, if the topic is one."""
        if self._publisher is not None:
            self._publisher.publish(message)
