"""Service servers."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from day6_core.graph import RequestId
from rclpy._day6.callables import is_coroutine_function
from rclpy._day6.entity import NOTHING, SERVICE
from rclpy._day6.incidental import also
from rclpy._day6.node_endpoint import ServiceEndpoint
from rclpy._day6.withdrawn import withdraw
from rclpy.qos import QoSProfile
from rclpy.service_introspection import ServiceIntrospectionState as ServiceIntrospectionState
from rclpy.type_support import SrvRequestT, SrvResponseT

if TYPE_CHECKING:
    from rclpy._day6.handles import EndpointHandle
    from rclpy._day6.typing_names import ServiceType
    from rclpy.callback_groups import CallbackGroup

    ServiceCallback = Callable[[SrvRequestT, SrvResponseT], SrvResponseT | Awaitable[SrvResponseT]]

__getattr__ = also(__name__, "Srv CallbackGroup Clock")


SrvType = TypeVar("SrvType")
SrvTypeRequest = TypeVar("SrvTypeRequest")
SrvTypeResponse = TypeVar("SrvTypeResponse")


class Service(ServiceEndpoint, Generic[SrvRequestT, SrvResponseT]):
    """Responds to requests; made by `Node.create_service`."""

    _kind = SERVICE

    def __init__(
        self,
        service_impl: EndpointHandle,
        srv_type: type[ServiceType[SrvRequestT, SrvResponseT]] | str,
        srv_name: str,
        callback: ServiceCallback[SrvRequestT, SrvResponseT],
        callback_group: CallbackGroup,
        qos_profile: QoSProfile,
    ) -> None:
        self._handle = service_impl
        self._endpoint = service_impl._endpoint
        self._srv_type: type[ServiceType[SrvRequestT, SrvResponseT]] | str = srv_type
        self.srv_name = srv_name
        self.callback = callback
        self.callback_group = callback_group
        self._executor_event = False
        self.qos_profile = qos_profile
        self._endpoint.on_ready = self._notify

    @property
    def srv_type(self) -> type[ServiceType[SrvRequestT, SrvResponseT]]:
        """The service's class."""
        srv_type = self._srv_type
        if isinstance(srv_type, str):
            # The class of one of the node's own services is made on first use.
            from day6_core.interfaces import get_service

            srv_type = self._srv_type = get_service(srv_type)
        return srv_type

    @srv_type.setter
    def srv_type(self, value: type[ServiceType[SrvRequestT, SrvResponseT]]) -> None:
        self._srv_type = value

    def _pending(self) -> bool:
        return bool(self._endpoint.queue)

    def _process(self) -> Any:
        self._queued = False
        taken = self._endpoint.take()
        if taken is None or self._handle._destroyed:
            return NOTHING
        if self._endpoint.queue:
            self._notify()
        request, request_id = taken
        if self._introspection is not None:
            self._introspection.request_received(request, request_id)
        result: Any = self.callback(request, self.srv_type.Response())
        if is_coroutine_function(self.callback):
            return self._send_response_later(result, request_id)
        self.send_response(result, request_id)
        return None

    async def _send_response_later(self, coroutine: Any, request_id: RequestId) -> None:
        self.send_response(await coroutine, request_id)

    def send_response(self, response: SrvResponseT, header: RequestId) -> None:
        """Send the response to the request with that header.

        Raises:
            TypeError: for anything that isn't a response of the service.
        """
        if not isinstance(response, self.srv_type.Response) or not isinstance(header, RequestId):
            raise TypeError
        self._handle.check()
        if self._introspection is not None:
            self._introspection.response_sent(response, header)
        self._endpoint.send_response(header, response)


withdraw(__name__)
