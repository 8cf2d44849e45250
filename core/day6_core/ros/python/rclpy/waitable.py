"""Waitables: entities of an executor other than plain subscriptions, services and timers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Generic, TypeVar

from rclpy._day6.entity import NOTHING, WAITABLE, Entity
from rclpy._day6.incidental import also

if TYPE_CHECKING:
    from rclpy._day6.entity import Scope
    from rclpy._day6.wait_set import WaitSet
    from rclpy.callback_groups import CallbackGroup
    from rclpy.task import Future

__getattr__ = also(__name__)

T = TypeVar("T")


class NumberOfEntities:
    """The numbers of a waitable's entities of each kind."""

    __slots__ = ("num_clients", "num_events", "num_guard_conditions", "num_services", "num_subscriptions", "num_timers")
    _ORDER = (
        "num_subscriptions",
        "num_guard_conditions",
        "num_timers",
        "num_clients",
        "num_services",
        "num_events",
    )

    def __init__(
        self,
        num_subs: int = 0,
        num_gcs: int = 0,
        num_timers: int = 0,
        num_clients: int = 0,
        num_services: int = 0,
        num_events: int = 0,
    ) -> None:
        self.num_subscriptions = num_subs
        self.num_guard_conditions = num_gcs
        self.num_timers = num_timers
        self.num_clients = num_clients
        self.num_services = num_services
        self.num_events = num_events

    def __add__(self, other: NumberOfEntities) -> NumberOfEntities:
        return self.__class__(*(getattr(self, name) + getattr(other, name) for name in self._ORDER))

    def __iadd__(self, other: NumberOfEntities) -> NumberOfEntities:
        for name in self._ORDER:
            setattr(self, name, getattr(self, name) + getattr(other, name))
        return self

    def __repr__(self) -> str:
        numbers = ", ".join(str(getattr(self, name)) for name in self._ORDER)
        return f"<{self.__class__.__name__}({numbers})>"


class Waitable(Entity, Generic[T]):
    """Base of entities other than subscriptions, services, clients, timers and guard conditions.

    A program's derived class implements `get_num_entities`, `add_to_wait_set`, `is_ready`, `take_data` and `execute` with the
    handles of entities, as in real rclpy; `rclpy._day6.wait_set` replaces rcl's wait set.
    """

    _kind = WAITABLE

    def __init__(self, callback_group: CallbackGroup) -> None:
        self.callback_group: CallbackGroup = callback_group
        callback_group.add_entity(self)
        self._executor_event = False
        self._wait_set: WaitSet | None = None
        self._futures: list[Future[Any]] = []

    def _enter(self, scope: Scope) -> None:
        super()._enter(scope)
        if type(self)._process is Waitable._process and self._wait_set is None:
            from rclpy._day6.wait_set import WaitSet

            self._wait_set = WaitSet._of_waitable(self._notify, scope)
            self.add_to_wait_set(self._wait_set)
            self._notify()

    def _leave(self) -> None:
        super()._leave()
        if self._wait_set is not None:
            self._wait_set._leave()
            self._wait_set = None

    def _process(self) -> Any:
        self._queued = False
        wait_set = self._wait_set
        if wait_set is None or not self.is_ready(wait_set):
            return NOTHING
        wait_set.reset()
        taken = self.take_data()
        wait_set.rearm()
        return self.execute(taken)

    def __enter__(self) -> None:
        raise NotImplementedError("Must be implemented by subclass")

    def __exit__(self, exc_type: object, exc_val: object, exc_tb: object) -> None:
        raise NotImplementedError("Must be implemented by subclass")

    def add_future(self, future: Future[Any]) -> None:
        """Add a future that belongs to the waitable."""
        self._futures.append(future)

    def remove_future(self, future: Future[Any]) -> None:
        """Remove a future."""
        self._futures.remove(future)

    def is_ready(self, wait_set: WaitSet) -> bool:
        """Return whether there is data to take."""
        raise NotImplementedError("Must be implemented by subclass")

    def take_data(self) -> T:
        """Take the data that makes the waitable ready."""
        raise NotImplementedError("Must be implemented by subclass")

    async def execute(self, taken_data: T) -> None:
        """Process the taken data."""
        raise NotImplementedError("Must be implemented by subclass")

    def get_num_entities(self) -> NumberOfEntities:
        """Return how many entities `add_to_wait_set` adds."""
        raise NotImplementedError("Must be implemented by subclass")

    def add_to_wait_set(self, wait_set: WaitSet) -> None:
        """Add entities to a wait set."""
        raise NotImplementedError("Must be implemented by subclass")
