"""Names that real rclpy's modules have only because they import them, but that programs import from there.

`from rclpy.node import ReentrantCallbackGroup` works in real ROS, so it works here; the defining modules are loaded only when
a name is used.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import Any

_SOURCES = {
    "action_msgs.msg": "GoalStatusArray",
    "rcl_interfaces.msg": "FloatingPointRange IntegerRange ListParametersResult LoggerLevel ParameterDescriptor ParameterEvent "
    "SetLoggerLevelsResult SetParametersResult",
    "rcl_interfaces.srv": "DescribeParameters GetLoggerLevels GetParameterTypes GetParameters ListParameters SetLoggerLevels "
    "SetParameters SetParametersAtomically",
    "rclpy._day6.typing_names": "Action CommonMsgSrvMetaClass CreateLifecyclePublisherArgs EventMessage FeedbackMessage "
    "GetResultService GetResultServiceRequest GetResultServiceResponse LifecycleNodeArgs LoggingArgs LoggingFilterArgs "
    "LoggingFilterParams Msg MsgMetaClass OnceContext PyCapsule RcutilsLoggerContext SendGoalKWargs SendGoalService "
    "SendGoalServiceRequest SendGoalServiceResponse SkipFirstContext Srv SupportedFilters ThrottleContext "
    "TimeJumpDictionary",
    "rclpy.callback_groups": "CallbackGroup MutuallyExclusiveCallbackGroup ReentrantCallbackGroup",
    "rclpy.client": "Client",
    "rclpy.clock": "Clock",
    "rclpy.clock_type": "ClockType",
    "rclpy.constants": "S_TO_NS",
    "rclpy.context": "Context",
    "rclpy.event_handler": "EventHandler PublisherEventCallbacks SubscriptionEventCallbacks",
    "rclpy.exceptions": "InvalidHandle InvalidNamespaceException InvalidNodeNameException InvalidParameterTypeException "
    "InvalidParameterValueException InvalidServiceNameException InvalidTopicNameException "
    "ParameterAlreadyDeclaredException ParameterImmutableException ParameterNotDeclaredException "
    "ParameterUninitializedException TimerCancelledError",
    "rclpy.executors": "Executor",
    "rclpy.expand_topic_name": "expand_topic_name",
    "rclpy.guard_condition": "GuardCondition",
    "rclpy.impl.rcutils_logger": "RcutilsLogger",
    "rclpy.logging": "get_logger",
    "rclpy.logging_service": "LoggingService",
    "rclpy.node": "Node",
    "rclpy.parameter": "AllowableParameterValueT PARAMETER_SEPARATOR_STRING Parameter ParameterMsg ParameterType ParameterValue",
    "rclpy.qos": "QoSDurabilityPolicy QoSHistoryPolicy QoSLivelinessPolicy QoSProfile QoSReliabilityPolicy "
    "qos_profile_parameter_events qos_profile_services_default",
    "rclpy.qos_overriding_options": "QoSOverridingOptions",
    "rclpy.service": "Service",
    "rclpy.service_introspection": "ServiceIntrospectionState",
    "rclpy.signals": "SignalHandlerGuardCondition",
    "rclpy.subscription": "MessageInfo Subscription",
    "rclpy.subscription_content_filter_options": "ContentFilterOptions",
    "rclpy.task": "Task",
    "rclpy.timer": "Rate Timer TimerInfo",
    "rclpy.topic_endpoint_info": "TopicEndpointInfo",
    "rclpy.type_hash": "TypeHashDictionary",
    "rclpy.type_support": "check_is_valid_msg_type check_is_valid_srv_type",
    "rclpy.utilities": "get_default_context timeout_sec_to_nsec",
    "rclpy.validate_full_topic_name": "validate_full_topic_name",
    "rclpy.validate_namespace": "validate_namespace",
    "rclpy.validate_node_name": "validate_node_name",
    "rclpy.validate_parameter_name": "validate_parameter_name",
    "rclpy.validate_topic_name": "TOPIC_SEPARATOR_STRING validate_topic_name",
    "rclpy.waitable": "NumberOfEntities Waitable",
    "type_description_interfaces.srv": "GetTypeDescription",
    "unique_identifier_msgs.msg": "UUID",
}
_SOURCE = {name: module for module, names in _SOURCES.items() for name in names.split()}


def also(module: str, names: str = "") -> Callable[[str], Any]:
    """Return a module's `__getattr__` that finds these names (separated by blanks) where they are defined.

    It also finds the names of Python's standard library that the module has in real rclpy.
    """
    known = frozenset(names.split())

    def find(name: str) -> Any:
        if name in known:
            return getattr(import_module(_SOURCE[name]), name)
        if name.startswith("__"):
            raise AttributeError(f"module {module!r} has no attribute {name!r}")
        from rclpy._day6.standard_names import standard_name

        return standard_name(module, name)

    return find
