"""Filters that let a message through when something in it has changed."""

from __future__ import annotations

from abc import ABC
from collections.abc import Callable, Iterable
from functools import partial
from typing import Any

from message_filters.simple_filter import SimpleFilter


class ComparisonHandler(ABC):  # noqa: B024 - none of its methods is abstract in the original
    """Decides which messages go through."""

    def message_fits(self, message: Any) -> bool:
        """Return whether a message goes through."""
        raise NotImplementedError()

    def do_fields_fit(self, field_a: Any, field_b: Any) -> bool:
        """Return whether the values of a field in two messages let the second one through."""
        raise NotImplementedError()


class CachedComparisonHandler(ComparisonHandler):
    """Compares with the last message that went through; one field that fits is enough."""

    _field_getters: Iterable[Callable[[Any], Any]] = ()

    def __init__(self) -> None:
        super().__init__()
        self._message_cache: Any = None

    def message_fits(self, message: Any) -> bool:
        """Return whether a message goes through, the first one in any case, and remember it then."""
        fits = self._message_cache is None or any(
            self.do_fields_fit(value_of(self._message_cache), value_of(message)) for value_of in self._field_getters
        )
        if fits:
            self._message_cache = message
        return fits

    def do_fields_fit(self, field_a: Any, field_b: Any) -> bool:
        """Return whether the values of a field in two messages let the second one through."""
        raise NotImplementedError(
            f"Field comparison not implemented for class: {type(self).__name__}. Consider implementing do_fields_fit"
        )


class DeltaCompare(CachedComparisonHandler):
    """Lets a message through in which a field differs; only bool, int, float and str are compared."""

    _basic_types = (bool, int, float, str)

    def __init__(self, field_getters: Iterable[Callable[[Any], Any]]) -> None:
        super().__init__()
        self._field_getters = field_getters

    def do_fields_fit(self, field_a: Any, field_b: Any) -> bool:
        """Return whether two values differ. Raises TypeError for a message, an array and so on."""
        if not (isinstance(field_a, self._basic_types) and isinstance(field_b, self._basic_types)):
            raise TypeError(f"Unable to compare fields of types {type(field_a)} and {type(field_b)}")
        return field_a != field_b


class ComparisonFilter(SimpleFilter):
    """Passes on the messages that a handler lets through."""

    def __init__(self, comparison_handler: ComparisonHandler, message_filter: SimpleFilter | None = None) -> None:
        super().__init__()
        self._comparison_handler = comparison_handler
        self.incoming_connection: int | None = None
        self.connectInput(message_filter)

    def add(self, message: Any) -> None:
        """Receive a message."""
        if self.message_fits(message):
            self.signalMessage(message)

    def message_fits(self, message: Any) -> bool:
        """Return whether a message goes through."""
        return self._comparison_handler.message_fits(message)

    def connectInput(self, message_filter: SimpleFilter | None) -> None:
        """Connect to a filter's output. Raises RuntimeError if it is connected already."""
        if self.incoming_connection is not None:
            raise RuntimeError("This instance of ComparisonFilter already has an incoming connection")
        if message_filter is not None:
            self.incoming_connection = message_filter.registerCallback(self.add)


class DeltaFilter(ComparisonFilter):
    """Passes on a message if one of `field_getters` returns another value for it than for the last one that was passed on."""

    def __init__(
        self, field_getters: Iterable[Callable[[Any], Any]], message_filter: SimpleFilter | None = None
    ) -> None:
        super().__init__(DeltaCompare(field_getters), message_filter)


class PathDeltaFilter(DeltaFilter):
    """A DeltaFilter of fields that are named, like 'pose.position.x'."""

    def __init__(self, field_path_list: Iterable[str], message_filter: SimpleFilter | None = None) -> None:
        getters = [partial(self.get_field_by_path, field_path=path) for path in field_path_list]
        super().__init__(getters, message_filter)

    def get_field_by_path(self, message: Any, field_path: str) -> Any:
        """Return the value of a field. Raises RuntimeError if there is none."""
        value = message
        for name in field_path.split("."):
            owner, value = value, getattr(value, name, None)
            if value is None:
                raise RuntimeError(
                    f"Unable to access field {name!r} of {type(owner).__name__} (full path: {field_path!r})"
                )
        return value
