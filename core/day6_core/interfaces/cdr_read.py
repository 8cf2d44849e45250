"""Generates the function that reads a message class from CDR."""

from __future__ import annotations

import sys
from array import array

from day6_core.interfaces import cdr_layout, checks
from day6_core.interfaces.definition import Structure
from day6_core.interfaces.fields import ARRAY, BOUNDED, SINGLE, FieldType
from day6_core.interfaces.registry import find_class, is_light

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any


class DeserializationError(Exception):
    """Bytes are not a message of the expected type: too short, an impossible count, or an unknown encapsulation."""


def build_reader(cls: Any, readers: Any) -> Callable[[bytes, int, int], tuple[Any, int]]:
    """Return `read(data, position, size)`, which returns the message at a position and the position after it (bytes).

    `size` is `len(data)`. `readers` maps other classes to their functions, for large nested messages.
    """
    names: dict[str, Any] = {
        "new": object.__new__,
        "check": checks.CHECK_FIELDS,
        "array": array,
        "refuse": _refuse,
        "narrow": _narrow,
        "swapped": _swapped,
        "split": _split,
        "PAD8": cdr_layout.padding_to(8),
    }
    generator = _Generator(names, readers)
    generator.message(cls, "message")
    generator.flush()
    source = ["def read(data, position, size):", *generator.lines, "    return message, position"]
    exec(compile("\n".join(source), f"<read {cls._interface_name}>", "exec"), names)
    reader: Callable[[bytes, int, int], tuple[Any, int]] = names["read"]
    return reader


def _refuse(count: int, left: int) -> None:
    """Raise ValueError for a count of elements or bytes that exceeds the rest of the data, or a bound."""
    raise ValueError(f"a count of {count} where at most {max(left, 0)} can follow")


def _narrow(data: bytes) -> str:
    """Decode a wstring of 4-byte units (see cdr_write)."""
    units = array("I", data)
    if sys.byteorder == "big":
        units.byteswap()
    return array("H", [unit & 0xFFFF for unit in units]).tobytes().decode(f"utf-16-{sys.byteorder[:1]}e", "replace")


def _swapped(code: str, data: bytes) -> Any:
    """Return little-endian data as an array in this machine's byte order."""
    values = array(code, data)
    if sys.byteorder == "big":
        values.byteswap()
    return values


def _split(data: bytes) -> list[bytes]:
    """Return the bytes as a list of bytes objects of length 1."""
    return [data[index : index + 1] for index in range(len(data))]


class _Generator(cdr_layout.Source):
    """Writes the statements that read a message; `after` are those that use the values of the pending run."""

    def __init__(self, names: dict[str, Any], readers: Any) -> None:
        super().__init__(names)
        self.readers = readers
        self.after: list[str] = []

    def flush(self) -> None:
        """Read the pending run, then run the statements that use its values."""
        if not self.run.items:
            return
        targets = "".join(f"{target}, " for target in self.run.expressions)
        if self.phase is None:
            layouts = self.run.layouts()
            table = tuple((layout.unpack_from, layout.size) for layout, _ in layouts)
            unpack, length = self.name(), self.name()
            self.line(f"{unpack}, {length} = {self.name(table)}[position & 7]")
            self.line(f"{targets}= {unpack}(data, position)")
            self.line(f"position += {length}")
            self.phase = cdr_layout.common_end(layouts)
        else:
            layout, self.phase = self.run.layout(self.phase)
            self.line(f"{targets}= {self.name(layout.unpack_from)}(data, position)")
            self.line(f"position += {layout.size}")
        for statement in self.after:
            self.line(statement)
        self.run, self.after = cdr_layout.Run(), []

    def message(self, cls: Any, variable: str) -> None:
        """Create a message in a variable and read its fields."""
        self.line(f"{variable} = new({self.name(cls)})")
        for line in checks.slot_lines(variable):
            self.line(line)
        structure: Structure = cls._structure
        if not structure.fields:
            self.run.add("B", 1, 1, self.name())
        for field in structure.fields:
            target = f"{variable}._{field.name}"
            if field.type.count == SINGLE:
                self.single(field.type, target)
            elif field.type.primitive is not None and field.type.count == ARRAY:
                self.block(field.type, target)
            else:
                self.collection(field.type, target)

    def single(self, type_: FieldType, target: str) -> None:
        """Read one value into a target."""
        primitive = type_.primitive
        if primitive is not None:
            self.run.add(primitive.code, primitive.size, primitive.size, target)
        elif type_.base == "string":
            count = self.counted()
            self.line(f"if {count} > size - position: refuse({count}, size - position)")
            end = self.name()
            # As in rmw_fastrtps a string ends at its first NUL; one without NUL is accepted.
            self.line(f"{end} = data.find(0, position, position + {count})")
            self.line(f"if {end} < 0: {end} = position + {count}")
            self.line(f"{target} = str(data[position:{end}], 'utf-8', 'replace')")
            self.line(f"position += {count}")
            self.phase = None
        elif type_.base == "wstring":
            count = self.counted()
            self.line(f"if {count} > (size - position) // 4: refuse({count}, (size - position) // 4)")
            self.line(f"{target} = narrow(data[position : position + 4 * {count}])")
            self.line(f"position += 4 * {count}")
            self.phase = None
        else:
            self.nested(find_class(type_.base), target)

    def counted(self) -> str:
        """Read a count; return the name of its variable."""
        count = self.name()
        self.run.add("I", 4, 4, count)
        self.flush()
        return count

    def nested(self, cls: Any, target: str) -> None:
        """Read a nested message, in place when it is small."""
        if not is_light(cls._interface_name):
            self.flush()
            self.line(f"{target}, position = {self.name(self.readers[cls])}(data, position, size)")
            self.phase = None
        else:
            variable = self.name()
            self.message(cls, variable)
            self.line(f"{target} = {variable}")

    def block(self, type_: FieldType, target: str) -> None:
        """Read a fixed array of primitives."""
        primitive = type_.primitive
        assert primitive is not None
        data = self.name()
        self.run.add(f"{type_.size * primitive.size}s", type_.size * primitive.size, primitive.size, data)
        if primitive.numpy:
            import numpy

            self.names["frombuffer"] = numpy.frombuffer
            little = self.name(numpy.dtype(getattr(numpy, primitive.numpy)).newbyteorder("<"))
            self.after.append(f"{target} = frombuffer({data}, {little}).astype({primitive.numpy!r})")
        elif type_.base == "bool":
            self.after.append(f"{target} = [*map(bool, {data})]")
        else:
            self.after.append(f"{target} = split({data})")

    def collection(self, type_: FieldType, target: str) -> None:
        """Read a sequence, or a fixed array of strings or messages."""
        if type_.count == ARRAY:
            self.flush()
            self.loop(type_, target, str(type_.size))
            return
        count, primitive = self.counted(), type_.primitive
        if type_.count == BOUNDED:
            self.line(f"if {count} > {type_.size}: refuse({count}, {type_.size})")
        if primitive is None:
            least = cdr_layout.least_size(type_)
            self.line(f"if {count} * {least} > size - position: refuse({count}, (size - position) // {least})")
            self.loop(type_, target, count)
            return
        if primitive.size == 8:
            self.line(f"if {count}: position += PAD8[position & 7]")
        end, width = self.name(), f" * {primitive.size}" if primitive.size > 1 else ""
        self.line(f"{end} = position + {count}{width}")
        self.line(f"if {end} > size: refuse({count}, (size - position) // {primitive.size})")
        data = f"data[position:{end}]"
        if primitive.numpy:
            maker = "swapped" if sys.byteorder == "big" else "array"
            self.line(f"{target} = {maker}({primitive.code!r}, {data})")
        else:
            self.line(f"{target} = [*map(bool, {data})]" if type_.base == "bool" else f"{target} = split({data})")
        self.line(f"position = {end}")
        self.phase = None

    def loop(self, type_: FieldType, target: str, count: str) -> None:
        """Read strings or messages in a loop."""
        values, item = self.name(), self.name()
        self.line(f"{target} = {values} = []")
        self.line(f"for {self.name()} in range({count}):")
        outer, self.indent, self.phase = self.indent, self.indent + "    ", None
        if type_.nested:
            self.nested(find_class(type_.base), item)
        else:
            self.single(FieldType(type_.base, type_.string_bound), item)
        self.flush()
        self.line(f"{values}.append({item})")
        self.indent, self.phase = outer, None
