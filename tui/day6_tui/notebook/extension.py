"""The extension itself: gives every node of a cell a spinner when the cell has ended, and says what became of it."""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Callable
from typing import TYPE_CHECKING

from day6_core.graph import GraphEvent, graph_for_domain
from day6_core.graph import Node as GraphNode
from day6_core.graph.graph import Change
from day6_core.language import language_of
from day6_core.ros.environment import activate, program_environment
from day6_tui.distribution_choice import settle
from day6_tui.locale import Texts
from day6_tui.notebook.errors import picture, place, show_interrupt
from day6_tui.notebook.ros2_line import Ros2Line
from day6_tui.notebook.shell import InteractiveShell

if TYPE_CHECKING:
    from day6_core.graph import Graph
    from day6_tui.notebook.spinner import Spinner
    from rclpy.node import Node

LOOK_SECONDS = 1.0
STUCK_SECONDS = 5
"""After these a callback that has not returned is told."""
MOST_NAMES = 5
"""In one line."""
_loaded: list[Notebook] = []


def load(shell: InteractiveShell) -> None:
    """Load it into an IPython shell; a second time changes nothing."""
    if not _loaded:
        settle(None)
        activate()
        _loaded.append(Notebook(shell))


def unload(shell: InteractiveShell) -> None:
    """Stop spinning, and end what %ros2 has left running. What was imported stays."""
    while _loaded:
        _loaded.pop().close()


class Notebook:
    """Spins the nodes of the default context that no cell spins. Needs `activate`."""

    def __init__(self, shell: InteractiveShell) -> None:
        from day6_tui.notebook.init_in_cells import InitInCells

        os.environ.update(program_environment())  # for !ros2 and !python3
        os.environ.setdefault("RCUTILS_LOGGING_USE_STDOUT", "1")  # notebooks show stderr as errors, in red
        self._shell = shell
        self._texts = Texts(language_of(os.environ))
        self._spinners: dict[Node, Spinner] = {}
        self._told: set[str] = set()
        """The names of nodes that the pupil knows to go on."""
        self._watched: dict[Graph, Callable[[], None]] = {}
        """graph -> what stops its listener"""
        self._closed = threading.Event()
        self._init = InitInCells(lambda: print(self._texts("notebook.init_again")))
        self._ros2 = Ros2Line(self._texts)
        shell.events.register("post_run_cell", self._take_nodes)
        shell.register_magic_function(self._ros2.run, "line", "ros2")
        if not shell.custom_exceptions:
            shell.set_custom_exc((KeyboardInterrupt,), show_interrupt)
        threading.Thread(target=self._watch_callbacks, name="day6 callbacks", daemon=True).start()
        print(self._texts("notebook.here"))

    def close(self) -> None:
        """Stop the threads; nodes stay, and are spun by nobody."""
        self._closed.set()
        self._shell.events.unregister("post_run_cell", self._take_nodes)
        self._shell.magics_manager.magics["line"].pop("ros2", None)
        if self._shell.custom_exceptions == (KeyboardInterrupt,):
            self._shell.set_custom_exc((), None)
        self._init.restore()
        self._ros2.close()
        for remove in self._watched.values():
            remove()
        for spinner in self._spinners.values():
            spinner.end()

    # -- nodes come and go ---------------------------------------------------------------------------------------------

    def _take_nodes(self, *_: object) -> None:
        """After a cell: spin the nodes that nobody spins, and forget those that are gone."""
        import rclpy
        from day6_tui.notebook.spinner import Spinner

        context = rclpy.get_default_context()
        nodes = context._living_nodes() if context.ok() else []
        for node in [node for node in self._spinners if node not in nodes]:
            self._spinners.pop(node).end()
        if not nodes:
            return
        self._watch_names(graph_for_domain(context.get_domain_id()))
        for node in nodes:
            if node in self._spinners:
                self._spinners[node].take()
            elif node.executor is None or node not in node.executor.get_nodes():
                self._spinners[node] = Spinner(node, self._tell_failure)
        self._tell_new()

    def _watch_names(self, graph: Graph) -> None:
        if graph not in self._watched:
            self._watched[graph] = graph.add_listener(self._end_namesake)

    def _end_namesake(self, event: GraphEvent) -> None:
        """While a node comes into being: end the one that an earlier cell has made under its name."""
        made = event.subject
        if event.change is not Change.NODE_ADDED or not isinstance(made, GraphNode) or made.origin is not None:
            return
        for node, spinner in list(self._spinners.items()):
            if spinner.name != made.full_name:
                continue
            del self._spinners[node]
            spinner.end()
            if not node.handle.node.destroyed:
                node.destroy_node()
                print(self._texts("notebook.again", name=spinner.name))

    # -- what is said --------------------------------------------------------------------------------------------------

    def _tell_new(self) -> None:
        """Say that nodes go on, each name once."""
        new = {name: node for node, spinner in self._spinners.items() if (name := spinner.name) not in self._told}
        self._told.update(new)
        if len(new) == 1:
            ((name, node),) = new.items()
            variable = self._variable(node)
            end = f"{variable}.destroy_node()" if variable else "rclpy.shutdown()"
            print(self._texts("notebook.goes_on", name=name, end=end))
        elif new:
            names = ", ".join([*new][:MOST_NAMES]) + (" …" if len(new) > MOST_NAMES else "")
            print(self._texts("notebook.go_on", names=names))

    def _variable(self, node: Node) -> str:
        """The variable of the cells that is this node; '' if there is none."""
        names = (name for name, value in self._shell.user_ns.items() if value is node and name[0] != "_")
        return next(names, "")

    def _tell_failure(self, spinner: Spinner, error: BaseException) -> None:
        if isinstance(error, SystemExit):
            print(self._texts("notebook.ended", name=spinner.name), file=sys.stderr)
            return
        print(picture(self._shell, error), file=sys.stderr)
        print(self._texts("notebook.failed", name=spinner.name), file=sys.stderr)

    def _watch_callbacks(self) -> None:
        """Until the end: look for callbacks that do not return."""
        while not self._closed.wait(LOOK_SECONDS):
            for spinner in list(self._spinners.values()):
                if spinner.busy_seconds() < STUCK_SECONDS:
                    spinner.is_called_stuck = False
                elif not spinner.is_called_stuck:
                    spinner.is_called_stuck = True
                    spinner.cell.run(self._tell_stuck, spinner)

    def _tell_stuck(self, spinner: Spinner) -> None:
        where = place(self._shell, spinner.frame())
        text = self._texts(
            "notebook.stuck", name=spinner.name, seconds=STUCK_SECONDS, where=f" ({where})" if where else ""
        )
        print(text, file=sys.stderr)
