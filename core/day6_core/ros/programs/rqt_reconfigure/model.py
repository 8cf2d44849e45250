"""What Parameter Reconfigure shows: the nodes that have parameters, and those of the nodes that are opened.

The window runs on another thread: it reads and makes requests, the program's thread carries them out.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from day6_core.graph.names import full_name
from day6_core.ros.programs.rqt_py_common.requests import Requests
from day6_core.ros.programs.rqt_reconfigure.opened import OpenedNode, OpenNode
from day6_core.session.blocking_files import read_at_most
from day6_core.whole_file import replace_file

if TYPE_CHECKING:
    from rclpy.node import Node

LARGEST_FILE = 100_000
"""Bytes of a file that is loaded: YAML takes seconds for more."""


class Reconfigure(Requests):
    """The model of one plugin. The window may read `nodes`, `opened`, `filter`, `message`, `version`, and request."""

    def __init__(self, node: Node, now: Callable[[], int], path: Callable[[str], Path]) -> None:
        super().__init__()
        self._node, self._now = node, now
        self.path = path
        """The file that a user of this program means."""
        self._opened: dict[str, OpenedNode] = {}
        self.nodes: tuple[str, ...] = ()
        """The full names of the nodes that have parameters, sorted."""
        self.opened: tuple[OpenNode, ...] = ()
        """In the order in which they were opened."""
        self.filter = ""
        """Part of the names of the nodes that are listed."""
        self.message = ""
        """What became of the last file, in one line."""
        self.version = 0
        self.on_load: Callable[[str, Path], object] | None = None
        """Called with a node and a file whose values it is to get."""

    # -- the window's side ---------------------------------------------------------------------------------------------

    def toggle(self, node: str) -> None:
        """Show the parameters of a node, or no more."""
        self.post(lambda: self.close_node(node) if node in self._opened else self.open_node(node))

    def set(self, node: str, parameter: str, value: Any) -> None:
        """Send a value of the parameter's type."""
        self._of(node, lambda: self._opened[node].set(parameter, value))

    def move(self, node: str, parameter: str, steps: int) -> None:
        """Move a slider by so many steps."""
        self._of(node, lambda: self._opened[node].move(parameter, steps))

    def read(self, node: str) -> None:
        """Read a node's parameters anew."""
        self._of(node, lambda: self._opened[node].read())

    def cancel(self, node: str) -> None:
        """Wait for no response of a node any more."""
        self._of(node, lambda: self._opened[node].cancel())

    def load(self, node: str, name: str) -> None:
        """Give a node the values of a file."""
        self._of(node, partial(self._load, node, self.path(name)))

    def save(self, node: str, name: str) -> Path:
        """Write the values of an opened node to a file, as the real plugin does: a mapping of names. Raises OSError."""
        import yaml

        found = next((each for each in self.opened if each.name == node), None)
        values = {each.name: each.value for each in found.parameters} if found is not None else {}
        path = self.path(name)
        replace_file(path, yaml.safe_dump(values, allow_unicode=True).encode("utf-8"))
        return path

    def _of(self, node: str, work: Callable[[], object]) -> None:
        """Post what is wanted of a node, unless it is closed by then."""
        self.post(lambda: work() if node in self._opened else None)

    # -- the program's side --------------------------------------------------------------------------------------------

    def refresh(self) -> None:
        """Look which nodes there are."""
        node = self._node
        full_names = {full_name(namespace, name) for name, namespace in node.get_node_names_and_namespaces()}
        # Not by the list of services: it has those that are only called, too.
        nodes = tuple(sorted(name for name in full_names if node.count_services(f"{name}/list_parameters")))
        if nodes != self.nodes:
            self.nodes = nodes
            self.version += 1
        for name, each in self._opened.items():
            each.look(name in nodes)

    def open_node(self, name: str) -> None:
        """Show a node's parameters, once it is there."""
        if name not in self._opened:
            self._opened[name] = OpenedNode(self._node, name, self._now, self._show)
            self._opened[name].look(name in self.nodes)
            self._show()

    def close_node(self, name: str) -> None:
        """Show a node's parameters no more."""
        self._opened.pop(name).close()
        self._show()

    @property
    def is_waiting(self) -> bool:
        """Whether a response has not come."""
        return any(each.waiting for each in self._opened.values())

    def tick(self) -> None:
        """Count the seconds for which a response is waited; called about once a second meanwhile."""
        self._show()

    def take_values(self, node: str, values: dict[str, Any]) -> None:
        """Send values that were read from a file. Raises TypeError for one that no parameter can have."""
        from rclpy.parameter import Parameter

        parameters: list[Parameter[Any]] = [Parameter(name, value=value) for name, value in values.items()]
        if node in self._opened:
            self._opened[node].send(parameters)

    def tell(self, message: str) -> None:
        """Show what became of a file."""
        self.message = message
        self.version += 1

    def close(self) -> None:
        """Give back what the opened nodes have on the program's node."""
        while self._opened:
            self._opened.popitem()[1].close()

    def _load(self, node: str, path: Path) -> None:
        if self.on_load is not None:
            self.on_load(node, path)

    def _show(self) -> None:
        opened = tuple(each.snapshot for each in self._opened.values())
        if opened != self.opened:
            self.opened = opened
            self.version += 1


def read_values(path: Path) -> dict[str, Any]:
    """The names and values of a file like those that `save` writes; long ones take seconds. Raises OSError and ValueError."""
    import yaml

    text = read_at_most(path, LARGEST_FILE)
    found: dict[str, Any] = {}
    try:
        for document in yaml.safe_load_all(text):
            if not isinstance(document, dict) or not all(isinstance(name, str) for name in document):
                raise ValueError("not a mapping of parameter names to values")
            found.update(document)
    except (yaml.YAMLError, RecursionError) as error:
        raise ValueError(" ".join(str(error).split())) from error
    return found
