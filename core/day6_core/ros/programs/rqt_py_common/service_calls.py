"""Calls of services that nobody waits for: what the response says goes on in a callback, and one can give up."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rclpy.client import Client
    from rclpy.task import Future


class ServiceCalls:
    """The calls of one plugin to one node. Callbacks run on the thread that spins the plugin's node.

    `now` is world time (ns), `changed` is called after every response, `failed` gets the text of an exception.
    """

    def __init__(self, now: Callable[[], int], changed: Callable[[], object], failed: Callable[[str], object]) -> None:
        self._now, self._changed, self._failed = now, changed, failed
        self._pending: dict[Future[Any], int] = {}
        """Those without a response, with the time (ns) at which they were sent."""

    def send(self, client: Client[Any, Any], request: Any, then: Callable[[Any], object]) -> None:
        """Send a request; `then(response)` is called once."""
        future = client.call_async(request)
        self._pending[future] = self._now()

        def answered(future: Future[Any]) -> None:
            if self._pending.pop(future, None) is None:
                return  # given up
            error = future.exception()
            if error is not None:
                self._failed(str(error))
            else:
                then(future.result())
            self._changed()

        future.add_done_callback(answered)

    def give_up(self) -> None:
        """Wait for no response any more."""
        pending, self._pending = self._pending, {}
        for future in pending:
            future.cancel()

    @property
    def waited(self) -> int | None:
        """The whole seconds since the oldest request without a response was sent; None if there is none."""
        oldest = min(self._pending.values(), default=None)
        return None if oldest is None else (self._now() - oldest) // 1_000_000_000
