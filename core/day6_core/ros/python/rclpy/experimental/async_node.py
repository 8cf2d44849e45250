"""AsyncNode: a node whose callbacks run on the event loop of asyncio (ros2/rclpy#1620, Lyrical).

A thread with an executor of its own takes messages, requests and responses, and hands them to the loop; everything that a user
wrote runs there.
"""

from __future__ import annotations

import asyncio
import inspect
import sys
import threading
from collections import deque
from collections.abc import Callable, Coroutine
from contextlib import suppress
from types import TracebackType
from typing import TYPE_CHECKING, Any, Generic

from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.experimental.async_clock import AsyncClock, AsyncTimer, _called
from rclpy.node import Node
from rclpy.qos import HistoryPolicy, QoSProfile, qos_profile_services_default
from rclpy.task import Future
from rclpy.type_support import MsgT, SrvRequestT, SrvResponseT

if TYPE_CHECKING:
    from typing_extensions import Self

    from rclpy._day6.typing_names import ServiceType
    from rclpy.client import Client
    from rclpy.publisher import Publisher
    from rclpy.service import Service
    from rclpy.subscription import Subscription
    from rclpy.subscription_content_filter_options import ContentFilterOptions

_OLDEST = (3, 11)
"""asyncio.TaskGroup."""
_LOOK_SECONDS = 0.1


class AsyncClient(Generic[SrvRequestT, SrvResponseT]):
    """A client whose `call` is awaited."""

    def __init__(self, node: AsyncNode, client: Client[SrvRequestT, SrvResponseT]) -> None:
        self._node = node
        self._client = client

    def __getattr__(self, name: str) -> Any:
        return getattr(self._client, name)

    async def wait_for_service(self, *, check_interval: float = 0.1) -> None:
        """Wait until there is a server, however long that takes (see `asyncio.timeout`); seconds between two looks."""
        while not self._client.service_is_ready():
            await asyncio.sleep(check_interval)

    async def call(self, request: SrvRequestT) -> SrvResponseT:
        """Send a request and return the response.

        Raises:
            RuntimeError: after the node was destroyed.
        """
        if self._node._is_destroyed:
            raise RuntimeError("Calling a destroyed client is forbidden")
        loop = asyncio.get_running_loop()
        answer: asyncio.Future[Any] = loop.create_future()

        def arrived(future: Future[SrvResponseT]) -> None:  # on the executor's thread
            loop.call_soon_threadsafe(lambda: None if answer.done() else answer.set_result(future.result()))

        sent = self._client.call_async(request)
        sent.add_done_callback(arrived)
        self._node._pending.add(answer)
        try:
            response: SrvResponseT = await answer
            return response
        finally:
            self._node._pending.discard(answer)
            self._client.remove_pending_request(sent)


class AsyncNode(Node):
    """A node for `async with AsyncNode('name') as node:` or `await node.run()`.

    Callbacks are functions or coroutine functions. Those of one subscription or service follow each other, unless it was made
    with `concurrent=True`. Actions are not supported, as there.
    """

    def __init__(self, node_name: str, **options: Any) -> None:
        if sys.version_info < _OLDEST:
            raise RuntimeError(f"AsyncNode needs Python {_OLDEST[0]}.{_OLDEST[1]} (asyncio.TaskGroup)")
        self._loop: asyncio.AbstractEventLoop | None = None
        self._group: Any = None
        self._jobs: list[Callable[[], Coroutine[Any, Any, None]]] = []
        """What runs with the node: a coroutine for each subscription, service and timer."""
        self._tasks: list[asyncio.Task[None]] = []
        self._pending: set[asyncio.Future[Any]] = set()
        self._is_destroyed = False
        self._ended = asyncio.Event()
        self._stop = threading.Event()
        self._taking: threading.Thread | None = None
        self._async_clock: AsyncClock | None = None
        super().__init__(node_name, **options)

    def get_clock(self) -> AsyncClock:  # type: ignore[override]
        """Return the node's clock, with `await clock.sleep(seconds)`."""
        if self._async_clock is None:
            self._async_clock = AsyncClock(super().get_clock())
        return self._async_clock

    # -- running -------------------------------------------------------------------------------------------------------

    async def __aenter__(self) -> Self:
        if self._is_destroyed:
            raise RuntimeError("Node has been destroyed and cannot be reentered")
        if self._group is not None:
            raise RuntimeError("Node is already running")
        self._loop = asyncio.get_running_loop()
        self._group = await asyncio.TaskGroup().__aenter__()  # type: ignore[attr-defined, unused-ignore]
        for job in self._jobs:
            self._begin(job)
        self._taker = SingleThreadedExecutor(context=self.context)
        self._taking = threading.Thread(target=self._take, name=f"{self.get_name()}-executor", daemon=True)
        self._taking.start()
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, value: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.destroy_node()
        group, self._group = self._group, None
        if group is not None:
            await group.__aexit__(kind, value, trace)

    async def run(self) -> None:
        """Run until `destroy_node` is called.

        Raises:
            RuntimeError: it runs already, or was destroyed.
        """
        async with self:
            await self._ended.wait()

    def destroy_node(self) -> None:
        """End all callbacks, pending calls and sleeps, and leave the graph."""
        if self._is_destroyed:
            return
        self._is_destroyed = True
        self._stop.set()
        for task in self._tasks:
            task.cancel()
        for answer in list(self._pending):
            answer.cancel()
        if self._async_clock is not None:
            self._async_clock._destroy()
        self._ended.set()
        if self._taking is not None and self._taking is not threading.current_thread():
            self._taking.join()
        super().destroy_node()

    def _take(self) -> None:
        executor = self._taker
        executor.add_node(self)
        with suppress(ExternalShutdownException):
            while not self._stop.is_set():
                executor.spin_once(_LOOK_SECONDS)
        executor.remove_node(self)
        executor.shutdown()
        if self._loop is not None and not self._stop.is_set():  # the context was shut down
            self._loop.call_soon_threadsafe(self._ended.set)

    def _begin(self, job: Callable[[], Coroutine[Any, Any, None]]) -> None:
        self._tasks.append(self._group.create_task(job()))

    def _run_with_node(self, job: Callable[[], Coroutine[Any, Any, None]]) -> None:
        self._jobs.append(job)
        if self._group is not None:
            self._begin(job)

    def _refuse_after_the_end(self, what: str) -> None:
        if self._is_destroyed:
            raise RuntimeError(f"Cannot create {what} on a destroyed node")

    # -- endpoints -----------------------------------------------------------------------------------------------------

    def create_publisher(  # type: ignore[override]
        self, msg_type: type[MsgT], topic: str, qos_profile: QoSProfile | int
    ) -> Publisher[MsgT]:
        """Make a publisher. Raises RuntimeError after the node was destroyed."""
        self._refuse_after_the_end("publisher")
        return super().create_publisher(msg_type, topic, qos_profile)

    def create_subscription(  # type: ignore[override]
        self,
        msg_type: type[MsgT],
        topic: str,
        callback: Callable[..., object],
        qos_profile: QoSProfile | int,
        *,
        raw: bool = False,
        concurrent: bool = False,
        content_filter_options: ContentFilterOptions | None = None,
    ) -> Subscription[MsgT]:
        """Make a subscription: `callback(message)` or `callback(message, info)` runs on the event loop for each message.

        While it runs, so many messages wait as the history of the QoS profile keeps; with `concurrent` none waits. Raises
        RuntimeError after the node was destroyed.
        """
        self._refuse_after_the_end("subscription")
        depth = qos_profile if isinstance(qos_profile, int) else qos_profile.depth
        keeps_all = not isinstance(qos_profile, int) and qos_profile.history == HistoryPolicy.KEEP_ALL
        inbox = _Inbox(None if keeps_all or concurrent else max(1, depth))
        wants_info = len(inspect.signature(callback).parameters) == 2

        def taken(message: Any, info: Any) -> None:
            self._hand_over(inbox, (message, info) if wants_info else (message,))

        self._run_with_node(lambda: self._serve(inbox, callback, concurrent))
        return super().create_subscription(
            msg_type, topic, taken, qos_profile, raw=raw, content_filter_options=content_filter_options
        )

    def create_service(  # type: ignore[override]
        self,
        srv_type: type[ServiceType[SrvRequestT, SrvResponseT]],
        srv_name: str,
        callback: Callable[..., object],
        *,
        qos_profile: QoSProfile = qos_profile_services_default,
        concurrent: bool = False,
    ) -> Service[SrvRequestT, SrvResponseT]:
        """Make a server: `callback(request, response)` runs on the event loop and returns the response.

        Requests are answered one after the other, with `concurrent` at once. Raises RuntimeError after the node was destroyed.
        """
        self._refuse_after_the_end("service")
        inbox = _Inbox(None)

        async def taken(request: Any, response: Any) -> Any:  # on the executor's thread
            answer: Future[Any] = Future(executor=self._taker)
            self._hand_over(inbox, (request, response, answer))
            return await answer

        async def answered(request: Any, response: Any, answer: Future[Any]) -> None:
            answer.set_result(await _called(callback, request, response))

        self._run_with_node(lambda: self._serve(inbox, answered, concurrent))
        group = ReentrantCallbackGroup()  # an answer takes its time, and nothing may wait for it
        return super().create_service(srv_type, srv_name, taken, qos_profile=qos_profile, callback_group=group)

    def create_client(  # type: ignore[override]
        self,
        srv_type: type[ServiceType[SrvRequestT, SrvResponseT]],
        srv_name: str,
        *,
        qos_profile: QoSProfile = qos_profile_services_default,
    ) -> AsyncClient[SrvRequestT, SrvResponseT]:
        """Make a client, whose `call` is awaited. Raises RuntimeError after the node was destroyed."""
        self._refuse_after_the_end("client")
        return AsyncClient(self, super().create_client(srv_type, srv_name, qos_profile=qos_profile))

    def create_timer(  # type: ignore[override]
        self, timer_period_sec: float, callback: Callable[..., object], autostart: bool = True
    ) -> AsyncTimer:
        """Make a timer with a period in seconds of ROS time. Raises RuntimeError after the node was destroyed."""
        self._refuse_after_the_end("timer")
        timer = AsyncTimer(int(float(timer_period_sec) * 1e9), self.get_clock(), callback, autostart)
        self._run_with_node(timer._run)
        return timer

    async def wait_for_node(  # type: ignore[override]
        self, fully_qualified_node_name: str, *, check_interval: float = 0.1
    ) -> None:
        """Wait until a node is in the graph, however long that takes (see `asyncio.timeout`)."""
        wanted = f"/{fully_qualified_node_name.removeprefix('/')}"
        while wanted not in self.get_fully_qualified_node_names():
            await asyncio.sleep(check_interval)

    # -- from the executor's thread to the event loop ------------------------------------------------------------------

    def _hand_over(self, inbox: _Inbox, arguments: tuple[Any, ...]) -> None:
        if self._loop is not None and not self._stop.is_set():
            self._loop.call_soon_threadsafe(inbox.put, arguments)

    async def _serve(self, inbox: _Inbox, callback: Callable[..., Any], concurrent: bool) -> None:
        while True:
            arguments = await inbox.get()
            if concurrent:
                self._tasks = [task for task in self._tasks if not task.done()]
                self._begin(lambda arguments=arguments: _called(callback, *arguments))  # type: ignore[misc]
            else:
                await _called(callback, *arguments)


class _Inbox:
    """What came and waits; the oldest goes when there are more than `limit`."""

    def __init__(self, limit: int | None) -> None:
        self._waiting: deque[tuple[Any, ...]] = deque(maxlen=limit)
        self._came = asyncio.Event()

    def put(self, arguments: tuple[Any, ...]) -> None:
        self._waiting.append(arguments)
        self._came.set()

    async def get(self) -> tuple[Any, ...]:
        while not self._waiting:
            self._came.clear()
            await self._came.wait()
        return self._waiting.popleft()
