"""Where values lie in CDR: runs of fixed-size values, packed with one `struct` call at any alignment."""

from __future__ import annotations

from struct import Struct

from day6_tui.core.interfaces.definition import Structure
from day6_tui.core.interfaces.fields import ARRAY, BOUNDED, SINGLE, UNBOUNDED

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

HEADER_SIZE = 4
INLINE_LIMIT = 80
"""Fields of nested messages that generated code handles in place; larger messages are handled by their own function."""


class Run:
    """Fixed-size values that follow one another: struct codes, sizes and alignments, and source expressions."""

    def __init__(self) -> None:
        self.items: list[tuple[str, int, int]] = []
        self.expressions: list[str] = []

    def add(self, code: str, size: int, alignment: int, expression: str) -> None:
        """Append one value."""
        self.items.append((code, size, alignment))
        self.expressions.append(expression)

    def layout(self, phase: int) -> tuple[Struct, int]:
        """Return the struct, padding included, of a run that begins `phase` bytes past a multiple of 8, and its end."""
        codes, position = ["<"], phase
        for code, size, alignment in self.items:
            padding = -position % alignment
            codes.append(f"{padding}x{code}" if padding else code)
            position += padding + size
        return Struct("".join(codes)), position % 8

    def layouts(self) -> list[tuple[Struct, int]]:
        """Return the eight layouts, indexed by `len(buffer) & 7` of a buffer that includes the header."""
        return [self.layout((index - HEADER_SIZE) % 8) for index in range(8)]


def common_end(layouts: list[tuple[Struct, int]]) -> int | None:
    """Return the phase all layouts end in, None when it depends on where they begin."""
    ends = {end for _, end in layouts}
    return ends.pop() if len(ends) == 1 else None


def padding_to(alignment: int) -> tuple[int, ...]:
    """Return the padding bytes needed, indexed by `len(buffer) & 7` of a buffer that includes the header."""
    return tuple(-(index - HEADER_SIZE) % alignment for index in range(8))


def weight(structure: Structure, find_class: Any) -> int:
    """Return how many values a message's code would handle, nested ones included."""
    total = 1
    for field in structure.fields:
        total += weight(find_class(field.type.base)._structure, find_class) if field.type.nested else 1
    return total


def least_size(structure: Structure, find_class: Any) -> int:
    """Return a lower bound, in bytes, of any message of this structure: what a count is compared with before a loop."""
    total = 0
    for field in structure.fields:
        type_ = field.type
        if type_.count in (BOUNDED, UNBOUNDED):
            total += 4
            continue
        if type_.primitive is not None:
            size = type_.primitive.size
        elif type_.nested:
            size = least_size(find_class(type_.base)._structure, find_class)
        else:
            size = 4
        total += size * (type_.size if type_.count != SINGLE else 1)
    return max(total, 1)


def is_block(structure_field: Any) -> bool:
    """Say whether a field is a fixed array of primitives, which one struct code covers."""
    type_ = structure_field.type
    return bool(type_.count == ARRAY and type_.primitive is not None)
