"""QoS overrides: parameters that change an endpoint's QoS from outside when it is made."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

from rclpy._day6.incidental import also
from rclpy.duration import Duration
from rclpy.exceptions import ParameterAlreadyDeclaredException
from rclpy.publisher import Publisher
from rclpy.qos import QoSPolicyEnum, QoSPolicyKind, QoSProfile
from rclpy.subscription import Subscription

if TYPE_CHECKING:
    from rclpy._day6.parameter_store import ParameterStore
    from rclpy.node import Node

__all__ = [
    "InvalidQosOverridesError",
    "QoSOverridingOptions",
    "QoSPolicyKind",
    "QoSProfile",
    "QosCallbackResult",  # noqa: F822 made when asked for
    "QosCallbackType",
]

QosCallbackType = Callable[[QoSProfile], Any]


_also = also(__name__, "Parameter QoSDurabilityPolicy QoSHistoryPolicy QoSLivelinessPolicy QoSReliabilityPolicy")


def __getattr__(name: str) -> Any:
    if name == "QosCallbackResult":
        from rcl_interfaces.msg import SetParametersResult

        return SetParametersResult
    return _also(name)


class InvalidQosOverridesError(Exception):
    """The callback rejected the QoS that results from the parameters."""


class QoSOverridingOptions:
    """The policies that may be overridden, a callback that validates the result, and an id to tell several endpoints apart."""

    def __init__(
        self,
        policy_kinds: Iterable[QoSPolicyKind],
        *,
        callback: QosCallbackType | None = None,
        entity_id: str | None = None,
    ) -> None:
        self._policy_kinds = policy_kinds
        self._callback = callback
        self._entity_id = entity_id

    @property
    def policy_kinds(self) -> Iterable[QoSPolicyKind]:
        """The policies that may be changed."""
        return self._policy_kinds

    @property
    def callback(self) -> QosCallbackType | None:
        """The function that validates the resulting profile."""
        return self._callback

    @property
    def entity_id(self) -> str | None:
        """The id of the endpoint."""
        return self._entity_id

    @classmethod
    def with_default_policies(
        cls, *, callback: QosCallbackType | None = None, entity_id: str | None = None
    ) -> QoSOverridingOptions:
        """Allow history, depth and reliability."""
        kinds = (QoSPolicyKind.HISTORY, QoSPolicyKind.DEPTH, QoSPolicyKind.RELIABILITY)
        return cls(kinds, callback=callback, entity_id=entity_id)


def _declare_qos_parameters(
    entity_type: type[Any], node: Node, topic_name: str, qos: QoSProfile, options: QoSOverridingOptions
) -> None:
    """In real rclpy this is what tests of programs call."""
    _declare_qos_in(entity_type, node._rclpy_parameters, topic_name, qos, options)


def _declare_qos_in(
    entity_type: type[Any], parameters: ParameterStore, topic_name: str, qos: QoSProfile, options: QoSOverridingOptions
) -> None:
    """Declare `qos_overrides.<topic>.<publisher|subscription>[_id].<policy>` and set their values in `qos`."""
    from rcl_interfaces.msg import ParameterDescriptor

    if not issubclass(entity_type, (Publisher, Subscription)):
        raise TypeError("Argument `entity_type` should be a subclass of Publisher or Subscription")
    is_publisher = issubclass(entity_type, Publisher)
    word = "publisher" if is_publisher else "subscription"
    suffix = "" if options.entity_id is None else f"_{options.entity_id}"
    description = f"{{}} for {word} `{topic_name}` with id `{options.entity_id}`"
    for policy in options.policy_kinds:
        if policy == QoSPolicyKind.LIFESPAN and not is_publisher:
            continue
        policy_name = policy.name.lower()
        name = f"qos_overrides.{topic_name}.{word}{suffix}.{policy_name}"
        descriptor = ParameterDescriptor(description=description.format(policy_name), read_only=True)
        try:
            (parameter,) = parameters.declare("", [(name, _get_qos_policy_parameter(qos, policy), descriptor)])
        except ParameterAlreadyDeclaredException:
            parameter = parameters.get(name)
        _override_qos_policy_with_param(qos, policy, parameter)
    if options.callback is not None:
        result = options.callback(qos)
        if not result.successful:
            raise InvalidQosOverridesError(
                f"{description.format('Provided QoS overrides')}, are not valid: {result.reason}"
            )


def _get_qos_policy_parameter(qos: QoSProfile, policy: QoSPolicyKind) -> str | int | bool:
    value: Any = getattr(qos, policy.name.lower())
    if isinstance(value, QoSPolicyEnum):
        if value.short_key == "unknown":
            raise ValueError("User provided QoS profile is invalid")
        return value.short_key
    if isinstance(value, Duration):
        return value.nanoseconds
    plain: int | bool = value
    return plain


def _override_qos_policy_with_param(qos: QoSProfile, policy: QoSPolicyKind, param: Any) -> None:
    value = param.value
    policy_name = policy.name.lower()
    present = getattr(qos, policy_name)
    if isinstance(present, QoSPolicyEnum):
        try:
            value = type(present)[value.upper()]
        except KeyError:
            raise RuntimeError(f"Unexpected QoS override for policy `{policy_name}`: `{value}`") from None
    elif isinstance(present, Duration):
        value = Duration(nanoseconds=value)
    setattr(qos, policy_name, value)
