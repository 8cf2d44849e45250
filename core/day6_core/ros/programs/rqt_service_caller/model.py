"""What the Service Caller shows: the services, the request that is filled in, and the response."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING, Any

from day6_core.interfaces import SerializationError, definition_text, get_service
from day6_core.ros.programs.rqt_py_common.expressions import NAMES, ExpressionError, evaluate
from day6_core.ros.programs.rqt_py_common.message_form import (
    INTERFACE_ERRORS,
    FieldKind,
    FieldRow,
    MessageForm,
    Rejected,
    elements,
    field_rows,
    octet,
)
from day6_core.ros.programs.rqt_py_common.requests import Requests

if TYPE_CHECKING:
    from rclpy.client import Client
    from rclpy.node import Node
    from rclpy.task import Future

SECOND = 1_000_000_000

REQUEST_NAMES = {**NAMES, "i": 0}
"""What an expression in a request may use; rqt's Service Caller never counts `i` up."""


def convert(text: str, kind: FieldKind, names: Mapping[str, Any]) -> Any:
    """Return the value of a request's field: what cannot be computed is taken as the text that it is.

    Raises:
        Rejected: in the words of service_caller_widget.py.
    """
    value: Any = text
    try:
        value, found = evaluate(text, names), True
    except ExpressionError:
        found = False
    make = octet if kind.python is bytes else kind.python
    try:
        if not kind.is_array:
            return value if type(value) is kind.python else make(value)
        if found:
            return elements(value, kind.python, make)
    except (ArithmeticError, TypeError, ValueError):
        pass
    if found:
        raise Rejected(f"can not convert expression to slot type: {type(value)} -> {kind.python}")
    raise Rejected(f"failed to evaluate expression: {text}")


class ServiceCaller(Requests):
    """The model of one Service Caller. The window reads its attributes and calls what is below "the window's side"."""

    def __init__(self, node: Node, steady_ns: Callable[[], int], wanted: str = "") -> None:
        """`wanted`: the service to be chosen as soon as it is there; `steady_ns`: the world's time."""
        super().__init__()
        self._node, self._steady_ns = node, steady_ns
        self._wanted = wanted
        self._form: MessageForm | None = None
        self._client: Client[Any, Any] | None = None
        self._since_ns = 0
        self._served = False
        """Whether somebody offers the service that is called."""
        self._known: dict[str, bool] = {}
        """Whether types are here."""
        self.services: tuple[tuple[str, str], ...] = ()
        """Names and types of those that can be called, by name."""
        self.service = self.type = ""
        """The one that is chosen."""
        self.request: list[FieldRow] = []
        self.response: list[FieldRow] | None = None
        """None before there is one."""
        self.state = ""
        """Of the last call: waiting, answered, cancelled, gone (its server) or failed (see `message`)."""
        self.waited = 0
        """Whole seconds for which an answer has been waited for."""
        self.message = ""
        """A warning, in rqt's words."""
        self.on_warning: Callable[[str], None] = lambda text: None
        """Gets every warning, for the terminal."""
        self.version = 0

    # -- the window's side ---------------------------------------------------------------------------------------------

    def refresh(self) -> None:
        """Look for services again."""
        self.post(self._refresh)

    def choose(self, service: str) -> None:
        """Prepare a request to this service."""
        self._wanted = ""
        self.post(partial(self._choose, service))

    def set_expression(self, path: str, text: str) -> None:
        """Give a field of the request an expression; an empty one gives it back its default."""
        self.post(partial(self._set_expression, path, text))

    def resize(self, path: str, step: int) -> None:
        """Give a sequence in the request one element more (1) or less (-1)."""
        self.post(partial(self._resize, path, step))

    def call(self) -> None:
        """Send the request."""
        self.post(self._call)

    def cancel(self) -> None:
        """Wait for the answer no longer."""
        self.post(partial(self._stop, "cancelled"))

    # -- the program's side --------------------------------------------------------------------------------------------

    @property
    def is_waiting(self) -> bool:
        return self._client is not None

    def follow(self) -> None:
        """Carry out the window's requests, and look at the graph."""
        self._look()
        self.handle()

    def tick(self) -> None:
        """Count the seconds of waiting."""
        waited = (self._steady_ns() - self._since_ns) // SECOND
        if self.is_waiting and waited != self.waited:
            self.waited = waited
            self.version += 1

    def close(self) -> None:
        """Give back what is on the node."""
        self._stop("cancelled")

    def _look(self) -> None:
        found = []
        for name, types in sorted(self._node.get_service_names_and_types()):
            # As the real one does: those of actions are left out, and those whose type is not here.
            if types[0].split("/")[1:2] == ["srv"] and self._is_known(types[0]):
                found.append((name, types[0]))
        if self._client is not None:
            # Its name stays in the graph as long as somebody, we, would call it.
            served, self._served = self._served, self._client.service_is_ready()
            if served and not self._served:
                self._stop("gone")
        if tuple(found) != self.services:
            self.services = tuple(found)
            self.version += 1
        names = [name for name, _ in found]
        if self._wanted in names:
            service, self._wanted = self._wanted, ""
            self._choose(service)
        elif not self.service and names:
            self._choose(names[0])

    def _is_known(self, type_name: str) -> bool:
        if type_name not in self._known:
            try:
                self._known[type_name] = bool(definition_text(type_name))
            except (LookupError, ValueError):
                self._known[type_name] = False
        return self._known[type_name]

    def _refresh(self) -> None:
        self._known.clear()  # a package may have been built
        self._look()

    def _choose(self, service: str) -> None:
        type_name = dict(self.services).get(service)
        if type_name is None:
            return
        self._stop("")
        self.service, self.type = service, type_name
        self.request, self.response, self.state, self.message = [], None, "", ""
        try:
            self._form = MessageForm(get_service(type_name).Request, convert)
        except INTERFACE_ERRORS as error:
            self._form = None
            self._fail(f"could not get class {type_name} of service {service}: {error}")
        self._filled()

    def _filled(self) -> None:
        """The request has changed: look whether its expressions can be used."""
        self.version += 1
        if self._form is not None:
            self._form.message(REQUEST_NAMES)
            self.request = self._form.rows(1)

    def _set_expression(self, path: str, text: str) -> None:
        if self._form is not None:
            self._form.set(path, text)
            self._filled()

    def _resize(self, path: str, step: int) -> None:
        if self._form is not None:
            self._form.resize(path, step, REQUEST_NAMES)
            self._filled()

    def _call(self) -> None:
        if self._form is None or self.is_waiting:
            return
        self.response, self.state, self.message = None, "", ""
        self.version += 1
        if self.service not in dict(self._node.get_service_names_and_types()):
            self._fail(f'Service "{self.service}" is no longer available. Refresh the list of services')
            return
        request = self._form.message(REQUEST_NAMES)
        for problem in self._form.problems.values():
            self.on_warning(problem)
        client = self._client = self._node.create_client(get_service(self.type), self.service)
        try:
            future = client.call_async(request)
        except (SerializationError, AssertionError, OverflowError, TypeError, ValueError) as error:
            self._stop("")
            self._fail(
                f'ServiceCaller.on_call_service_button_clicked(): error calling service "{self.service}".\n{error}'
            )
            return
        self.state, self.waited, self._since_ns = "waiting", 0, self._steady_ns()
        self._served = client.service_is_ready()
        future.add_done_callback(partial(self._answered, client))

    def _answered(self, client: Client[Any, Any], future: Future[Any]) -> None:
        if client is not self._client:
            return  # nobody waits for it any more
        self._stop("answered")
        self.response = field_rows(future.result(), 1)

    def _fail(self, text: str) -> None:
        self.state, self.message = "failed", text
        self.on_warning(text)

    def _stop(self, state: str) -> None:
        """Wait no longer."""
        if self._client is not None:
            self._node.destroy_client(self._client)
            self._client = None
            self.state = state
            self.version += 1
