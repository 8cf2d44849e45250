"""Service clients."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from rclpy._day6.entity import CLIENT, NOTHING
from rclpy._day6.handles import INVALID_NODE
from rclpy._day6.incidental import also
from rclpy._day6.node_endpoint import ServiceEndpoint
from rclpy._day6.time_base import wait_interruptibly
from rclpy._day6.withdrawn import withdraw
from rclpy._rclpy_pybind11 import RCLError
from rclpy.qos import QoSProfile
from rclpy.service_introspection import ServiceIntrospectionState as ServiceIntrospectionState
from rclpy.task import Future
from rclpy.type_support import SrvRequestT, SrvResponseT

if TYPE_CHECKING:
    from rclpy._day6.handles import EndpointHandle
    from rclpy._day6.typing_names import ServiceType
    from rclpy.callback_groups import CallbackGroup
    from rclpy.context import Context

__getattr__ = also(__name__, "Srv CallbackGroup Clock Context")


SrvType = TypeVar("SrvType")
SrvTypeRequest = TypeVar("SrvTypeRequest")
SrvTypeResponse = TypeVar("SrvTypeResponse")


class Client(ServiceEndpoint, Generic[SrvRequestT, SrvResponseT]):
    """Sends requests to a service; made by `Node.create_client`."""

    _kind = CLIENT

    def __init__(
        self,
        context: Context,
        client_impl: EndpointHandle,
        srv_type: type[ServiceType[SrvRequestT, SrvResponseT]],
        srv_name: str,
        qos_profile: QoSProfile,
        callback_group: CallbackGroup,
    ) -> None:
        self.context = context
        self._handle = client_impl
        self._endpoint = client_impl._endpoint
        self.srv_type = srv_type
        self.srv_name = srv_name
        self.qos_profile = qos_profile
        self._pending_requests: dict[int, Future[SrvResponseT]] = {}
        self.callback_group = callback_group
        self._executor_event = False
        self._lock = threading.Lock()
        self._endpoint.on_ready = self._notify

    def _pending(self) -> bool:
        return bool(self._endpoint.queue)

    def _process(self) -> Any:
        self._queued = False
        taken = self._endpoint.take()
        if taken is None or self._handle._destroyed:
            return NOTHING
        if self._endpoint.queue:
            self._notify()
        response, number = taken
        if self._introspection is not None:
            self._introspection.response_received(response, number)
        with self._lock:
            future = self._pending_requests.get(number)
        if future is not None:
            scope = self._scope
            future._set_executor(None if scope is None else scope.executor)
            future.set_result(response)
        return None

    def call(self, request: SrvRequestT, timeout_sec: float | None = None) -> SrvResponseT | None:
        """Send a request and block until the response arrives; another thread has to spin the node.

        Raises:
            TypeError: for anything that isn't a request of the service's type.
            TimeoutError: after `timeout_sec` seconds.
        """
        if not isinstance(request, self.srv_type.Request):
            raise TypeError
        answered = threading.Event()
        future = self.call_async(request)
        future._watch(answered.set)
        if not wait_interruptibly(answered, timeout_sec):
            self.remove_pending_request(future)
            raise TimeoutError
        return future.result()

    def call_async(self, request: SrvRequestT) -> Future[SrvResponseT]:
        """Send a request; return the future of the response.

        Raises:
            TypeError: for anything that isn't a request of the service.
        """
        if not isinstance(request, self.srv_type.Request):
            raise TypeError
        self._handle.check()
        future: Future[SrvResponseT] = Future()
        with self._lock:
            number = self._endpoint.send_request(request)
            self._pending_requests[number] = future
        future.add_done_callback(self.remove_pending_request)
        if self._introspection is not None:
            self._introspection.request_sent(request, number)
        return future

    def get_pending_request(self, sequence_number: int) -> Future[SrvResponseT]:
        """Return the future of a request by its sequence number.

        Raises:
            KeyError: if it is not pending.
        """
        with self._lock:
            return self._pending_requests[sequence_number]

    def remove_pending_request(self, future: Future[SrvResponseT]) -> None:
        """Stop waiting for the response of that future."""
        with self._lock:
            for number, pending in self._pending_requests.items():
                if pending is future:
                    del self._pending_requests[number]
                    return

    def service_is_ready(self) -> bool:
        """Return whether the service has a server."""
        self._handle.check()
        if not self.context._valid:
            raise RCLError(f"failed to check service availability: {INVALID_NODE}")
        ready: bool = self._endpoint.service_is_ready()
        return ready

    def wait_for_service(self, timeout_sec: float | None = None) -> bool:
        """Block until the service has a server, at most `timeout_sec` seconds (None: no limit); returns whether it does."""
        if not self.service_is_ready():
            self.context._wait_for_graph(self._endpoint.service_is_ready, timeout_sec)
        return self.service_is_ready()


withdraw(__name__)
