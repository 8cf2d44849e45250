"""The base of the handlers for events of one action."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

from launch.event import Event
from launch.event_handler import BaseEventHandler
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_entities_type import SomeEntitiesType

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class OnActionEventBase(BaseEventHandler):
    """Handles events of one class, of one action (or of the actions for which a function is true; None: of all actions).

    `on_event` is the entities to visit then, or a function `(event, context)` that returns them.
    """

    def __init__(
        self,
        *,
        action_matcher: Any,
        on_event: SomeEntitiesType | Callable[..., SomeEntitiesType | None],
        target_event_cls: type[Any],
        target_action_cls: type,
        **kwargs: Any,
    ) -> None:
        if not issubclass(target_event_cls, Event):
            raise TypeError("'target_event_cls' must be a subclass of 'Event'")
        if (
            action_matcher is not None
            and not isinstance(action_matcher, target_action_cls)
            and not callable(action_matcher)
        ):
            raise TypeError(f"action_matcher must be an '{target_action_cls.__name__}' instance or a callable")
        self.__target_action_cls = target_action_cls
        self.__target_event_cls = target_event_cls
        self.__action_matcher = action_matcher
        super().__init__(matcher=self.__matches, **kwargs)
        self.__actions: list[LaunchDescriptionEntity] = []
        self.__function: Callable[..., SomeEntitiesType | None] | None = None
        if callable(on_event):
            self.__function = on_event
        else:
            self.__actions = list(on_event) if isinstance(on_event, Iterable) else [on_event]
            for each in self.__actions:
                if not isinstance(each, LaunchDescriptionEntity) and (isinstance(on_event, Iterable)):
                    raise TypeError(
                        "expected all items in 'on_event' iterable to be of type 'LaunchDescriptionEntity' "
                        f"but got '{type(each)}'"
                    )

    def __matches(self, event: Any) -> bool:
        if not isinstance(event, self.__target_event_cls):
            return False
        wanted, action = self.__action_matcher, getattr(event, "action", None)
        if callable(wanted):
            return bool(wanted(action))
        return wanted is None or action is wanted

    def handle(self, event: Event, context: LaunchContext) -> SomeEntitiesType | None:
        super().handle(event, context)
        return self.__actions if self.__function is None else self.__function(event, context)

    def describe(self) -> tuple[str, list[Any]]:
        text, actions = super().describe()
        return text, [*actions, *self.__actions]

    @property
    def handler_description(self) -> str:
        return "<actions>" if self.__function is None else str(self.__function)

    @property
    def matcher_description(self) -> str:
        text = f"event == {self.__target_event_cls.__name__}"
        return (
            text if self.__action_matcher is None else f"{text} and {self.__target_action_cls.__name__}(event.action)"
        )
