"""Parameters of a node: declaring, getting and setting them, their rules and callbacks."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

from rclpy._node_declarations import NodeDeclarations
from rclpy._parameter_rules import accepted, refusal_of_range, refusal_of_type, refused
from rclpy.exceptions import (
    InvalidParameterValueException,
    ParameterImmutableException,
    ParameterNotDeclaredException,
    ParameterUninitializedException,
)
from rclpy.parameter import PARAMETER_SEPARATOR_STRING, Parameter

if TYPE_CHECKING:
    from rcl_interfaces.msg import ListParametersResult, ParameterDescriptor, ParameterValue, SetParametersResult

    from rclpy._handles import NodeHandle
    from rclpy.clock import Clock
    from rclpy.publisher import Publisher

PreSetCallback = Callable[[list[Parameter[Any]]], list[Parameter[Any]]]
OnSetCallback = Callable[[list[Parameter[Any]]], Any]
PostSetCallback = Callable[[list[Parameter[Any]]], None]

_NOT_SET = Parameter.Type.NOT_SET


class _Descriptors(dict[str, Any]):
    """Descriptors by parameter name. Those of a node's own parameters are made when somebody looks."""

    def __getitem__(self, name: str) -> Any:
        descriptor = super().__getitem__(name)
        if isinstance(descriptor, dict):
            from rcl_interfaces.msg import ParameterDescriptor

            self[name] = descriptor = ParameterDescriptor(**descriptor)
        return descriptor


class NodeParameters(NodeDeclarations):
    """The parameter part of `rclpy.node.Node`."""

    PARAM_REL_TOL = 1e-6
    """How far, relatively, a float may be from a range's end or step and still count as on it."""

    _parameters: dict[str, Parameter[Any]]
    _parameter_overrides: dict[str, Parameter[Any]]
    _parameter_event_publisher: Publisher[Any] | None
    _clock: Clock
    handle: NodeHandle

    def _set_up_parameters(self, allow_undeclared: bool) -> None:
        self._parameters = {}
        self._parameter_overrides = {}
        self._descriptors: dict[str, Any] = _Descriptors()
        self._allow_undeclared_parameters = allow_undeclared
        self._pre_set_parameters_callbacks: list[PreSetCallback] = []
        self._on_set_parameters_callbacks: list[OnSetCallback] = []
        self._post_set_parameters_callbacks: list[PostSetCallback] = []

    # getting

    def has_parameter(self, name: str) -> bool:
        """Say whether a parameter is declared."""
        return name in self._parameters

    def get_parameter_types(self, names: list[str]) -> list[Any]:
        """Return the types of some parameters; see `get_parameter_type`."""
        return [self.get_parameter_type(name) for name in _texts(names)]

    def get_parameter_type(self, name: str) -> Any:
        """Return a parameter's type as a number; NOT_SET or ParameterNotDeclaredException for an undeclared one."""
        if name in self._parameters:
            return self._parameters[name].type_.value
        if self._allow_undeclared_parameters:
            return _NOT_SET
        raise ParameterNotDeclaredException(name)

    def get_parameters(self, names: list[str]) -> list[Parameter[Any]]:
        """Return some parameters; see `get_parameter`."""
        return [self.get_parameter(name) for name in _texts(names)]

    def get_parameter(self, name: str) -> Parameter[Any]:
        """Return a parameter.

        Raises ParameterNotDeclaredException (unless undeclared ones are allowed: then it is NOT_SET), and
        ParameterUninitializedException for one declared by type alone that has no value yet.
        """
        parameter = self._parameters.get(name)
        if parameter is not None:
            if parameter.type_ != _NOT_SET or self._descriptors[name].dynamic_typing:
                return parameter
            raise ParameterUninitializedException(name)
        if self._allow_undeclared_parameters:
            return Parameter(name, _NOT_SET, None)
        raise ParameterNotDeclaredException(name)

    def get_parameter_or(self, name: str, alternative_value: Parameter[Any] | None = None) -> Parameter[Any]:
        """Return a parameter, or the alternative (by default a NOT_SET one) if it is undeclared or has no value."""
        parameter = self._parameters.get(name)
        if parameter is not None and parameter.type_ != _NOT_SET:
            return parameter
        return Parameter(name, _NOT_SET) if alternative_value is None else alternative_value

    def get_parameters_by_prefix(self, prefix: str) -> dict[str, Parameter[Any]]:
        """Return the parameters below a prefix, by their names without it; '' means all."""
        if prefix:
            prefix += PARAMETER_SEPARATOR_STRING
        return {
            name[len(prefix) :]: parameter for name, parameter in self._parameters.items() if name.startswith(prefix)
        }

    def list_parameters(self, prefixes: list[str], depth: int) -> ListParametersResult:
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
        for name in self._parameters:
            if not _listed(name, prefixes, depth):
                continue
            result.names.append(name)
            prefix = name.rpartition(PARAMETER_SEPARATOR_STRING)[0]
            if prefix and prefix not in result.prefixes:
                result.prefixes.append(prefix)
        return result

    # setting

    def set_parameters(self, parameter_list: list[Parameter[Any]]) -> list[SetParametersResult]:
        """Set parameters one after the other; returns a result for each. Raises ParameterNotDeclaredException."""
        return [self._set_parameters_atomically([parameter]) for parameter in parameter_list]

    def set_parameters_atomically(self, parameter_list: list[Parameter[Any]]) -> SetParametersResult:
        """Set all parameters or none. Raises ParameterNotDeclaredException."""
        return self._set_parameters_atomically(parameter_list)

    def _set_parameters_atomically(self, parameter_list: list[Parameter[Any]]) -> SetParametersResult:
        if self._pre_set_parameters_callbacks:
            modified: list[Parameter[Any]] = []
            for callback in self._pre_set_parameters_callbacks:
                modified.extend(callback(parameter_list))
            parameter_list = modified
            if not parameter_list:
                return refused(
                    "parameter list cannot be empty, this might be due to pre_set_parameters_callback modifying "
                    "the original parameters list."
                )
        self._check_undeclared_parameters(parameter_list)
        return self._set_parameters_atomically_common(parameter_list)

    def _check_undeclared_parameters(self, parameter_list: list[Parameter[Any]]) -> None:
        if not all(isinstance(parameter, Parameter) for parameter in parameter_list):
            raise TypeError(f"parameter must be instance of type '{Parameter!r}'")
        undeclared = [parameter.name for parameter in parameter_list if parameter.name not in self._parameters]
        if undeclared and not self._allow_undeclared_parameters:
            # Real rclpy has used up the first name when it makes the text.
            raise ParameterNotDeclaredException(undeclared[1:])

    def _set_parameters_atomically_common(
        self,
        parameter_list: list[Parameter[Any]],
        descriptors: dict[str, Any] | None = None,
        allow_not_set_type: bool = False,
    ) -> SetParametersResult:
        if descriptors is not None:
            result = self._apply_descriptors(parameter_list, descriptors, False)
        else:
            result = self._apply_descriptors(parameter_list, self._descriptors, True)
        if not result.successful:
            return result
        for callback in self._on_set_parameters_callbacks:
            answer = callback(parameter_list)
            if not _is_result(answer):
                warnings.warn("Callback returned an invalid type, it should return SetParameterResult.", stacklevel=1)
                answer = refused("Callback returned an invalid type")
            if not answer.successful:
                return answer
        self.handle.check()
        new, changed, deleted = self._store(parameter_list, descriptors, allow_not_set_type)
        publisher = self._parameter_event_publisher
        if publisher is not None and publisher._endpoint_is_heard():
            self._publish_event(publisher, new, changed, deleted)
        for post_callback in self._post_set_parameters_callbacks:
            post_callback(parameter_list)
        return accepted()

    def _store(
        self, parameter_list: list[Parameter[Any]], descriptors: dict[str, Any] | None, allow_not_set_type: bool
    ) -> tuple[list[Parameter[Any]], list[Parameter[Any]], list[Parameter[Any]]]:
        """Store parameters; returns which are new, changed and deleted."""
        new: list[Parameter[Any]] = []
        changed: list[Parameter[Any]] = []
        deleted: list[Parameter[Any]] = []
        for parameter in parameter_list:
            name = parameter.name
            if parameter.type_ == _NOT_SET and not allow_not_set_type:
                deleted.append(parameter)
                self._parameters.pop(name, None)
                self._descriptors.pop(name, None)
                continue
            if descriptors is not None:
                self._descriptors[name] = descriptors[name]
            elif name not in self._descriptors:
                self._descriptors[name] = {"dynamic_typing": True}
            if _exceeds_int64(parameter.value):
                parameter.to_parameter_msg()  # AssertionError: real rclpy puts every change into a message first
            (new if self.get_parameter_or(name).type_ == _NOT_SET else changed).append(parameter)
            self._parameters[name] = parameter
        return new, changed, deleted

    def _publish_event(
        self,
        publisher: Publisher[Any],
        new: Iterable[Parameter[Any]],
        changed: Iterable[Parameter[Any]],
        deleted: Iterable[Parameter[Any]],
    ) -> None:
        from rcl_interfaces.msg import ParameterEvent

        publisher.publish(
            ParameterEvent(
                stamp=self._clock.now().to_msg(),
                node=self.handle.get_fully_qualified_name(),
                new_parameters=[parameter.to_parameter_msg() for parameter in new],
                changed_parameters=[parameter.to_parameter_msg() for parameter in changed],
                deleted_parameters=[parameter.to_parameter_msg() for parameter in deleted],
            )
        )

    # callbacks

    def add_pre_set_parameters_callback(self, callback: PreSetCallback) -> None:
        """Call `callback(parameters)` before parameters are checked; it returns the list that is to be set."""
        self._pre_set_parameters_callbacks.insert(0, callback)

    def add_on_set_parameters_callback(self, callback: OnSetCallback) -> None:
        """Call `callback(parameters)` before parameters are set; it returns a SetParametersResult. The last added comes first."""
        if not callable(callback):
            raise TypeError("Callback must be callable, got {}", type(callback))
        self._on_set_parameters_callbacks.insert(0, callback)

    def add_post_set_parameters_callback(self, callback: PostSetCallback) -> None:
        """Call `callback(parameters)` after parameters were set."""
        if not callable(callback):
            raise TypeError("Callback must be callable, got {}", type(callback))
        self._post_set_parameters_callbacks.insert(0, callback)

    def remove_pre_set_parameters_callback(self, callback: PreSetCallback) -> None:
        """Call it no more; ValueError if it was not added."""
        self._pre_set_parameters_callbacks.remove(callback)

    def remove_on_set_parameters_callback(self, callback: OnSetCallback) -> None:
        """Call it no more; ValueError if it was not added."""
        self._on_set_parameters_callbacks.remove(callback)

    def remove_post_set_parameters_callback(self, callback: PostSetCallback) -> None:
        """Call it no more; ValueError if it was not added."""
        self._post_set_parameters_callbacks.remove(callback)

    # rules

    def _apply_descriptors(
        self, parameter_list: list[Parameter[Any]], descriptors: dict[str, Any], check_read_only: bool = True
    ) -> SetParametersResult:
        for parameter in parameter_list:
            if parameter.name in descriptors:
                result = self._apply_descriptor(parameter, descriptors[parameter.name], check_read_only)
                if not result.successful:
                    return result
        return accepted()

    def _apply_descriptor(
        self, parameter: Parameter[Any], descriptor: ParameterDescriptor, check_read_only: bool = True
    ) -> SetParametersResult:
        """Say whether a parameter obeys its descriptor; a dynamically typed one takes over the parameter's type."""
        descriptor.name = parameter.name
        if check_read_only and descriptor.read_only:
            return refused(f"Trying to set a read-only parameter: {parameter.name}.")
        refusal = refusal_of_type(parameter, descriptor, parameter.name in self._parameters)
        if refusal is None:
            refusal = refusal_of_range(parameter, descriptor, self.PARAM_REL_TOL)
        return accepted() if refusal is None else refused(refusal)

    def describe_parameter(self, name: str) -> ParameterDescriptor:
        """Return a parameter's descriptor; an empty one or ParameterNotDeclaredException for an undeclared one."""
        if name in self._descriptors:
            descriptor: ParameterDescriptor = self._descriptors[name]
            return descriptor
        if not self._allow_undeclared_parameters:
            raise ParameterNotDeclaredException(name)
        from rcl_interfaces.msg import ParameterDescriptor

        return ParameterDescriptor()

    def describe_parameters(self, names: list[str]) -> list[ParameterDescriptor]:
        """Return the descriptors of some parameters; see `describe_parameter`."""
        return [self.describe_parameter(name) for name in names]

    def set_descriptor(
        self, name: str, descriptor: ParameterDescriptor, alternative_value: ParameterValue | None = None
    ) -> ParameterValue:
        """Give a parameter another descriptor; if its value does not obey it, the parameter takes the alternative value.

        Returns the value then. Raises ParameterNotDeclaredException, ParameterImmutableException and
        InvalidParameterValueException (the alternative does not obey either).
        """
        if name not in self._parameters:
            if not self._allow_undeclared_parameters:
                raise ParameterNotDeclaredException(name)
            return self.get_parameter(name).get_parameter_value()
        if self.describe_parameter(name).read_only:
            raise ParameterImmutableException(name)
        parameter = self.get_parameter(name)
        alternative = parameter
        if alternative_value is not None:
            from rcl_interfaces.msg import Parameter as ParameterMsg

            alternative = Parameter.from_parameter_msg(ParameterMsg(name=name, value=alternative_value))
        for candidate in (parameter, alternative):
            result = self._apply_descriptor(candidate, descriptor, False)
            if result.successful:
                self._parameters[name] = candidate
                self._descriptors[name] = descriptor
                return self.get_parameter(name).get_parameter_value()
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
