"""Contexts: one use of ROS, from init() to shutdown()."""

from __future__ import annotations

import os
import sys
import threading
import time
import warnings
import weakref
from collections.abc import Callable, Iterable, Mapping
from types import MethodType, TracebackType
from typing import TYPE_CHECKING, Any

from day6_core.graph import Graph, graph_for_domain
from day6_core.graph.discovery import discovery_warning
from day6_core.graph.domain import DomainError, domain_from_text
from rclpy._day6.incidental import also
from rclpy._day6.logging_settings import PROCESS, LoggingSettings
from rclpy._day6.time_base import MACHINE_TIME, AutoResetEvent, TimeBase
from rclpy._day6.withdrawn import withdraw
from rclpy._rclpy_pybind11 import RCL_DEFAULT_DOMAIN_ID, Destroyable, RCLError

if TYPE_CHECKING:
    from rclpy._day6.arguments import RosArguments
    from rclpy._day6.log_file import LogFile
    from rclpy.executors import Executor
    from rclpy.node import Node

__getattr__ = also(__name__)

_Callback = Callable[[], None]

_WRONG_ARGUMENTS = (
    "__init__(): incompatible constructor arguments. The following argument types are supported:\n"
    "    1. rclpy._rclpy_pybind11.Context(arg0: list, arg1: typing.SupportsInt)\n\nInvoked with: {!r}, {!r}"
)

_living: weakref.WeakSet[Context]


class _ContextHandle(Destroyable):
    """The handle of an initialised context."""

    def __init__(self, context: Context) -> None:
        super().__init__()
        self._context = weakref.ref(context)

    def ok(self) -> bool:
        """Return whether the context has not been shut down."""
        context = self._context()
        return context is not None and context.ok()

    def get_domain_id(self) -> int:
        """Return the domain of the context's nodes."""
        context = self._context()
        return 0 if context is None else context.get_domain_id()


class Context:
    """One initialisation of ROS: arguments, domain, and the nodes made with it.

    A context is initialised once and shut down once. Unlike a real one it needs no middleware: its nodes live in the graph
    of its domain in this process, joined to other processes by the link.
    """

    def __init__(self) -> None:
        self._lock = threading.RLock()
        self._callbacks: list[weakref.WeakMethod[MethodType] | _Callback] = []
        self._handle: _ContextHandle | None = None
        self._valid = False
        self._ended = False
        self._nodes: list[weakref.ReferenceType[Node]] = []
        self._executors: weakref.WeakSet[Executor] = weakref.WeakSet()
        self._end_watchers: list[_Callback] = []
        self._graph: Graph | None = None
        self._program: object | None = None
        self._domain_id = 0
        self._arguments: RosArguments | None = None
        self._topic_types: dict[str, list[Any]] = {}
        """topic -> [type name, number of endpoints] of this context: one participant has one type per topic"""
        self._time: TimeBase = MACHINE_TIME
        self._logging: LoggingSettings = PROCESS
        self._uses_link = True
        self._folder = ""
        self._has_joined = False

    @classmethod
    def _for_session(
        cls,
        graph: Graph,
        time_source: TimeBase,
        args: list[str] | None = None,
        env: Mapping[str, str] | None = None,
        write: Callable[[str], Any] | None = None,
        log_file: LogFile | None = None,
        folder: str = "",
    ) -> Context:
        """Return an initialised context on `graph` whose clocks read `time_source`; it has no link and touches no signal.

        `args` are its global arguments (default: none), `env` the environment for its logging (default: this process's).
        `write` gets its log lines, including those about wrong arguments (default: stderr), and so does `log_file`
        (default: none). It has its own log levels and logging output. Relative names of files in `args` begin in `folder`.
        """
        context = cls()
        context._graph = graph
        context._program = object()
        context._time = time_source
        context._uses_link = False
        context._logging = LoggingSettings(time_source, env)
        context._log_write = write
        context._folder = folder
        context._logging.file = log_file
        context.init(args if args is not None else [], domain_id=graph.domain_id)
        return context

    @property
    def _log_write(self) -> Callable[[str], Any] | None:
        """The function that writes log lines of this context's nodes; None is stderr."""
        return self._logging.write

    @_log_write.setter
    def _log_write(self, write: Callable[[str], Any] | None) -> None:
        self._logging.write = write

    @property
    def handle(self) -> _ContextHandle | None:
        """The handle of an initialised context, None before init()."""
        return self._handle

    def destroy(self) -> None:
        """Destroy the handle."""
        if self._handle is not None:
            self._handle.destroy_when_not_in_use()

    def init(
        self, args: list[str] | None = None, *, initialize_logging: bool = True, domain_id: int | None = None
    ) -> None:
        """Initialise the context.

        `args` are command line arguments, by default `sys.argv`; `domain_id` by default that of ROS_DOMAIN_ID, else 0.

        Raises:
            RuntimeError: for a second call or a negative domain.
            RCLError, UnknownROSArgsError: for bad arguments.
        """
        from rclpy._day6.arguments import parse_global_arguments

        with self._lock:
            if domain_id is not None and domain_id < 0:
                raise RuntimeError(f"Domain id ({domain_id}) should not be lower than zero.")
            if self._handle is not None:
                raise RuntimeError("Context.init() must only be called once")
            if args is not None and not isinstance(args, Iterable):
                raise TypeError(
                    _WRONG_ARGUMENTS.format(args, RCL_DEFAULT_DOMAIN_ID if domain_id is None else domain_id)
                )
            self._arguments = parse_global_arguments(sys.argv if args is None else args, self._logging, self._folder)
            self._domain_id = _domain_from_environment() if domain_id is None else domain_id
            if warning := discovery_warning(os.environ):
                self._logging.emit(30, "rcl", warning, "", "", 0)
            if self._graph is None:
                self._graph = graph_for_domain(self._domain_id)
            self._handle = _ContextHandle(self)
            self._valid = True
            if initialize_logging:
                if self._logging is PROCESS:
                    _open_log_file(self._arguments)
                self._arguments.apply_levels(self._logging)
            _living.add(self)

    def _living_nodes(self) -> list[Node]:
        """Return the nodes that were made with this context and exist."""
        return [node for reference in list(self._nodes) if (node := reference()) is not None]

    def track_node(self, node: Node) -> None:
        """Remember a node, to destroy it at shutdown."""
        with self._lock:
            self._nodes.append(weakref.ref(node))

    def untrack_node(self, node: Node) -> None:
        """Forget a node that was destroyed."""
        with self._lock:
            for index, reference in enumerate(self._nodes):
                if reference() is node:
                    del self._nodes[index]
                    return

    def ok(self) -> bool:
        """Return whether the context is initialised and not shut down."""
        return self._valid

    def _invalidate(self) -> None:
        """Make the context invalid without destroying its nodes: what a signal does."""
        self._valid = False
        for executor in list(self._executors):
            executor.wake()
        for watcher in list(self._end_watchers):
            watcher()

    def _watch_end(self, watcher: _Callback) -> _Callback:
        """Call `watcher()`, from any thread, when the context becomes invalid; returns the function that removes it."""
        self._end_watchers.append(watcher)

        def remove() -> None:
            if watcher in self._end_watchers:
                self._end_watchers.remove(watcher)

        return remove

    def _wait_for_graph(self, condition: Callable[[], bool], timeout_sec: float | None) -> bool:
        """Block until a condition on the graph is true, the context is invalid or time is up; return the condition."""
        if condition():
            return True
        changed = AutoResetEvent()
        assert self._graph is not None
        end_of_changes = self._graph.add_listener(lambda _event: changed.set())
        end_of_watch = self._watch_end(changed.set)
        end = None if timeout_sec is None else time.monotonic() + timeout_sec
        try:
            while self._valid and not condition():
                left = None if end is None else end - time.monotonic()
                if left is not None and left <= 0:
                    return False
                changed.wait(left)
        finally:
            end_of_changes()
            end_of_watch()
        return condition()

    def _call_on_shutdown_callbacks(self) -> None:
        for each in self._callbacks:
            callback = each() if isinstance(each, weakref.WeakMethod) else each
            if callback is not None:
                callback()
        self._callbacks = []

    def _cleanup(self) -> None:
        for reference in list(self._nodes):
            node = reference()
            if node is not None:
                node.destroy_node()
        if self._ended:
            raise RuntimeError("Context already shutdown.")
        # After a signal the context is invalid, but it can still be shut down any number of times.
        self._ended = self._valid
        self._invalidate()
        self._call_on_shutdown_callbacks()
        if self._uses_link and self._graph is not None and not any(c._graph is self._graph for c in _valid_contexts()):
            _leave(self._graph)

    def shutdown(self) -> None:
        """Shut the context down: destroy its nodes, call the shutdown callbacks.

        Raises:
            RuntimeError: before init().
        """
        if self._handle is None:
            raise RuntimeError("Context must be initialized before it can be shutdown")
        with self._lock:
            self._cleanup()

    def try_shutdown(self) -> None:
        """Shut the context down unless it already was, or was never initialised."""
        if self._handle is None:
            return
        with self._lock:
            if self._valid:
                self._cleanup()

    def _remove_callback(self, callback: weakref.WeakMethod[MethodType]) -> None:
        if callback in self._callbacks:
            self._callbacks.remove(callback)

    def on_shutdown(self, callback: _Callback) -> None:
        """Call `callback` at shutdown, or now if that has happened. Methods are referenced weakly."""
        if not callable(callback):
            raise TypeError("callback should be a callable, got {}", type(callback))
        with self._lock:
            if self._handle is not None and not self._valid:
                callback()
            elif isinstance(callback, MethodType):
                self._callbacks.append(weakref.WeakMethod(callback, self._remove_callback))
            else:
                self._callbacks.append(callback)

    def get_domain_id(self) -> int:
        """Return the ROS domain.

        Raises:
            RuntimeError: before init().
        """
        if self._handle is None:
            raise RuntimeError("Context must be initialized before it can have a domain id")
        return self._domain_id

    def _join_link(self) -> None:
        """Join the graphs of other processes; called for the first node of a context."""
        graph = self._graph
        if not self._uses_link or self._has_joined or graph is None or os.environ.get("DAY6_LINK") == "off":
            return
        self._has_joined = True
        try:
            from day6_core.link import join
            from rclpy._day6.lost_errors import follow_threads

            if graph.report_process is None:
                follow_threads(lambda: bool(_valid_contexts()))
            graph.report_process = _report_process
            join(graph)
        except Exception as error:
            # The program matters more than the connection: it runs alone and logs that.
            print(f"day6-tui: no link to other programs ({type(error).__name__}: {error})", file=sys.stderr)

    def __enter__(self) -> Context:
        if self._handle is None:
            warnings.warn(
                "init() must be called on a Context before using it in a Python context manager. "
                "Calling init() with no arguments, this usage is deprecated",
                stacklevel=1,
            )
            self.init()
        return self

    def __exit__(
        self,
        exc_type: type[BaseException] | None,
        exc_val: BaseException | None,
        exc_tb: TracebackType | None,
    ) -> None:
        self.try_shutdown()


_living = weakref.WeakSet()


def _report_process() -> bytes:
    from rclpy._day6.process_report import tell

    return tell()


def _valid_contexts() -> list[Context]:
    return [context for context in list(_living) if context._valid]


def _domain_from_environment() -> int:
    """Read ROS_DOMAIN_ID as rcl does; raises RCLError."""
    try:
        return domain_from_text(os.environ.get("ROS_DOMAIN_ID", ""))
    except DomainError as error:
        raise RCLError(str(error)) from None


def _open_log_file(arguments: RosArguments) -> None:
    """Give this process its log file, once.

    RCLError for a configuration file, and if the folder that the user has chosen cannot be made; any other failure means no file.
    """
    from rclpy._day6.log_file import of_process

    if PROCESS.file is not None or not arguments.switches.get("external-lib", True):
        return
    if arguments.log_config_file:
        raise RCLError(
            "failed to initialize logging: spdlog logging backend doesn't currently support external configuration, "
            "at /project/src/rcl_logging_spdlog.cpp:116"
        )
    file = of_process()
    file.program = arguments.log_file_name or file.program
    try:
        file.open()
    except OSError as error:
        if file.is_wanted:
            raise RCLError(
                f"failed to initialize logging: Failed to create log directory '{file.folder}': {error.errno}, "
                "at /project/src/rcl_logging_spdlog.cpp:153"
            ) from None
        file.enabled = False
    PROCESS.file = file


def _leave(graph: Graph) -> None:
    leave = getattr(sys.modules.get("day6_core.link"), "leave", None)
    if leave is not None:  # else nobody has joined, or another thread is just importing it
        leave(graph, ending=True)


withdraw(__name__)
