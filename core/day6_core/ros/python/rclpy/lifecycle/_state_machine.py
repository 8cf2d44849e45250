"""The states of a lifecycle node and the transitions between them (rcl_lifecycle/default_state_machine.c)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from rclpy._day6.logging_settings import LoggingSettings
from rclpy._rclpy_pybind11 import RCLError

STATES = {
    0: "unknown",
    1: "unconfigured",
    2: "inactive",
    3: "active",
    4: "finalized",
    10: "configuring",
    11: "cleaningup",
    12: "shuttingdown",
    13: "activating",
    14: "deactivating",
    15: "errorprocessing",
}


class Transition(NamedTuple):
    """One transition: its id and label, its start and goal states."""

    id: int
    label: str
    start: int
    goal: int

    def described(self) -> tuple[int, str, int, str, int, str]:
        """Return the transition with the labels of its states."""
        return self.id, self.label, self.start, STATES[self.start], self.goal, STATES[self.goal]


def _outcomes(first: int, start: int, goals: tuple[int, int, int]) -> list[Transition]:
    labels = ("transition_success", "transition_failure", "transition_error")
    return [Transition(first + index, label, start, goals[index]) for index, label in enumerate(labels)]


TRANSITIONS = (
    Transition(1, "configure", 1, 10),
    *_outcomes(10, 10, (2, 1, 15)),
    Transition(2, "cleanup", 2, 11),
    *_outcomes(20, 11, (1, 2, 15)),
    Transition(3, "activate", 2, 13),
    *_outcomes(30, 13, (3, 2, 15)),
    Transition(4, "deactivate", 3, 14),
    *_outcomes(40, 14, (2, 3, 15)),
    Transition(5, "shutdown", 1, 12),
    Transition(6, "shutdown", 2, 12),
    Transition(7, "shutdown", 3, 12),
    *_outcomes(50, 12, (4, 4, 15)),
    *_outcomes(60, 15, (1, 4, 4)),
)


class StateMachine:
    """The state of one node; `on_transition(transition)` is called for every transition made."""

    def __init__(self, settings: LoggingSettings, on_transition: Callable[[Transition], None]) -> None:
        self.initialized = True
        self._state = 1
        self._settings = settings
        self._on_transition = on_transition
        self.service_change_state: Any = None
        self.service_get_state: Any = None
        self.service_get_available_states: Any = None
        self.service_get_available_transitions: Any = None
        self.service_get_transition_graph: Any = None

    @property
    def current_state(self) -> tuple[int, str]:
        """Id and label."""
        return self._state, STATES[self._state]

    @property
    def available_states(self) -> list[tuple[int, str]]:
        """All states."""
        return list(STATES.items())

    @property
    def available_transitions(self) -> list[tuple[int, str, int, str, int, str]]:
        """The transitions from the current state."""
        return [each.described() for each in TRANSITIONS if each.start == self._state]

    @property
    def transition_graph(self) -> list[tuple[int, str, int, str, int, str]]:
        """All transitions."""
        return [each.described() for each in TRANSITIONS]

    def get_transition_by_label(self, label: str) -> int:
        """Return the id of the transition with that label from the current state; RCLError if there is none."""
        for each in TRANSITIONS:
            if each.start == self._state and each.label == label:
                return each.id
        self._warn(label)
        raise RCLError("Failed to get transition from label: error not set")

    def trigger_transition_by_id(self, transition_id: int, publish_update: bool) -> None:
        """Make a transition; RCLError if it is not possible in the current state."""
        self._make(next((t for t in self._possible() if t.id == transition_id), None), transition_id, publish_update)

    def trigger_transition_by_label(self, label: str, publish_update: bool) -> None:
        """Make a transition; RCLError if it is not possible in the current state."""
        self._make(next((t for t in self._possible() if t.label == label), None), label, publish_update)

    def _possible(self) -> list[Transition]:
        return [each for each in TRANSITIONS if each.start == self._state]

    def _warn(self, wanted: int | str) -> None:
        text = f"No transition matching {wanted} found for current state {STATES[self._state]}"
        self._settings.emit(30, "rcl_lifecycle", text, "", "", 0)

    def _make(self, transition: Transition | None, wanted: int | str, publish_update: bool) -> None:
        if transition is None:
            self._warn(wanted)
            raise RCLError(
                "Failed to trigger lifecycle state machine transition: Transition is not registered., "
                "at /project/src/rcl_lifecycle.c:355"
            )
        self._state = transition.goal
        if publish_update:
            self._on_transition(transition)
