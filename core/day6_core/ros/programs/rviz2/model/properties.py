"""The tree of properties that the Displays panel shows: names, values, rules for values, and what is saved of them.

A property has a value, or children, or both. Its texts are those of the real panel: a check box is `true`, three numbers are
`1; 2; 3`, a colour is `160; 160; 164`.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any

FIXED_FRAME = "<Fixed Frame>"

GROUP, BOOL, INT, FLOAT, TEXT, ENUM, COLOUR, VECTOR, QUATERNION, FRAME, TOPIC, FILE, STATUS = (
    "group", "bool", "int", "float", "text", "enum", "colour", "vector", "quaternion", "frame", "topic", "file", "status",
)  # fmt: skip


class BadValue(ValueError):
    """A text or value that this property cannot have; `key` and `parameters` are for the catalogue of texts."""

    def __init__(self, key: str, **parameters: Any) -> None:
        super().__init__(f"{key} {parameters}" if parameters else key)
        self.key = key
        self.parameters = parameters


class Property:
    """One line of the panel. `on_change` is called after the value became another one."""

    def __init__(
        self,
        name: str,
        kind: str = GROUP,
        value: Any = None,
        description: str = "",
        *,
        low: float | None = None,
        high: float | None = None,
        options: Sequence[str] | Callable[[], Sequence[str]] = (),
        read_only: bool = False,
        saved: bool = True,
        hidden: bool = False,
        on_change: Callable[[], object] | None = None,
    ) -> None:
        self.name = name
        self.kind = kind
        self.value = value
        self.default = value
        self.description = description
        self.low, self.high = low, high
        self._options = options
        self.read_only = read_only
        self.saved = saved
        self.hidden = hidden
        self.on_change = on_change
        self.expanded = False
        self.parent: Property | None = None
        self.children: list[Property] = []

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.path} = {self.text}>"

    # -- the tree ------------------------------------------------------------------------------------------------------

    def add(self, child: Property, index: int | None = None) -> Property:
        """Put a property under this one and return it."""
        child.parent = self
        # A new list, so that whoever walks the old one (another thread) ends in peace.
        children = list(self.children)
        children.insert(len(children) if index is None else index, child)
        self.children = children
        return child

    def remove(self, child: Property) -> None:
        """Take a property away; one that is not there is no error."""
        self.children = [each for each in self.children if each is not child]

    def child(self, *names: str) -> Property:
        """The property below by its names. Raises KeyError."""
        found = self
        for name in names:
            for each in found.children:
                if each.name == name:
                    found = each
                    break
            else:
                raise KeyError("/".join(names))
        return found

    @property
    def path(self) -> str:
        """Names from the top, `/Grid/Offset/X`."""
        return (self.parent.path if self.parent is not None else "") + "/" + self.name

    def walk(self) -> Iterator[Property]:
        """This and all below."""
        yield self
        for child in self.children:
            yield from child.walk()

    # -- the value -----------------------------------------------------------------------------------------------------

    @property
    def options(self) -> Sequence[str]:
        """What an enum, a frame or a topic may be chosen from at present."""
        return self._options() if callable(self._options) else self._options

    @property
    def text(self) -> str:
        """The value as the panel shows it."""
        value = self.value
        if value is None:
            return ""
        if self.kind == BOOL:
            return "true" if value else "false"
        if self.kind == FLOAT:
            return number_text(value)
        if self.kind in (VECTOR, QUATERNION):
            return "; ".join(number_text(part) for part in value)
        if self.kind == COLOUR:
            return "; ".join(str(part) for part in value)
        return str(value)

    def set(self, value: Any) -> bool:
        """Set a value of the right type, held within its limits; True if it is another one than before.

        Raises BadValue for a value that is none.
        """
        value = self._checked(value)
        if value == self.value:
            return False
        self.value = value
        if self.on_change is not None:
            self.on_change()
        return True

    def parse(self, text: str) -> bool:
        """Set the value from what a person typed. Raises BadValue."""
        return self.set(self._read(text.strip()))

    def _read(self, text: str) -> Any:
        if self.kind == BOOL:
            if text.lower() in ("true", "1", "on", "yes"):
                return True
            if text.lower() in ("false", "0", "off", "no"):
                return False
            raise BadValue("rviz.bad.bool")
        if self.kind in (INT, FLOAT):
            try:
                return int(text) if self.kind == INT else float(text)
            except ValueError:
                raise BadValue(f"rviz.bad.{self.kind}") from None
        if self.kind in (VECTOR, QUATERNION, COLOUR):
            parts = text.replace(";", " ").replace(",", " ").split()
            try:
                return tuple(int(part) if self.kind == COLOUR else float(part) for part in parts)
            except ValueError:
                raise BadValue(f"rviz.bad.{self.kind}") from None
        return text

    def _checked(self, value: Any) -> Any:
        if self.kind == BOOL:
            return bool(value)
        if self.kind == INT:
            return int(self._limited(_finite(value)))
        if self.kind == FLOAT:
            return float(self._limited(_finite(value)))
        if self.kind in (VECTOR, QUATERNION):
            wanted = 3 if self.kind == VECTOR else 4
            if not isinstance(value, Iterable) or len(parts := tuple(value)) != wanted:
                raise BadValue(f"rviz.bad.{self.kind}")
            return tuple(_finite(part) for part in parts)
        if self.kind == COLOUR:
            if not isinstance(value, Iterable) or isinstance(value, str) or len(parts := tuple(value)) != 3:
                raise BadValue("rviz.bad.colour")
            return tuple(max(0, min(255, int(_finite(part)))) for part in parts)
        if self.kind == ENUM:
            options = self.options
            if options and str(value) not in options and value != self.default:
                raise BadValue("rviz.bad.enum", options=", ".join(options))
        return str(value)

    def _limited(self, value: float) -> float:
        if self.low is not None and value < self.low:
            return self.low
        if self.high is not None and value > self.high:
            return self.high
        return value

    # -- configuration -------------------------------------------------------------------------------------------------

    @property
    def should_be_saved(self) -> bool:
        return self.saved and not self.read_only

    def save(self) -> Any:
        """What a .rviz file holds of this property: a value, or a map of the children's, with the own one as `Value`."""
        if self.kind == VECTOR:
            return dict(zip("XYZ", map(_single, self.value), strict=True))
        if self.kind == QUATERNION:
            return dict(zip("XYZW", map(_single, self.value), strict=True))
        if not self.children:
            return self._scalar()
        saved = {child.name: child.save() for child in self.children if child.should_be_saved}
        if self.value is not None:
            saved["Value"] = self._scalar()
        return saved

    def _scalar(self) -> Any:
        if self.kind == FLOAT:
            return _single(self.value)
        if self.kind in (BOOL, INT):
            return self.value
        return self.text

    def load(self, config: Any) -> None:
        """Take over what a .rviz file says; what it does not say or says wrongly stays as it is."""
        if isinstance(config, dict):
            if self.kind == VECTOR:
                config = tuple(config.get(key, old) for key, old in zip("XYZ", self.value, strict=True))
            elif self.kind == QUATERNION:
                config = tuple(config.get(key, old) for key, old in zip("XYZW", self.value, strict=True))
            else:
                for child in self.children:
                    if child.name in config and child.should_be_saved:
                        child.load(config[child.name])
                config = config.get("Value")
        if config is None or self.value is None or self.read_only:
            return
        try:
            if self.kind == COLOUR:
                self.parse(str(config))
            elif self.kind == BOOL:
                self.set(config if isinstance(config, bool) else str(config).lower() in ("true", "1"))
            else:
                self.set(config)
        except (BadValue, TypeError, ValueError):
            return


def pose_lines(position: Any, orientation: Any) -> list[Property]:
    """A pose as two lines of the panel that only tell."""
    return [
        Property("Position", VECTOR, tuple(position), read_only=True),
        Property("Orientation", QUATERNION, tuple(orientation), read_only=True),
    ]


def number_text(value: float) -> str:
    """A number as Qt shows a float: six significant digits, no zeros at the end."""
    return f"{value:.6g}"


def _finite(value: Any) -> float:
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise BadValue("rviz.bad.float") from None
    if not math.isfinite(number):
        raise BadValue("rviz.bad.finite")
    return number


def _single(value: float) -> float | int:
    """A number as RViz writes it: it keeps single precision."""
    try:
        number: float = struct.unpack("f", struct.pack("f", value))[0]
    except OverflowError:
        return value
    return int(number) if number.is_integer() and abs(number) < 1e15 else number


def floats(name: str, value: float, low: float | None = None, high: float | None = None, **keywords: Any) -> Property:
    """A FLOAT property."""
    return Property(name, FLOAT, float(value), low=low, high=high, **keywords)
