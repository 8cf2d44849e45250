"""The parameters of one node: declared, read and set by their rules, all of them or none. It works without a node."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Final, Protocol

from rclpy._day6.parameter_declarations import declared_parameter
from rclpy._day6.parameter_rules import accepted, refusal_of_range, refusal_of_type, refused
from rclpy.exceptions import (
    InvalidParameterTypeException,
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterImmutableException,
    ParameterNotDeclaredException,
    ParameterUninitializedException,
)
from rclpy.parameter import PARAMETER_SEPARATOR_STRING, Parameter

if TYPE_CHECKING:
    from rcl_interfaces.msg import ListParametersResult, ParameterDescriptor, ParameterValue, SetParametersResult

    from rclpy._day6.parameter_declarations import ParameterTuple

    PreSetCallback = Callable[[list[Parameter[Any]]], list[Parameter[Any]]]
    OnSetCallback = Callable[[list[Parameter[Any]]], SetParametersResult]
    PostSetCallback = Callable[[list[Parameter[Any]]], None]

_NOT_SET: Final = Parameter.Type.NOT_SET


class ParameterListener(Protocol):
    """The listener of a store's changes: a node's topic /parameter_events."""

    def require(self) -> None:
        """Raise if the parameters may no longer be changed."""

    def has_subscribers(self) -> bool:
        """Return whether a change would reach any subscription."""

    def changed(self, new: list[Parameter[Any]], changed: list[Parameter[Any]], deleted: list[Parameter[Any]]) -> None:
        """Called with parameters that were set together."""


class _Descriptors(dict[str, Any]):
    """Descriptors by parameter name. One may be stored as a dict of its fields: its message is made when it is read."""

    def __getitem__(self, name: str) -> ParameterDescriptor:
        descriptor = super().__getitem__(name)
        if isinstance(descriptor, dict):
            from rcl_interfaces.msg import ParameterDescriptor

            self[name] = descriptor = ParameterDescriptor(**descriptor)
        made: ParameterDescriptor = descriptor
        return made


class ParameterStore:
    """The parameters of a node, with descriptors, overrides and callbacks.

    `overrides` are initial values that win over those in declarations; `rel_tol` is how far, relatively, a float may be from
    a range's end or step and still count as on it. `listener` is called for every change.
    """

    def __init__(
        self,
        *,
        overrides: dict[str, Parameter[Any]] | None = None,
        allow_undeclared: bool = False,
        rel_tol: float = 1e-6,
        listener: ParameterListener | None = None,
    ) -> None:
        self.parameters: dict[str, Parameter[Any]] = {}
        self.overrides: dict[str, Parameter[Any]] = {} if overrides is None else overrides
        self.descriptors = _Descriptors()
        self.allow_undeclared = allow_undeclared
        self.pre_set_callbacks: list[PreSetCallback] = []
        self.on_set_callbacks: list[OnSetCallback] = []
        self.post_set_callbacks: list[PostSetCallback] = []
        self._rel_tol = rel_tol
        self._listener = listener

    # -- declaring -----------------------------------------------------------------------------------------------------

    def declare(
        self, namespace: str, entries: Sequence[ParameterTuple], ignore_override: bool = False
    ) -> list[Parameter[Any]]:
        """Declare parameters, given as tuples (name[, value[, descriptor]]), in a namespace; return them with their values.

        Raises as `declared_parameter`, and ParameterAlreadyDeclaredException, InvalidParameterValueException (refused by range
        or callback), InvalidParameterTypeException (override of another type). Parameters before the refused one stay declared.
        """
        overrides = {} if ignore_override else self.overrides
        declared = [declared_parameter(namespace, index, entry, overrides) for index, entry in enumerate(entries)]
        known = [parameter.name for parameter, _ in declared if parameter.name in self.parameters]
        if known:
            raise ParameterAlreadyDeclaredException(known)
        descriptors = {parameter.name: descriptor for parameter, descriptor in declared}
        for parameter, _ in declared:
            self._declare(parameter, descriptors)
        return [self.parameters[parameter.name] for parameter, _ in declared]

    def _declare(self, parameter: Parameter[Any], descriptors: Mapping[str, ParameterDescriptor]) -> None:
        result = self._set_checked([parameter], descriptors)
        if result.successful:
            return
        if result.reason.startswith("Wrong parameter type"):
            expected = Parameter.Type(descriptors[parameter.name].type).name
            raise InvalidParameterTypeException(parameter, expected)
        raise InvalidParameterValueException(parameter.name, parameter.value, result.reason)

    def declare_plain(self, name: str, value: bool | int | str, **descriptor: Any) -> None:
        """Declare one of the parameters every node has, without making messages unless they are needed."""
        if name in self.overrides or (self._listener is not None and self._listener.has_subscribers()):
            from rcl_interfaces.msg import ParameterDescriptor

            self.declare("", [(name, value, ParameterDescriptor(**descriptor))])
            return
        parameter: Parameter[Any] = Parameter(name, value=value)
        self.parameters[name] = parameter
        self.descriptors.update({name: {"name": name, "type": parameter.type_.value, **descriptor}})

    def undeclare(self, name: str) -> None:
        """Forget a parameter. Raises ParameterNotDeclaredException, ParameterImmutableException for a read-only one."""
        if name not in self.parameters:
            raise ParameterNotDeclaredException(name)
        if self.descriptors[name].read_only:
            raise ParameterImmutableException(name)
        del self.parameters[name]
        del self.descriptors[name]

    # -- getting -------------------------------------------------------------------------------------------------------

    def has(self, name: str) -> bool:
        """Return whether a parameter is declared."""
        return name in self.parameters

    def type_of(self, name: str) -> int:
        """Return a parameter's type as a number; NOT_SET or ParameterNotDeclaredException for an undeclared one."""
        if name in self.parameters:
            return self.parameters[name].type_.value
        if self.allow_undeclared:
            return _NOT_SET
        raise ParameterNotDeclaredException(name)

    def types_of(self, names: list[str]) -> list[int]:
        """Return the types of some parameters; see `type_of`."""
        return [self.type_of(name) for name in _texts(names)]

    def get(self, name: str) -> Parameter[Any]:
        """Return a parameter.

        Raises ParameterNotDeclaredException (unless undeclared ones are allowed: then it is NOT_SET), and
        ParameterUninitializedException for one declared by type alone that has no value yet.
        """
        parameter = self.parameters.get(name)
        if parameter is not None:
            if parameter.type_ != _NOT_SET or self.descriptors[name].dynamic_typing:
                return parameter
            raise ParameterUninitializedException(name)
        if self.allow_undeclared:
            return Parameter(name, _NOT_SET, None)
        raise ParameterNotDeclaredException(name)

    def get_each(self, names: list[str]) -> list[Parameter[Any]]:
        """Return some parameters; see `get`."""
        return [self.get(name) for name in _texts(names)]

    def get_or(self, name: str, alternative: Parameter[Any] | None = None) -> Parameter[Any]:
        """Return a parameter, or the alternative (by default a NOT_SET one) if it is undeclared or has no value."""
        parameter = self.parameters.get(name)
        if parameter is not None and parameter.type_ != _NOT_SET:
            return parameter
        return Parameter(name, _NOT_SET) if alternative is None else alternative

    def by_prefix(self, prefix: str) -> dict[str, Parameter[Any]]:
        """Return the parameters below a prefix, by their names without it; '' means all."""
        if prefix:
            prefix += PARAMETER_SEPARATOR_STRING
        return {
            name[len(prefix) :]: parameter for name, parameter in self.parameters.items() if name.startswith(prefix)
        }

    def names_below(self, prefixes: list[str], depth: int) -> ListParametersResult:
        """Return names and prefixes of parameters below some prefixes (none: all), down to a depth (0: any)."""
        from rcl_interfaces.msg import ListParametersResult

        if not isinstance(prefixes, list):
            raise TypeError("The prefixes argument must be a list")
        if not all(isinstance(prefix, str) for prefix in prefixes):
            raise TypeError("All prefixes must be instances of type str")
        if not isinstance(depth, int):
            raise TypeError("The depth must be instance of type int")
        if depth < 0:
            raise ValueError("The depth must be greater than or equal to zero")
        result = ListParametersResult()
        for name in self.parameters:
            if not _listed(name, prefixes, depth):
                continue
            result.names.append(name)
            prefix = name.rpartition(PARAMETER_SEPARATOR_STRING)[0]
            if prefix and prefix not in result.prefixes:
                result.prefixes.append(prefix)
        return result

    # -- setting -------------------------------------------------------------------------------------------------------

    def set_each(self, parameters: list[Parameter[Any]]) -> list[SetParametersResult]:
        """Set parameters one by one; returns a result for each. Raises ParameterNotDeclaredException."""
        return [self.set_atomically([parameter]) for parameter in parameters]

    def set_atomically(self, parameters: list[Parameter[Any]]) -> SetParametersResult:
        """Set all parameters or none; the result has the reason. Raises ParameterNotDeclaredException."""
        if self.pre_set_callbacks:
            modified: list[Parameter[Any]] = []
            for callback in self.pre_set_callbacks:
                modified.extend(callback(parameters))
            parameters = modified
            if not parameters:
                return refused(
                    "parameter list cannot be empty, this might be due to pre_set_parameters_callback modifying "
                    "the original parameters list."
                )
        if not all(isinstance(parameter, Parameter) for parameter in parameters):
            raise TypeError(f"parameter must be instance of type '{Parameter!r}'")
        undeclared = [parameter.name for parameter in parameters if parameter.name not in self.parameters]
        if undeclared and not self.allow_undeclared:
            # Real rclpy has consumed the first name before it makes the text.
            raise ParameterNotDeclaredException(undeclared[1:])
        return self._set_checked(parameters)

    def _set_checked(
        self, parameters: list[Parameter[Any]], declared: Mapping[str, ParameterDescriptor] | None = None
    ) -> SetParametersResult:
        """Set parameters if rules and callbacks allow it; `declared` are the descriptors of parameters that this declares."""
        result = self._obey(parameters, self.descriptors if declared is None else declared, declared is None)
        if not result.successful:
            return result
        for callback in self.on_set_callbacks:
            result = callback(parameters)
            if not _is_result(result):
                warnings.warn("Callback returned an invalid type, it should return SetParameterResult.", stacklevel=1)
                result = refused("Callback returned an invalid type")
            if not result.successful:
                return result
        listener = self._listener
        if listener is not None:
            listener.require()
        new, changed, deleted = self._keep(parameters, declared)
        if listener is not None and listener.has_subscribers():
            listener.changed(new, changed, deleted)
        for post_callback in self.post_set_callbacks:
            post_callback(parameters)
        return accepted()

    def _keep(
        self, parameters: list[Parameter[Any]], declared: Mapping[str, ParameterDescriptor] | None
    ) -> tuple[list[Parameter[Any]], list[Parameter[Any]], list[Parameter[Any]]]:
        """Store parameters; returns which are new, changed and deleted. Only a declaration leaves one without a value."""
        new: list[Parameter[Any]] = []
        changed: list[Parameter[Any]] = []
        deleted: list[Parameter[Any]] = []
        for parameter in parameters:
            name = parameter.name
            if parameter.type_ == _NOT_SET and declared is None:
                deleted.append(parameter)
                self.parameters.pop(name, None)
                self.descriptors.pop(name, None)
                continue
            if declared is not None:
                self.descriptors[name] = declared[name]
            elif name not in self.descriptors:
                self.descriptors.update({name: {"dynamic_typing": True}})
            if _exceeds_int64(parameter.value):
                parameter.to_parameter_msg()  # AssertionError: real rclpy first puts every change into a message
            (new if self.get_or(name).type_ == _NOT_SET else changed).append(parameter)
            self.parameters[name] = parameter
        return new, changed, deleted

    # -- callbacks -----------------------------------------------------------------------------------------------------

    def add_pre_set_callback(self, callback: PreSetCallback) -> None:
        """Call `callback(parameters)` before parameters are checked; it returns the list to set."""
        self.pre_set_callbacks.insert(0, callback)

    def add_on_set_callback(self, callback: OnSetCallback) -> None:
        """Call `callback(parameters)` before parameters are set; it returns a SetParametersResult. Last added, first called."""
        if not callable(callback):
            raise TypeError("Callback must be callable, got {}", type(callback))
        self.on_set_callbacks.insert(0, callback)

    def add_post_set_callback(self, callback: PostSetCallback) -> None:
        """Call `callback(parameters)` after parameters were set. The last one added is called first."""
        if not callable(callback):
            raise TypeError("Callback must be callable, got {}", type(callback))
        self.post_set_callbacks.insert(0, callback)

    # -- rules ---------------------------------------------------------------------------------------------------------

    def _obey(
        self, parameters: list[Parameter[Any]], descriptors: Mapping[str, ParameterDescriptor], check_read_only: bool
    ) -> SetParametersResult:
        for parameter in parameters:
            if parameter.name in descriptors:
                result = self._obeys(parameter, descriptors[parameter.name], check_read_only)
                if not result.successful:
                    return result
        return accepted()

    def _obeys(
        self, parameter: Parameter[Any], descriptor: ParameterDescriptor, check_read_only: bool
    ) -> SetParametersResult:
        """Check a parameter against its descriptor; a dynamically typed descriptor takes on the parameter's type."""
        descriptor.name = parameter.name
        if check_read_only and descriptor.read_only:
            return refused(f"Trying to set a read-only parameter: {parameter.name}.")
        refusal = refusal_of_type(parameter, descriptor, parameter.name in self.parameters)
        if refusal is None:
            refusal = refusal_of_range(parameter, descriptor, self._rel_tol)
        return accepted() if refusal is None else refused(refusal)

    def describe(self, name: str) -> ParameterDescriptor:
        """Return a parameter's descriptor; an empty one or ParameterNotDeclaredException for an undeclared one."""
        if name in self.descriptors:
            return self.descriptors[name]
        if not self.allow_undeclared:
            raise ParameterNotDeclaredException(name)
        from rcl_interfaces.msg import ParameterDescriptor

        return ParameterDescriptor()

    def describe_each(self, names: list[str]) -> list[ParameterDescriptor]:
        """Return the descriptors of some parameters; see `describe`."""
        return [self.describe(name) for name in names]

    def set_descriptor(
        self, name: str, descriptor: ParameterDescriptor, alternative_value: ParameterValue | None = None
    ) -> ParameterValue:
        """Replace a parameter's descriptor; if its value does not fit the new one, the parameter takes the alternative value.

        Returns the resulting value. Raises ParameterNotDeclaredException, ParameterImmutableException and
        InvalidParameterValueException (the alternative doesn't fit either).
        """
        if name not in self.parameters:
            if not self.allow_undeclared:
                raise ParameterNotDeclaredException(name)
            return self.get(name).get_parameter_value()
        if self.describe(name).read_only:
            raise ParameterImmutableException(name)
        parameter = self.get(name)
        alternative = parameter
        if alternative_value is not None:
            from rcl_interfaces.msg import Parameter as ParameterMsg

            alternative = Parameter.from_parameter_msg(ParameterMsg(name=name, value=alternative_value))
        for candidate in (parameter, alternative):
            result = self._obeys(candidate, descriptor, False)
            if result.successful:
                self.parameters[name] = candidate
                self.descriptors[name] = descriptor
                return self.get(name).get_parameter_value()
        raise InvalidParameterValueException(name, alternative.value, result.reason)


def _is_result(value: object) -> bool:
    from rcl_interfaces.msg import SetParametersResult

    return isinstance(value, SetParametersResult)


def _texts(names: list[str]) -> list[str]:
    if not all(isinstance(name, str) for name in names):
        raise TypeError("All names must be instances of type str")
    return names


def _listed(name: str, prefixes: list[str], depth: int) -> bool:
    separator = PARAMETER_SEPARATOR_STRING
    if not prefixes:
        return depth == 0 or name.count(separator) < depth
    for prefix in prefixes:
        below = name.startswith(prefix + separator)
        if name == prefix or (below and (depth == 0 or name[len(prefix) + 1 :].count(separator) < depth)):
            return True
    return False


def _exceeds_int64(value: Any) -> bool:
    integers = value if isinstance(value, (list, tuple)) else (value,)
    return any(isinstance(each, int) and not -(2**63) <= each < 2**63 for each in integers)
