"""The ROS 2 client library for Python as day6-tui provides it: rclpy's names on the graph of day6-tui.

A program initialises (`init`), makes nodes (`create_node` or a class derived from `rclpy.node.Node`), lets their callbacks
run (`spin`, `spin_once`, `spin_until_future_complete`) and ends with `shutdown`.

Modules without an underscore stand for the files of the same name in real rclpy (kilted). Of the others `_node_*` are the
parts of a node, `_rounds` and `_timer_heap` decide what an executor runs next, `_handles` and `_endpoint_handles` refer to the
graph, `_arguments` and `_parameter_files` read ROS arguments and parameter files; `_rclpy_pybind11` has the names of rclpy's
C++ half. Programs import this package; it imports `day6_core.graph` and `day6_core.interfaces`, and `day6_core.link` for the
first node.
"""

from __future__ import annotations

import sys
from types import TracebackType
from typing import TYPE_CHECKING, Any

import rclpy.callback_groups
import rclpy.exceptions
import rclpy.impl  # noqa: F401
from day6_core.ros.differences import value
from rclpy._day6.incidental import also
from rclpy._day6.shadowed import fail_as_real
from rclpy._day6.withdrawn import withdraw
from rclpy.context import Context as Context
from rclpy.parameter import Parameter as Parameter
from rclpy.qos import QoSProfile as QoSProfile
from rclpy.qos import qos_profile_rosout_default as qos_profile_rosout_default
from rclpy.signals import SignalHandlerOptions as SignalHandlerOptions
from rclpy.signals import install_signal_handlers as install_signal_handlers
from rclpy.signals import uninstall_signal_handlers as uninstall_signal_handlers
from rclpy.task import Future as Future
from rclpy.utilities import get_default_context as get_default_context
from rclpy.utilities import get_rmw_implementation_identifier as get_rmw_implementation_identifier
from rclpy.utilities import ok as ok
from rclpy.utilities import shutdown as _shutdown
from rclpy.utilities import try_shutdown as _try_shutdown

if TYPE_CHECKING:
    from rclpy.executors import Executor
    from rclpy.node import Node

fail_as_real()
if value("rclpy.deprecated_names"):
    __path__.append(f"{__path__[0]}/_day6/until_kilted")

# In real rclpy these come with another module, so programs use them as attributes once that is imported.
_WITH = {
    **dict.fromkeys(
        (
            "event_handler",
            "executors",
            "logging",
            "logging_service",
            "qos_overriding_options",
            "subscription_content_filter_options",
            "topic_endpoint_info",
            "type_hash",
            "validate_full_topic_name",
            "validate_namespace",
            "validate_node_name",
            "validate_topic_name",
        ),
        "rclpy.node",
    ),
    "action": "tf2_ros.buffer_client",
}

_also = also(__name__)


def __getattr__(name: str) -> Any:
    if _WITH.get(name) in sys.modules:
        from importlib import import_module

        return import_module(f"rclpy.{name}")
    return _also(name)


class InitContextManager:
    """Returned by `init`: as a context manager it shuts ROS down at the end of the block."""

    def __init__(
        self,
        args: list[str] | None,
        context: Context | None,
        domain_id: int | None,
        signal_handler_options: SignalHandlerOptions | None,
    ) -> None:
        default = get_default_context()
        self.context = default if context is None else context
        if signal_handler_options is None:
            signal_handler_options = SignalHandlerOptions.ALL if self.context is default else SignalHandlerOptions.NO
        self.installed_signal_handlers = signal_handler_options is not SignalHandlerOptions.NO
        self.context.init(args, domain_id=domain_id)
        install_signal_handlers(signal_handler_options)

    def __enter__(self) -> InitContextManager:
        return self

    def __exit__(
        self,
        exc_type: type[BaseException] | None,
        exc_val: BaseException | None,
        exc_tb: TracebackType | None,
    ) -> None:
        # Without an explicit context a new default context is made.
        context = None if self.context is get_default_context() else self.context
        try_shutdown(context=context, uninstall_handlers=self.installed_signal_handlers)


def init(
    *,
    args: list[str] | None = None,
    context: Context | None = None,
    domain_id: int | None = None,
    signal_handler_options: SignalHandlerOptions | None = None,
) -> InitContextManager:
    """Initialise ROS for a context; returns a context manager, in Humble nothing.

    `args` are command line arguments (default `sys.argv`), `context` by default the default one, `domain_id` by default
    that of ROS_DOMAIN_ID. Signal handlers are installed for the default context unless `signal_handler_options` says
    otherwise.

    Raises:
        RuntimeError: the second time.
        RCLError, UnknownROSArgsError: for bad arguments.
    """
    manager = InitContextManager(args, context, domain_id, signal_handler_options)
    return manager if value("rclpy.init_returns_manager") else None  # type: ignore[return-value]


__executor: Executor | None = None


def get_global_executor() -> Executor:
    """Return the executor that the functions of this module use by default."""
    global __executor
    if __executor is None:
        from rclpy.executors import SingleThreadedExecutor

        __executor = SingleThreadedExecutor()

        def reset_executor() -> None:
            global __executor
            if __executor is not None:
                __executor.shutdown()
            __executor = None

        get_default_context().on_shutdown(reset_executor)
    return __executor


def _also_uninstall(context: Context | None, uninstall_handlers: bool | None) -> bool:
    if uninstall_handlers is None:
        return context is None or context is get_default_context()
    return uninstall_handlers


def shutdown(*, context: Context | None = None, uninstall_handlers: bool | None = None) -> None:
    """Shut a context down (default: the default one) and with it the global executor.

    Signal handlers are removed with the default context unless `uninstall_handlers` says otherwise.

    Raises:
        RuntimeError: if the context was never initialised.
    """
    _shutdown(context=context)
    if _also_uninstall(context, uninstall_handlers):
        uninstall_signal_handlers()


def try_shutdown(*, context: Context | None = None, uninstall_handlers: bool | None = None) -> None:
    """Shut a context down as `shutdown` does, unless that has been done."""
    _try_shutdown(context=context)
    if _also_uninstall(context, uninstall_handlers):
        uninstall_signal_handlers()


def create_node(
    node_name: str,
    *,
    context: Context | None = None,
    cli_args: list[str] | None = None,
    namespace: str | None = None,
    use_global_arguments: bool = True,
    enable_rosout: bool = True,
    rosout_qos_profile: QoSProfile | int = qos_profile_rosout_default,
    start_parameter_services: bool = True,
    parameter_overrides: list[Parameter[Any]] | None = None,
    allow_undeclared_parameters: bool = False,
    automatically_declare_parameters_from_overrides: bool = False,
    enable_logger_service: bool = False,
) -> Node:
    """Make a node; the arguments are those of `rclpy.node.Node`."""
    from rclpy.node import Node

    return Node(
        node_name,
        context=context,
        cli_args=cli_args,
        namespace=namespace,
        use_global_arguments=use_global_arguments,
        enable_rosout=enable_rosout,
        rosout_qos_profile=rosout_qos_profile,
        start_parameter_services=start_parameter_services,
        parameter_overrides=parameter_overrides,
        allow_undeclared_parameters=allow_undeclared_parameters,
        automatically_declare_parameters_from_overrides=automatically_declare_parameters_from_overrides,
        enable_logger_service=enable_logger_service,
    )


def spin_once(node: Node, *, executor: Executor | None = None, timeout_sec: float | None = None) -> None:
    """Run one callback, or wait for one until `timeout_sec` (None or negative: for ever, 0: not at all).

    The callback may be another node's if the executor has more of them.
    """
    executor = get_global_executor() if executor is None else executor
    added = False
    try:
        added = executor.add_node(node)
        executor.spin_once(timeout_sec=timeout_sec)
    finally:
        if added:
            executor.remove_node(node)


def spin(node: Node, executor: Executor | None = None) -> None:
    """Run callbacks until the executor's context is shut down. An exception of a callback ends it."""
    executor = get_global_executor() if executor is None else executor
    try:
        executor.add_node(node)
        while executor.context.ok():
            executor.spin_once()
    finally:
        executor.remove_node(node)


def spin_until_future_complete(
    node: Node, future: Future[Any], executor: Executor | None = None, timeout_sec: float | None = None
) -> None:
    """Run callbacks until `future` is done, the context is shut down, or `timeout_sec` is over (None: no limit)."""
    executor = get_global_executor() if executor is None else executor
    added = False
    try:
        added = executor.add_node(node)
        executor.spin_until_future_complete(future, timeout_sec)
    finally:
        if added:
            executor.remove_node(node)


withdraw(__name__)
