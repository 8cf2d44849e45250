"""The layout of values in CDR: runs of fixed-size values, packed with one `struct` call at any alignment."""

from __future__ import annotations

from struct import Struct

from day6_core.interfaces.fields import BOUNDED, SINGLE, UNBOUNDED, FieldType
from day6_core.interfaces.registry import is_light, structure

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

HEADER_SIZE = 4


class Run:
    """Consecutive fixed-size values: their struct codes, sizes and alignments in bytes, and source expressions."""

    def __init__(self) -> None:
        self.items: list[tuple[str, int, int]] = []
        self.expressions: list[str] = []

    def add(self, code: str, size: int, alignment: int, expression: str) -> None:
        """Append one value."""
        self.items.append((code, size, alignment))
        self.expressions.append(expression)

    def layout(self, phase: int) -> tuple[Struct, int]:
        """Return the struct, with padding, of a run that begins `phase` bytes after a multiple of 8, and the phase of its end."""
        codes, position = ["<"], phase
        for code, size, alignment in self.items:
            padding = -position % alignment
            codes.append(f"{padding}x{code}" if padding else code)
            position += padding + size
        return Struct("".join(codes)), position % 8

    def layouts(self) -> list[tuple[Struct, int]]:
        """Return the eight layouts, indexed by `len(buffer) & 7` of a buffer that includes the header."""
        return [self.layout((index - HEADER_SIZE) % 8) for index in range(8)]


class Source:
    """Statements of a function being generated; fixed-size values collect in `run` until something of variable length follows.

    `phase` is the start of the run in bytes after a multiple of 8, None if it is unknown. `names` are the function's globals.
    """

    def __init__(self, names: dict[str, Any]) -> None:
        self.names = names
        self.lines: list[str] = []
        self.run = Run()
        self.phase: int | None = None
        self.indent = "    "
        self.count = 0

    def line(self, text: str) -> None:
        """Append one statement at the current depth."""
        self.lines.append(self.indent + text)

    def name(self, value: Any = None) -> str:
        """Return a new name for the generated code: of a value, or (None) of a variable."""
        self.count += 1
        name = f"v{self.count}"
        if value is not None:
            self.names[name] = value
        return name


def common_end(layouts: list[tuple[Struct, int]]) -> int | None:
    """Return the phase in which all layouts end, None if it depends on where they begin."""
    ends = {end for _, end in layouts}
    return ends.pop() if len(ends) == 1 else None


def padding_to(alignment: int) -> tuple[int, ...]:
    """Return the padding bytes needed, indexed by `len(buffer) & 7` of a buffer that includes the header."""
    return tuple(-(index - HEADER_SIZE) % alignment for index in range(8))


def least_size(type_: FieldType) -> int:
    """Return a lower bound, in bytes, of one element of this type; counts are checked against it before a loop."""
    if type_.primitive is not None:
        return type_.primitive.size
    if not type_.nested:
        return 4
    if not is_light(type_.base):
        return 1
    fields = structure(type_.base).fields
    return max(sum(_least_field(field.type) for field in fields), 1)


def _least_field(type_: FieldType) -> int:
    if type_.count in (BOUNDED, UNBOUNDED):
        return 4
    return least_size(type_) * (1 if type_.count == SINGLE else type_.size)
