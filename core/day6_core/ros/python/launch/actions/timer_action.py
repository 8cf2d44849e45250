"""Visits other actions after a time."""

from __future__ import annotations

import warnings
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from launch.action import Action
from launch.actions.opaque_function import OpaqueFunction
from launch.event_handler import EventHandler
from launch.events.shutdown import Shutdown
from launch.events.timer_event import TimerEvent
from launch.frontend.expose import expose_action
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType, SomeSubstitutionsType_types_tuple
from launch.utilities import ensure_argument_type, is_a_subclass
from launch.utilities.type_utils import normalize_typed_substitution, perform_typed_substitution

if TYPE_CHECKING:
    from launch._loop import Future, Timer
    from launch.frontend.entity import Entity
    from launch.frontend.parser import Parser
    from launch.launch_context import LaunchContext

_HANDLER_REGISTERED = "_launch_timer_handler_registered"


@expose_action("timer")
class TimerAction(Action):
    """Visits `actions` after `period` seconds, unless `cancel` was called or (by default) the launch ends."""

    def __init__(
        self,
        *,
        period: float | SomeSubstitutionsType,
        actions: Iterable[LaunchDescriptionEntity],
        cancel_on_shutdown: bool | SomeSubstitutionsType = True,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        if isinstance(period, int):
            period = float(period)
        ensure_argument_type(period, [*SomeSubstitutionsType_types_tuple, float], "period", "TimerAction")
        ensure_argument_type(actions, Iterable, "actions", "TimerAction")
        if isinstance(period, str):
            period = float(period)
            warnings.warn("TimerAction: the period should be a float or a substitution", stacklevel=2)
        self.__period = normalize_typed_substitution(period, float)
        self.__actions = actions
        self.__cancel_on_shutdown = normalize_typed_substitution(cancel_on_shutdown, bool)
        self.__locals: dict[str, Any] = {}
        self.__canceled = False
        self.__running: list[tuple[Timer, Future]] = []
        self._completed_future: Future | None = None

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[Any, dict[str, Any]]:
        _, keywords = super().parse(entity, parser)
        keywords["period"] = parser.parse_if_substitutions(entity.get_attr("period", data_type=float, can_be_str=True))
        keywords["actions"] = [parser.parse_action(child) for child in entity.children]
        cancel = entity.get_attr("cancel_on_shutdown", optional=True, data_type=bool, can_be_str=True)
        if cancel is not None:
            keywords["cancel_on_shutdown"] = parser.parse_if_substitutions(cancel)
        return cls, keywords

    @property
    def period(self) -> Any:
        return self.__period

    @property
    def actions(self) -> Iterable[LaunchDescriptionEntity]:
        return self.__actions

    def describe(self) -> str:
        return f"{type(self).__name__}(period={self.__period}, actions=<actions>)"

    def describe_conditional_sub_entities(self) -> Sequence[tuple[str, Iterable[LaunchDescriptionEntity]]]:
        return [(f"{self.__period} seconds pass without being canceled", self.__actions)]

    def handle(self, context: LaunchContext) -> Iterable[LaunchDescriptionEntity]:
        """Return the actions; the locals are those from when the timer was started."""
        context.extend_locals(self.__locals)
        return self.__actions

    def cancel(self) -> None:
        """Stop the timer; the actions will not be visited."""
        self.__canceled = True
        for timer, future in self.__running:
            timer.cancel()
            future.set_result(None)
        self.__running = []

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        self._completed_future = context.asyncio_loop.create_future()
        if self.__canceled:
            self._completed_future.set_result(None)
            return None
        if not hasattr(context, _HANDLER_REGISTERED):
            setattr(context, _HANDLER_REGISTERED, True)
            context.register_event_handler(
                EventHandler(
                    matcher=lambda event: is_a_subclass(event, TimerEvent),
                    entities=OpaqueFunction(function=lambda context: context.locals.event.timer_action.handle(context)),
                )
            )
        self.__locals = dict(context.get_locals_as_dict())
        timer = self._start(context, perform_typed_substitution(context, self.__period, float))
        self.__running.append((timer, self._completed_future))  # an action may be visited again before it is done
        if perform_typed_substitution(context, self.__cancel_on_shutdown, bool):
            context.register_event_handler(
                EventHandler(
                    matcher=lambda event: is_a_subclass(event, Shutdown),
                    entities=OpaqueFunction(function=lambda context: self.cancel()),
                )
            )
        return None

    def _start(self, context: LaunchContext, seconds: float) -> Timer:
        timer: Timer = context.asyncio_loop.call_later(seconds, self._fire, context)
        return timer

    def _fire(self, context: LaunchContext) -> None:
        if not self.__running:
            return
        _, future = self.__running.pop(0)
        context._emit_event(TimerEvent(timer_action=self))
        future.set_result(None)

    def get_asyncio_future(self) -> Future | None:
        return self._completed_future
