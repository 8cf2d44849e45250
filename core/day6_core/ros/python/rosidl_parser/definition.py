"""The types of message fields, as in SLOT_TYPES; programs distinguish them with isinstance.

Names, attributes and equality are those of rosidl_parser.definition in ROS 2, without the parts that only an IDL parser needs.
"""

from __future__ import annotations

SIGNED_NONEXPLICIT_INTEGER_TYPES = ("short", "long", "long long")
UNSIGNED_NONEXPLICIT_INTEGER_TYPES = ("unsigned short", "unsigned long", "unsigned long long")
NONEXPLICIT_INTEGER_TYPES = SIGNED_NONEXPLICIT_INTEGER_TYPES + UNSIGNED_NONEXPLICIT_INTEGER_TYPES
FLOATING_POINT_TYPES = ("float", "double", "long double")
CHARACTER_TYPES = ("char", "wchar")
BOOLEAN_TYPE = "boolean"
OCTET_TYPE = "octet"
SIGNED_EXPLICIT_INTEGER_TYPES = ("int8", "int16", "int32", "int64")
UNSIGNED_EXPLICIT_INTEGER_TYPES = ("uint8", "uint16", "uint32", "uint64")
EXPLICIT_INTEGER_TYPES = SIGNED_EXPLICIT_INTEGER_TYPES + UNSIGNED_EXPLICIT_INTEGER_TYPES
SIGNED_INTEGER_TYPES = SIGNED_NONEXPLICIT_INTEGER_TYPES + SIGNED_EXPLICIT_INTEGER_TYPES
UNSIGNED_INTEGER_TYPES = UNSIGNED_NONEXPLICIT_INTEGER_TYPES + UNSIGNED_EXPLICIT_INTEGER_TYPES
INTEGER_TYPES = SIGNED_INTEGER_TYPES + UNSIGNED_INTEGER_TYPES
BASIC_TYPES = (*INTEGER_TYPES, *FLOATING_POINT_TYPES, *CHARACTER_TYPES, BOOLEAN_TYPE, OCTET_TYPE)

EMPTY_STRUCTURE_REQUIRED_MEMBER_NAME = "structure_needs_at_least_one_member"
SERVICE_REQUEST_MESSAGE_SUFFIX = "_Request"
SERVICE_RESPONSE_MESSAGE_SUFFIX = "_Response"
SERVICE_EVENT_MESSAGE_SUFFIX = "_Event"
ACTION_GOAL_SUFFIX = "_Goal"
ACTION_RESULT_SUFFIX = "_Result"
ACTION_FEEDBACK_SUFFIX = "_Feedback"
ACTION_GOAL_SERVICE_SUFFIX = "_SendGoal"
ACTION_RESULT_SERVICE_SUFFIX = "_GetResult"
ACTION_FEEDBACK_MESSAGE_SUFFIX = "_FeedbackMessage"


class AbstractType:
    """The type of a field. Objects of the same class with equal attributes are equal; they can't be hashed."""

    __slots__: tuple[str, ...] = ()

    def _attributes(self) -> tuple[object, ...]:
        """Return the attributes that equality compares."""
        return ()

    def __eq__(self, other: object) -> bool:
        """Compare class and attributes."""
        if not isinstance(other, AbstractType) or type(self) is not type(other):
            return False
        return self._attributes() == other._attributes()

    __hash__ = None  # type: ignore[assignment]


class AbstractNestableType(AbstractType):
    """A type that may be the element of an array or sequence."""

    __slots__ = ()


class BasicType(AbstractNestableType):
    """A number, bool, character or octet; `typename` is its IDL name, like 'double' or 'uint8'."""

    __slots__ = ("typename",)

    def __init__(self, typename: str) -> None:
        assert typename in BASIC_TYPES
        self.typename = typename

    def _attributes(self) -> tuple[object, ...]:
        return (self.typename,)


class NamedType(AbstractNestableType):
    """A type known only by its name."""

    __slots__ = ("name",)

    def __init__(self, name: str) -> None:
        self.name = name

    def _attributes(self) -> tuple[object, ...]:
        return (self.name,)


class NamespacedType(AbstractNestableType):
    """Another message: NamespacedType(['std_msgs', 'msg'], 'Header')."""

    __slots__ = ("name", "namespaces")

    def __init__(self, namespaces: list[str], name: str) -> None:
        self.namespaces = namespaces
        self.name = name

    def namespaced_name(self) -> tuple[str, ...]:
        """Return ('std_msgs', 'msg', 'Header')."""
        return (*self.namespaces, self.name)

    def _attributes(self) -> tuple[object, ...]:
        return (self.namespaces, self.name)


class AbstractGenericString(AbstractNestableType):
    """A string of any character type."""

    __slots__ = ()

    def has_maximum_size(self) -> bool:
        """Return whether the length is bounded."""
        raise NotImplementedError("Only implemented in subclasses")


class AbstractString(AbstractGenericString):
    """A string of 8-bit characters (UTF-8)."""

    __slots__ = ()


class AbstractWString(AbstractGenericString):
    """A string of 16-bit characters."""

    __slots__ = ()


class BoundedString(AbstractString):
    """A string of at most `maximum_size` characters."""

    __slots__ = ("maximum_size",)

    def __init__(self, maximum_size: int) -> None:
        assert maximum_size >= 0
        self.maximum_size = maximum_size

    def has_maximum_size(self) -> bool:
        """Return True."""
        return True

    def _attributes(self) -> tuple[object, ...]:
        return (self.maximum_size,)


class UnboundedString(AbstractString):
    """A string of any length."""

    __slots__ = ()

    def has_maximum_size(self) -> bool:
        """Return False."""
        return False


class BoundedWString(AbstractWString):
    """A wide string of at most `maximum_size` characters."""

    __slots__ = ("maximum_size",)

    def __init__(self, maximum_size: int) -> None:
        self.maximum_size = maximum_size

    def has_maximum_size(self) -> bool:
        """Return True."""
        return True

    def _attributes(self) -> tuple[object, ...]:
        return (self.maximum_size,)


class UnboundedWString(AbstractWString):
    """A wide string of any length."""

    __slots__ = ()

    def has_maximum_size(self) -> bool:
        """Return False."""
        return False


class AbstractNestedType(AbstractType):
    """Several values of one type, `value_type`."""

    __slots__ = ("value_type",)

    def __init__(self, value_type: AbstractNestableType) -> None:
        assert isinstance(value_type, AbstractNestableType)
        self.value_type = value_type

    def has_maximum_size(self) -> bool:
        """Return whether the number of values is bounded."""
        raise NotImplementedError("Only implemented in subclasses")

    def _attributes(self) -> tuple[object, ...]:
        return (self.value_type,)


class Array(AbstractNestedType):
    """Exactly `size` values."""

    __slots__ = ("size",)

    def __init__(self, value_type: AbstractNestableType, size: int) -> None:
        super().__init__(value_type)
        assert size > 0
        self.size = size

    def has_maximum_size(self) -> bool:
        """Return True."""
        return True

    def _attributes(self) -> tuple[object, ...]:
        return (self.value_type, self.size)


class AbstractSequence(AbstractNestedType):
    """A variable number of values."""

    __slots__ = ()


class BoundedSequence(AbstractSequence):
    """At most `maximum_size` values."""

    __slots__ = ("maximum_size",)

    def __init__(self, value_type: AbstractNestableType, maximum_size: int) -> None:
        super().__init__(value_type)
        assert maximum_size > 0
        self.maximum_size = maximum_size

    def has_maximum_size(self) -> bool:
        """Return True."""
        return True

    def _attributes(self) -> tuple[object, ...]:
        return (self.value_type, self.maximum_size)


class UnboundedSequence(AbstractSequence):
    """Any number of values."""

    __slots__ = ()

    def has_maximum_size(self) -> bool:
        """Return False."""
        return False
