"""One node whose parameters are shown: asked for them, followed on /parameter_events, and given new values.

Nothing waits: a request is a future, and what its response says goes on in its callback, on the thread that spins the node.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import ParameterEvent
from rcl_interfaces.srv import DescribeParameters, GetParameters, ListParameters, SetParameters

from day6_core.ros.programs.rqt_py_common.service_calls import ServiceCalls
from day6_core.ros.programs.rqt_reconfigure.ranges import Range, range_of
from rclpy.parameter import Parameter as RosParameter
from rclpy.parameter import parameter_value_to_python
from rclpy.qos import qos_profile_parameter_events

if TYPE_CHECKING:
    from rcl_interfaces.msg import Parameter as ParameterMessage
    from rcl_interfaces.msg import ParameterDescriptor, ParameterValue

    from rclpy.client import Client
    from rclpy.node import Node

MOST_PARAMETERS = 5_000
"""More names than these are not asked for: no person reads them, and a broken node may send any number."""

PATIENCE_SECONDS = 1.0
"""After this time without a response the window says so; the real plugin gives up then (param_api.py)."""

NOT_SPINNING = "the target node may not be spinning"
"""The hint of the real plugin (param_api.py)."""


@dataclass(frozen=True, slots=True)
class Parameter:
    """One parameter as the window shows it."""

    name: str
    kind: int
    """A number of rcl_interfaces/msg/ParameterType."""
    value: Any
    """Of Python's type; a value that was sent, until the node has refused it."""
    description: str = ""
    constraints: str = ""
    read_only: bool = False
    range: Range | None = None
    limits: str = ""
    """The descriptor's range in words, also of one that can be no slider; '' for none."""
    sent: bool = False
    """Whether a new value was sent and not answered yet."""
    refusal: str = ""
    """Why the node did not take the last value, in its words."""


@dataclass(frozen=True, slots=True)
class OpenNode:
    """What there is to see of one opened node."""

    name: str
    there: bool
    """Whether the node exists: otherwise its parameters are the last known ones."""
    parameters: tuple[Parameter, ...]
    complete: bool
    """Whether all parameters were read; otherwise their names, descriptions or values are being waited for."""
    waited: int | None
    """The whole seconds since the oldest request without a response was sent; None if nothing is waited for."""
    message: str = ""
    """What went wrong in reading, in the words of the real plugin."""


class OpenedNode:
    """The program's side of one opened node; `changed` is called whenever `snapshot` differs."""

    def __init__(self, node: Node, name: str, now: Callable[[], int], changed: Callable[[], object]) -> None:
        self.name = name
        self._node, self._changed = node, changed
        self._calls = ServiceCalls(now, changed, self._on_failure)
        # The clients and the subscription are those of the real plugin (param_api.py, ParamClient).
        self._get: Client[Any, Any] = node.create_client(GetParameters, f"{name}/get_parameters")
        self._set: Client[Any, Any] = node.create_client(SetParameters, f"{name}/set_parameters")
        self._list: Client[Any, Any] = node.create_client(ListParameters, f"{name}/list_parameters")
        self._describe: Client[Any, Any] = node.create_client(DescribeParameters, f"{name}/describe_parameters")
        self._events = node.create_subscription(
            ParameterEvent, "/parameter_events", self._on_event, qos_profile_parameter_events
        )
        self._parameters: dict[str, Parameter] = {}
        self._known: dict[str, Any] = {}
        """The values the node has, by names whose new value was sent."""
        self._told: set[str] = set()
        """Those of them whose value came by an event since: it need not be the one that was sent."""
        self._next: dict[str, tuple[int, Any]] = {}
        """What is sent once the node has answered: of many changes of one parameter only the last."""
        self._there = False
        self._complete = False
        self._message = ""

    # -- what there is -------------------------------------------------------------------------------------------------

    @property
    def snapshot(self) -> OpenNode:
        """What the window shows."""
        waited = self._calls.waited
        message = self._message or (NOT_SPINNING if waited is not None and waited >= PATIENCE_SECONDS else "")
        return OpenNode(self.name, self._there, tuple(self._parameters.values()), self._complete, waited, message)

    @property
    def waiting(self) -> bool:
        return self._calls.waited is not None

    def look(self, there: bool) -> None:
        """The node exists, or does not; one that has come is read, once its services are there."""
        if there and not self._there:
            # They become known one after the other; a request to one that is not yet would be lost.
            self._there = all(each.service_is_ready() for each in (self._list, self._describe, self._get, self._set))
            if self._there:
                self.read()
        elif not there and self._there:
            self._there = False
            self.cancel()
        self._changed()

    # -- reading -------------------------------------------------------------------------------------------------------

    def read(self) -> None:
        """Ask for all parameters."""
        self.cancel()
        self._complete, self._message = False, ""
        self._calls.send(self._list, ListParameters.Request(), self._on_names)
        self._changed()

    def cancel(self) -> None:
        """Wait for no response any more: values that were sent are put back."""
        self._calls.give_up()
        self._next.clear()
        for name, value in self._known.items():
            self._change(name, value=value, sent=False)
        self._known.clear()
        self._changed()

    def _on_names(self, response: ListParameters.Response) -> None:
        names = list(response.result.names)
        if len(names) > MOST_PARAMETERS:
            self._message = f"{len(names)} parameters, {MOST_PARAMETERS} shown"
            del names[MOST_PARAMETERS:]
        self._parameters = {name: each for name, each in self._parameters.items() if name in set(names)}
        self._complete = not names
        if names:
            self._calls.send(
                self._describe, DescribeParameters.Request(names=names), partial(self._on_descriptors, names)
            )

    def _on_descriptors(self, names: list[str], response: DescribeParameters.Response) -> None:
        found = {each.name: each for each in response.descriptors}
        self._calls.send(self._get, GetParameters.Request(names=names), partial(self._on_values, names, found))

    def _on_values(
        self, names: list[str], descriptors: dict[str, ParameterDescriptor], response: GetParameters.Response
    ) -> None:
        if len(response.values) != len(names):
            # What a node answers that does not know one of the names any more.
            self._message = self._message or "not all parameters could be read"
        for name, value in zip(names, response.values, strict=False):
            self._put(name, value, descriptors.get(name))
        self._parameters = dict(sorted(self._parameters.items()))
        self._complete = True

    def _put(self, name: str, value: ParameterValue, descriptor: ParameterDescriptor | None) -> None:
        found = _python(value)
        if found is None:  # not set, as undeclared: the real plugin has no editor for it
            self._parameters.pop(name, None)
            return
        if name in self._known:
            self._known[name] = found
            self._told.add(name)
            return
        known = self._parameters.get(name)
        if descriptor is not None:
            known = _described(name, value.type, found, descriptor)
        elif known is not None:
            known = replace(known, kind=value.type, value=found, refusal="")
        else:
            known = Parameter(name, value.type, found)
        self._parameters[name] = known

    # -- following -----------------------------------------------------------------------------------------------------

    def _on_event(self, event: ParameterEvent) -> None:
        if event.node != self.name:
            return
        for deleted in event.deleted_parameters:
            self._parameters.pop(deleted.name, None)
            self._known.pop(deleted.name, None)
        self._take((*event.new_parameters, *event.changed_parameters))
        self._changed()

    def _take(self, values: Iterable[ParameterMessage]) -> None:
        unknown: list[str] = []
        for each in values:
            if each.name in self._parameters:
                self._put(each.name, each.value, None)
            elif len(self._parameters) + len(unknown) < MOST_PARAMETERS:
                unknown.append(each.name)
        if unknown and self._there:
            request = DescribeParameters.Request(names=unknown)
            self._calls.send(self._describe, request, partial(self._on_descriptors, unknown))

    # -- setting -------------------------------------------------------------------------------------------------------

    def set(self, name: str, value: Any) -> None:
        """Send a new value of the parameter's type, unless it has it already."""
        known = self._parameters.get(name)
        if known is not None and not known.read_only and self._there and value != known.value:
            self.send([RosParameter(name, RosParameter.Type(known.kind), value)])

    def move(self, name: str, steps: int) -> None:
        """Send the value that is so many steps of the slider away."""
        known = self._parameters.get(name)
        if known is not None and known.range is not None:
            self.set(name, known.range.moved(known.value, steps))

    def send(self, parameters: list[RosParameter[Any]]) -> None:
        """Send parameters in one request; of those that are not answered yet, later."""
        now = []
        for each in parameters:
            known = self._parameters.get(each.name)
            if known is not None and known.sent:
                self._next[each.name] = (int(each.type_), each.value)
            else:
                now.append(each)
                self._told.discard(each.name)
            if known is not None:
                self._known.setdefault(each.name, known.value)
                self._change(each.name, value=each.value, kind=int(each.type_), sent=True, refusal="")
        if now:
            request = SetParameters.Request(parameters=[each.to_parameter_msg() for each in now])
            self._calls.send(self._set, request, partial(self._on_set, now))
        self._changed()

    def _on_set(self, sent: list[RosParameter[Any]], response: SetParameters.Response) -> None:
        for each, result in zip(sent, response.results, strict=False):
            if result.successful and each.name not in self._told:
                self._known[each.name] = each.value
        again = []
        refused = {
            each.name: result.reason or "Setting parameter failed"
            for each, result in zip(sent, response.results, strict=False)
            if not result.successful
        }
        for each in sent:
            kind, value = self._next.pop(each.name, (int(each.type_), None))
            if value is not None:
                again.append(RosParameter(each.name, RosParameter.Type(kind), value))
                self._change(each.name, sent=False)
                continue
            before = self._known.pop(each.name, each.value)
            self._change(each.name, value=before, sent=False, refusal=refused.get(each.name, ""))
        unknown = [name for name in refused if name not in self._parameters]
        if unknown:
            self._message = f"{unknown[0]}: {refused[unknown[0]]}"
        if again:
            self.send(again)

    # -- plumbing ------------------------------------------------------------------------------------------------------

    def _change(self, name: str, **fields: Any) -> None:
        known = self._parameters.get(name)
        if known is not None:
            self._parameters[name] = replace(known, **fields)

    def _on_failure(self, reason: str) -> None:
        self._message, self._complete = reason, True

    def close(self) -> None:
        """Give back what it has on the node."""
        self.cancel()
        for client in (self._get, self._set, self._list, self._describe):
            self._node.destroy_client(client)
        self._node.destroy_subscription(self._events)


def _python(value: ParameterValue) -> Any:
    """The value as a Python type; None for one that is not set, or of a type that nobody knows."""
    try:
        return parameter_value_to_python(value)
    except RuntimeError:
        return None


def _described(name: str, kind: int, value: Any, descriptor: ParameterDescriptor) -> Parameter:
    ranges = (*descriptor.integer_range, *descriptor.floating_point_range)
    limits = f"{ranges[0].from_value} .. {ranges[0].to_value}" if ranges else ""
    if ranges and ranges[0].step:
        limits += f" : {ranges[0].step}"
    number = kind in (RosParameter.Type.INTEGER, RosParameter.Type.DOUBLE)
    found = range_of(descriptor) if number else None
    if found is not None and found.whole != (kind == RosParameter.Type.INTEGER):
        found = None
    return Parameter(
        name,
        kind,
        value,
        descriptor.description,
        descriptor.additional_constraints,
        descriptor.read_only,
        found,
        limits,
    )
