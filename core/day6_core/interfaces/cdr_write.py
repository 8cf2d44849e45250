"""Generates the function that writes a message class as CDR."""

from __future__ import annotations

import sys
from array import array

from day6_core.interfaces import cdr_layout
from day6_core.interfaces.definition import Structure
from day6_core.interfaces.fields import ARRAY, BOUNDED, SINGLE, FieldType
from day6_core.interfaces.registry import find_class, is_light

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any


class SerializationError(Exception):
    """A message has a value that does not fit its field, so it cannot be sent."""


def build_writer(cls: Any, writers: Any) -> Callable[[bytearray, Any], None]:
    """Return `write(buffer, message)`, which appends to a buffer that begins with the header.

    `writers` maps other classes to their functions, for large nested messages.
    """
    names: dict[str, Any] = {
        "check_length": _check_length,
        "little": _little_endian,
        "wide": _wide,
        "PAD8": tuple(bytes(count) for count in cdr_layout.padding_to(8)),
    }
    generator = _Generator(names, writers)
    # A top-level message begins right after the header, but a nested call begins anywhere, so no phase is assumed.
    generator.structure("message", cls._structure)
    generator.flush()
    source = ["def write(buffer, message):", *generator.lines]
    exec(compile("\n".join(source), f"<write {cls._interface_name}>", "exec"), names)
    writer: Callable[[bytearray, Any], None] = names["write"]
    return writer


def _check_length(values: Any, length: int, at_most: bool) -> Any:
    """Return the values; raise ValueError if the list is longer or shorter than its field allows."""
    if len(values) != length and not (at_most and len(values) < length):
        raise ValueError(f"{len(values)} values where {'at most ' if at_most else ''}{length} belong")
    return values


def _little_endian(values: Any) -> Any:
    """Return a numeric array as bytes in little-endian order."""
    if sys.byteorder == "big":
        values = values[:]
        values.byteswap()
    return values


def _wide(text: str) -> bytes:
    """Encode a wstring as rmw_fastrtps on Linux does: each UTF-16 unit as 4 bytes."""
    units = array("H", text.encode(f"utf-16-{sys.byteorder[:1]}e"))
    return b"".join(unit.to_bytes(4, "little") for unit in units)


class _Generator(cdr_layout.Source):
    """Writes the statements that write a message."""

    def __init__(self, names: dict[str, Any], writers: Any) -> None:
        super().__init__(names)
        self.writers = writers

    def flush(self) -> None:
        """Write the pending run."""
        if not self.run.items:
            return
        arguments = ", ".join(expression for expression in self.run.expressions if expression)
        if self.phase is None:
            layouts = self.run.layouts()
            packs = self.name(tuple(layout.pack for layout, _ in layouts))
            self.line(f"buffer += {packs}[len(buffer) & 7]({arguments})")
            self.phase = cdr_layout.common_end(layouts)
        else:
            layout, self.phase = self.run.layout(self.phase)
            self.line(f"buffer += {self.name(layout.pack)}({arguments})")
        self.run = cdr_layout.Run()

    def structure(self, variable: str, structure: Structure) -> None:
        """Write all fields of the message in a variable."""
        if not structure.fields:
            self.run.add("B", 1, 1, "0")
        for field in structure.fields:
            expression = f"{variable}._{field.name}"
            if field.type.count == SINGLE:
                self.single(field.type, expression)
            else:
                self.collection(field.type, expression)

    def single(self, type_: FieldType, expression: str) -> None:
        """Write one value."""
        primitive = type_.primitive
        if primitive is not None:
            self.run.add(primitive.code, primitive.size, primitive.size, expression)
        elif type_.base == "string":
            encoded = self.name(None)
            self.line(f"{encoded} = {expression}.encode()")
            self.run.add("I", 4, 4, f"len({encoded}) + 1")
            self.flush()
            self.line(f"buffer += {encoded}")
            self.phase = None
            self.run.add("x", 1, 1, "")
        elif type_.base == "wstring":
            encoded = self.name(None)
            self.line(f"{encoded} = wide({expression})")
            self.run.add("I", 4, 4, f"len({encoded}) // 4")
            self.flush()
            self.line(f"buffer += {encoded}")
            self.phase = None
        else:
            self.nested(find_class(type_.base), expression)

    def nested(self, cls: Any, expression: str) -> None:
        """Write a nested message, in place when it is small."""
        if not is_light(cls._interface_name):
            self.flush()
            self.line(f"{self.name(self.writers[cls])}(buffer, {expression})")
            self.phase = None
        else:
            variable = self.name(None)
            self.line(f"{variable} = {expression}")
            self.structure(variable, cls._structure)

    def collection(self, type_: FieldType, expression: str) -> None:
        """Write an array or sequence."""
        primitive = type_.primitive
        values = self.name(None)
        self.line(f"{values} = {expression}")
        if type_.count != ARRAY:
            if type_.count == BOUNDED:
                self.line(f"check_length({values}, {type_.size}, True)")
            self.run.add("I", 4, 4, f"len({values})")
        elif not type_.is_numeric_array():
            self.line(f"check_length({values}, {type_.size}, False)")
        if primitive is None:
            self.flush()
            self.loop(type_, values)
        elif type_.count == ARRAY:
            data = f"{values}.tobytes()" if primitive.numpy else self.plain_bytes(type_, values)
            self.run.add(f"{type_.size * primitive.size}s", type_.size * primitive.size, primitive.size, data)
        else:
            self.flush()
            if primitive.size == 8:
                # The elements of an empty sequence are not aligned.
                self.line(f"if {values}: buffer += PAD8[len(buffer) & 7]")
            data = f"little({values})" if primitive.numpy else self.plain_bytes(type_, values)
            self.line(f"buffer += {data if sys.byteorder == 'big' or not primitive.numpy else values}")
            self.phase = None

    def plain_bytes(self, type_: FieldType, values: str) -> str:
        """Return the source that converts a list of bool, or of bytes of length 1, to bytes."""
        return f"bytes({values})" if type_.base == "bool" else f"b''.join({values})"

    def loop(self, type_: FieldType, values: str) -> None:
        """Write strings or messages in a loop."""
        item = self.name(None)
        self.line(f"for {item} in {values}:")
        outer, self.indent, self.phase = self.indent, self.indent + "    ", None
        if type_.nested:
            self.nested(find_class(type_.base), item)
        else:
            self.single(FieldType(type_.base, type_.string_bound), item)
        self.flush()
        self.indent, self.phase = outer, None
