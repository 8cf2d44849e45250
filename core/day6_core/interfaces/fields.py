"""Types of fields: a table of the primitive types with the properties each layer needs, and the type of one field.

The parser, the class generator, the CDR codec and the hash all use the table. Names on the left are those of .msg files; `idl`
is the name in `get_fields_and_field_types()`.
"""

from __future__ import annotations


class Primitive:
    """One primitive type of .msg files.

    `code` is its letter for `struct` (and for `array.array` where `numpy` is set), `size` its size in CDR in bytes (also its
    alignment), `type_id` its number in a RIHS01 type description, `python` the type a value must have and `zero` the source of
    its default value. `low` and `high` are the limits of integers; floats are limited to `-high` … `high`.
    """

    __slots__ = ("code", "high", "idl", "low", "name", "numpy", "python", "size", "type_id", "zero")

    def __init__(
        self, name: str, idl: str, code: str, size: int, type_id: int, python: type, zero: str, numpy: str = ""
    ) -> None:
        self.name = name
        self.idl = idl
        self.code = code
        self.size = size
        self.type_id = type_id
        self.python = python
        self.zero = zero
        self.numpy = numpy
        self.low: int = 0
        self.high: float | int = 0
        if python is int:
            bits = 8 * size
            signed = code.islower()
            self.low = -(1 << (bits - 1)) if signed else 0
            self.high = (1 << (bits - 1)) - 1 if signed else (1 << bits) - 1


_TABLE = (
    Primitive("bool", "boolean", "?", 1, 15, bool, "False"),
    Primitive("byte", "octet", "c", 1, 16, bytes, "b'\\x00'"),
    Primitive("char", "uint8", "B", 1, 3, int, "0", "uint8"),
    Primitive("float32", "float", "f", 4, 10, float, "0.0", "float32"),
    Primitive("float64", "double", "d", 8, 11, float, "0.0", "float64"),
    Primitive("int8", "int8", "b", 1, 2, int, "0", "int8"),
    Primitive("uint8", "uint8", "B", 1, 3, int, "0", "uint8"),
    Primitive("int16", "int16", "h", 2, 4, int, "0", "int16"),
    Primitive("uint16", "uint16", "H", 2, 5, int, "0", "uint16"),
    Primitive("int32", "int32", "i", 4, 6, int, "0", "int32"),
    Primitive("uint32", "uint32", "I", 4, 7, int, "0", "uint32"),
    Primitive("int64", "int64", "q", 8, 8, int, "0", "int64"),
    Primitive("uint64", "uint64", "Q", 8, 9, int, "0", "uint64"),
)
PRIMITIVES: dict[str, Primitive] = {primitive.name: primitive for primitive in _TABLE}
# The bounds rosidl_generator_py writes into its checks (not exactly FLT_MAX).
PRIMITIVES["float32"].high = 3.402823466e38
PRIMITIVES["float64"].high = 1.7976931348623157e308

STRINGS = ("string", "wstring")

SINGLE, ARRAY, BOUNDED, UNBOUNDED = "single", "array", "bounded", "unbounded"


class FieldType:
    """The type of a field: the type of one element, and the number of elements.

    `base` is a primitive's .msg name, 'string', 'wstring' or a full name like 'std_msgs/msg/Header'. `string_bound` is the
    maximum length of a bounded string in characters, 0 if unbounded. `count` is SINGLE, ARRAY, BOUNDED or UNBOUNDED, and
    `size` the length of an ARRAY or the bound of a BOUNDED sequence.
    """

    __slots__ = ("base", "count", "nested", "primitive", "size", "string_bound")

    def __init__(self, base: str, string_bound: int = 0, count: str = SINGLE, size: int = 0) -> None:
        self.base = base
        self.string_bound = string_bound
        self.count = count
        self.size = size
        self.primitive = PRIMITIVES.get(base)
        self.nested = "/" in base

    def element_name(self) -> str:
        """Return the IDL-like name of one element: 'double', 'string<10>', 'std_msgs/Header'."""
        if self.primitive is not None:
            return self.primitive.idl
        if self.nested:
            package, _, name = self.base.split("/")
            return f"{package}/{name}"
        return f"{self.base}<{self.string_bound}>" if self.string_bound else self.base

    def idl_name(self) -> str:
        """Return the type as in `get_fields_and_field_types()`: 'sequence<double, 3>', 'double[36]', 'string'."""
        element = self.element_name()
        if self.count == ARRAY:
            return f"{element}[{self.size}]"
        if self.count == BOUNDED:
            return f"sequence<{element}, {self.size}>"
        if self.count == UNBOUNDED:
            return f"sequence<{element}>"
        return element

    def msg_name(self) -> str:
        """Return the type as in a .msg file: 'float64[<=3]', 'string<=10', 'std_msgs/Header'."""
        base = self.element_name() if self.nested else self.base
        if self.string_bound:
            base += f"<={self.string_bound}"
        if self.count == SINGLE:
            return base
        return f"{base}[{'<=' if self.count == BOUNDED else ''}{self.size or ''}]"

    def is_numeric_array(self) -> bool:
        """Return whether the values are one block of memory: array.array for sequences, numpy.ndarray for arrays."""
        return self.count != SINGLE and self.primitive is not None and bool(self.primitive.numpy)
