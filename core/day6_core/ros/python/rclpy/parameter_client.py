"""Parameters of other nodes."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from rclpy._day6.incidental import also
from rclpy.parameter import Parameter, parameter_dict_from_yaml_file
from rclpy.qos import QoSProfile, qos_profile_parameter_events, qos_profile_services_default
from rclpy.task import Future

if TYPE_CHECKING:
    from rcl_interfaces import srv
    from rcl_interfaces.msg import Parameter as ParameterMsg
    from rcl_interfaces.msg import ParameterEvent

    from rclpy._day6.typing_names import ServiceType
    from rclpy.callback_groups import CallbackGroup
    from rclpy.client import Client
    from rclpy.event_handler import SubscriptionEventCallbacks
    from rclpy.node import Node
    from rclpy.qos_overriding_options import QoSOverridingOptions
    from rclpy.subscription import MessageCallback, Subscription
    from rclpy.type_support import SrvRequestT, SrvResponseT

    _Given = Sequence[Parameter[Any] | ParameterMsg]

__getattr__ = also(
    __name__,
    "CallbackGroup Client DescribeParameters GetParameterTypes GetParameters ListParameters MessageInfo "
    "Node ParameterEvent ParameterMsg QoSOverridingOptions SetParameters SetParametersAtomically "
    "Subscription SubscriptionEventCallbacks",
)


class AsyncParameterClient:
    """A client of a node's parameter services. Methods that call one return the future of its response."""

    def __init__(
        self,
        node: Node,
        remote_node_name: str,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> None:
        from rcl_interfaces import srv

        self.remote_node_name = remote_node_name
        self.node = node

        def client(
            srv_type: type[ServiceType[SrvRequestT, SrvResponseT]], name: str
        ) -> Client[SrvRequestT, SrvResponseT]:
            return node.create_client(
                srv_type, f"{remote_node_name}/{name}", qos_profile=qos_profile, callback_group=callback_group
            )

        self._get_parameter_client = client(srv.GetParameters, "get_parameters")
        self._list_parameter_client = client(srv.ListParameters, "list_parameters")
        self._set_parameter_client = client(srv.SetParameters, "set_parameters")
        self._get_parameter_types_client = client(srv.GetParameterTypes, "get_parameter_types")
        self._describe_parameters_client = client(srv.DescribeParameters, "describe_parameters")
        self._set_parameters_atomically_client = client(srv.SetParametersAtomically, "set_parameters_atomically")

    def _clients(self) -> tuple[Client[Any, Any], ...]:
        return (
            self._list_parameter_client,
            self._set_parameter_client,
            self._get_parameter_client,
            self._get_parameter_types_client,
            self._describe_parameters_client,
            self._set_parameters_atomically_client,
        )

    def services_are_ready(self) -> bool:
        """Return whether all six services exist."""
        return all(client.service_is_ready() for client in self._clients())

    def wait_for_services(self, timeout_sec: float | None = None) -> bool:
        """Block until all six services exist, at most `timeout_sec` seconds (None: no limit); returns whether they do."""
        end = None if timeout_sec is None else time.monotonic() + timeout_sec
        for client in self._clients():
            client.wait_for_service(None if end is None else max(0.0, end - time.monotonic()))
        return self.services_are_ready()

    @staticmethod
    def _call(
        client: Client[SrvRequestT, SrvResponseT],
        callback: Callable[[Future[SrvResponseT]], object] | None,
        request: SrvRequestT,
    ) -> Future[SrvResponseT]:
        future = client.call_async(request)
        if callback is not None:
            future.add_done_callback(callback)
        return future

    def list_parameters(
        self,
        prefixes: list[str] | None = None,
        depth: int | None = None,
        callback: Callable[[Future[srv.ListParameters.Response]], object] | None = None,
    ) -> Future[srv.ListParameters.Response]:
        """Request the names below some prefixes down to a depth."""
        from rcl_interfaces.srv import ListParameters

        return self._call(
            self._list_parameter_client, callback, ListParameters.Request(prefixes=prefixes or [], depth=depth or 0)
        )

    def get_parameters(
        self, names: list[str], callback: Callable[[Future[srv.GetParameters.Response]], object] | None = None
    ) -> Future[srv.GetParameters.Response]:
        """Request values."""
        from rcl_interfaces.srv import GetParameters

        return self._call(self._get_parameter_client, callback, GetParameters.Request(names=names))

    def set_parameters(
        self, parameters: _Given, callback: Callable[[Future[srv.SetParameters.Response]], object] | None = None
    ) -> Future[srv.SetParameters.Response]:
        """Set parameters, given as `Parameter` or as messages."""
        from rcl_interfaces.srv import SetParameters

        return self._call(self._set_parameter_client, callback, SetParameters.Request(parameters=_messages(parameters)))

    def describe_parameters(
        self, names: list[str], callback: Callable[[Future[srv.DescribeParameters.Response]], object] | None = None
    ) -> Future[srv.DescribeParameters.Response]:
        """Request descriptors."""
        from rcl_interfaces.srv import DescribeParameters

        return self._call(self._describe_parameters_client, callback, DescribeParameters.Request(names=names))

    def get_parameter_types(
        self, names: list[str], callback: Callable[[Future[srv.GetParameterTypes.Response]], object] | None = None
    ) -> Future[srv.GetParameterTypes.Response]:
        """Request types."""
        from rcl_interfaces.srv import GetParameterTypes

        return self._call(self._get_parameter_types_client, callback, GetParameterTypes.Request(names=names))

    def set_parameters_atomically(
        self,
        parameters: _Given,
        callback: Callable[[Future[srv.SetParametersAtomically.Response]], object] | None = None,
    ) -> Future[srv.SetParametersAtomically.Response]:
        """Set all parameters or none."""
        from rcl_interfaces.srv import SetParametersAtomically

        return self._call(
            self._set_parameters_atomically_client,
            callback,
            SetParametersAtomically.Request(parameters=_messages(parameters)),
        )

    def delete_parameters(
        self, names: list[str], callback: Callable[[Future[srv.SetParameters.Response]], object] | None = None
    ) -> Future[srv.SetParameters.Response]:
        """Undeclare parameters (a node allows that only for dynamically typed ones)."""
        return self.set_parameters([Parameter(name) for name in names], callback)

    def load_parameter_file(
        self,
        parameter_file: str,
        use_wildcard: bool = False,
        callback: Callable[[Future[srv.SetParameters.Response]], object] | None = None,
    ) -> Future[srv.SetParameters.Response]:
        """Set the node's parameters from a parameter file; raises as `parameter_dict_from_yaml_file`."""
        return self.set_parameters(self._from_file(parameter_file, use_wildcard), callback)

    def load_parameter_file_atomically(
        self,
        parameter_file: str,
        use_wildcard: bool = False,
        callback: Callable[[Future[srv.SetParametersAtomically.Response]], object] | None = None,
    ) -> Future[srv.SetParametersAtomically.Response]:
        """Set the node's parameters from a parameter file, all or none; raises as `parameter_dict_from_yaml_file`."""
        return self.set_parameters_atomically(self._from_file(parameter_file, use_wildcard), callback)

    def _from_file(self, parameter_file: str, use_wildcard: bool) -> _Given:
        found = parameter_dict_from_yaml_file(parameter_file, use_wildcard, target_nodes=[self.remote_node_name])
        return list(found.values())

    def on_parameter_event(
        self,
        callback: MessageCallback[ParameterEvent],
        qos_profile: QoSProfile = qos_profile_parameter_events,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: SubscriptionEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        raw: bool = False,
    ) -> Subscription[ParameterEvent]:
        """Call `callback(event)` for the parameter events of all nodes; returns the subscription."""
        from rcl_interfaces.msg import ParameterEvent

        return self.node.create_subscription(
            ParameterEvent,
            "/parameter_events",
            callback,
            qos_profile,
            callback_group=callback_group,
            event_callbacks=event_callbacks,
            qos_overriding_options=qos_overriding_options,
            raw=raw,
        )


def _messages(parameters: _Given) -> list[ParameterMsg]:
    return [each.to_parameter_msg() if isinstance(each, Parameter) else each for each in parameters]
