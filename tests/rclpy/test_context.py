"""Contexts, init and shutdown, signals, the functions of the package itself."""

from __future__ import annotations

import gc
import signal
from collections.abc import Iterator
from threading import Event, Thread
from typing import Any

import pytest
from std_msgs.msg import String
from std_srvs.srv import Trigger

import rclpy
from day6_core.graph import Graph
from rclpy.context import Context
from rclpy.exceptions import (
    InvalidParameterTypeException,
    InvalidParameterValueException,
    NotInitializedException,
    NoTypeSupportImportedException,
    ParameterAlreadyDeclaredException,
    ParameterImmutableException,
    ParameterNotDeclaredException,
    ParameterUninitializedException,
    ROSInterruptException,
)
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.signals import SignalHandlerOptions
from rclpy.task import Future
from rclpy.utilities import (
    get_available_rmw_implementations,
    get_default_context,
    get_rmw_implementation_identifier,
    timeout_sec_to_nsec,
)


@pytest.fixture(autouse=True)
def nothing_stays_initialised() -> Iterator[None]:
    yield
    rclpy.try_shutdown()


def test_a_context_begins_and_ends_once() -> None:
    context = Context()
    assert not context.ok()
    assert context.handle is None
    with pytest.raises(RuntimeError, match="Context must be initialized before it can be shutdown"):
        context.shutdown()
    context.try_shutdown()
    with pytest.raises(RuntimeError, match="Context must be initialized before it can have a domain id"):
        context.get_domain_id()
    context.init([])
    assert context.ok()
    with pytest.raises(RuntimeError, match=r"Context.init\(\) must only be called once"):
        context.init([])
    context.shutdown()
    assert not context.ok()
    context.try_shutdown()
    with pytest.raises(RuntimeError):
        context.shutdown()
    with pytest.raises(RuntimeError, match=r"Context.init\(\) must only be called once"):
        context.init([])


@pytest.mark.parametrize(("given", "variable", "domain"), [(None, "", 0), (None, "7", 7), (5, "7", 5), (0, "7", 0)])
def test_a_context_has_a_domain(monkeypatch: pytest.MonkeyPatch, given: int | None, variable: str, domain: int) -> None:
    monkeypatch.setenv("ROS_DOMAIN_ID", variable)
    context = Context()
    context.init([], domain_id=given)
    assert context.get_domain_id() == domain
    context.shutdown()


@pytest.mark.parametrize("text", ["x", "-x", "99999999999999999999"])
def test_a_domain_is_a_number(monkeypatch: pytest.MonkeyPatch, text: str) -> None:
    monkeypatch.setenv("ROS_DOMAIN_ID", text)
    with pytest.raises(RuntimeError, match=r"ROS_DOMAIN_ID is (not an integral number|out of range)"):
        Context().init([])
    with pytest.raises(RuntimeError, match=r"Domain id \(-1\) should not be lower than zero."):
        Context().init([], domain_id=-1)


def test_arguments_are_a_list() -> None:
    with pytest.raises(TypeError):
        Context().init(5)  # type: ignore[arg-type]


def test_callbacks_are_called_at_the_shutdown_or_at_once_after_it() -> None:
    context = Context()
    called: list[str] = []

    class Listener:
        def end(self) -> None:
            called.append("method")

    kept, lost = Listener(), Listener()
    context.init([])
    context.on_shutdown(lambda: called.append("function"))
    context.on_shutdown(kept.end)
    context.on_shutdown(lost.end)
    del lost
    gc.collect()
    context.shutdown()
    assert called == ["function", "method"]
    context.on_shutdown(lambda: called.append("late"))
    assert called == ["function", "method", "late"]
    with pytest.raises(TypeError):
        context.on_shutdown(5)  # type: ignore[arg-type]


def test_a_shutdown_destroys_the_nodes_of_the_context() -> None:
    one, other = Context(), Context()
    one.init([])
    other.init([])
    node, keeper = Node("doomed", context=one), Node("keeper", context=other)
    one.shutdown()
    with pytest.raises(rclpy.exceptions.InvalidHandle):
        node.get_name()
    assert keeper.get_name() == "keeper"
    assert other.ok()
    other.shutdown()


def test_a_context_ends_with_its_block() -> None:
    context = Context()
    with pytest.warns(UserWarning, match=r"init\(\) must be called on a Context before using it"), context:
        assert context.ok()
    assert not context.ok()


def test_no_node_without_a_context() -> None:
    context = Context()
    message = "rclpy.init() has not been called. msg:cannot create node"
    for _ in range(2):
        with pytest.raises(NotInitializedException) as caught:
            Node("n", context=context)
        assert str(caught.value).replace("called.msg", "called. msg") == message
        if context.handle is None:
            context.init([])
            context.shutdown()


# the package


def test_the_default_context_is_initialised_and_shut_down() -> None:
    assert not rclpy.ok()
    rclpy.init(args=[])
    assert rclpy.ok()
    context = rclpy.get_default_context()
    assert context is get_default_context()
    assert context.ok()
    with pytest.raises(RuntimeError, match=r"Context.init\(\) must only be called once"):
        rclpy.init(args=[])
    rclpy.shutdown()
    assert not rclpy.ok()
    assert rclpy.get_default_context() is not context
    rclpy.try_shutdown()
    rclpy.init(args=[])
    assert rclpy.ok()


def test_another_context_leaves_the_default_one_alone() -> None:
    context = Context()
    rclpy.init(args=[], context=context, domain_id=9)
    assert rclpy.ok(context=context)
    assert not rclpy.ok()
    assert context.get_domain_id() == 9
    rclpy.shutdown(context=context)
    assert not rclpy.ok(context=context)
    rclpy.try_shutdown(context=context)


def test_init_is_a_block() -> None:
    with rclpy.init(args=[]) as manager:
        assert rclpy.ok()
        assert manager.context is rclpy.get_default_context()
    assert not rclpy.ok()
    context = Context()
    with rclpy.init(args=[], context=context):
        assert context.ok()
        assert not rclpy.ok()
    assert not context.ok()


def test_a_node_is_made_with_all_its_options() -> None:
    rclpy.init(args=["--ros-args", "-r", "t:=global"])
    node = rclpy.create_node(
        "n",
        namespace="lab",
        cli_args=["--ros-args", "-p", "a:=1"],
        use_global_arguments=False,
        enable_rosout=False,
        start_parameter_services=False,
        parameter_overrides=[Parameter("b", value=2)],
        allow_undeclared_parameters=True,
        automatically_declare_parameters_from_overrides=True,
        enable_logger_service=True,
    )
    assert node.get_fully_qualified_name() == "/lab/n"
    assert node.resolve_topic_name("t") == "/lab/t"
    assert [node.get_parameter(name).value for name in ("a", "b", "c")] == [1, 2, None]
    assert node.count_publishers("/rosout") == 0
    services = [name for name, _ in node.get_service_names_and_types_by_node("n", "/lab")]
    assert [name.rpartition("/")[2] for name in services] == [
        "get_logger_levels",
        "get_type_description",
        "set_logger_levels",
    ]
    assert node.context is rclpy.get_default_context()
    other = Context()
    other.init([])
    assert rclpy.create_node("m", context=other).context is other
    other.shutdown()


def test_a_node_is_spun_by_the_global_executor() -> None:
    rclpy.init(args=[])
    node = rclpy.create_node("n")
    heard: list[str] = []
    node.create_subscription(String, "t", lambda message: heard.append(message.data), 10)
    publisher = node.create_publisher(String, "t", 10)
    for word in ("a", "b"):
        publisher.publish(String(data=word))
        for _ in range(1000):
            rclpy.spin_once(node, timeout_sec=0.01)
            if heard and heard[-1] == word:
                break
    assert heard == ["a", "b"]
    assert node not in rclpy.get_global_executor().get_nodes()
    assert rclpy.get_global_executor() is rclpy.get_global_executor()


def test_a_future_is_spun_for() -> None:
    rclpy.init(args=[])
    node = rclpy.create_node("n")
    future: Future[int] = Future()
    node.create_timer(0.01, lambda: future.done() or future.set_result(5))
    rclpy.spin_until_future_complete(node, future, timeout_sec=10)
    assert future.result() == 5
    never: Future[int] = Future()
    rclpy.spin_until_future_complete(node, never, timeout_sec=0.03)
    assert not never.done()


def test_spin_ends_with_the_context() -> None:
    rclpy.init(args=[])
    node = rclpy.create_node("n")
    ticks: list[int] = []

    def tick() -> None:
        ticks.append(1)
        if len(ticks) == 3:
            rclpy.shutdown()

    node.create_timer(0.001, tick)
    rclpy.spin(node)
    assert len(ticks) == 3


# the link to other programs


class Link:
    """Stands in for day6_core/link: writes down who joins and who leaves. Joining twice is joining once, as there."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.told: list[tuple[str, int]] = []
        monkeypatch.setenv("DAY6_LINK", "on")
        self._joined: set[int] = set()
        monkeypatch.setattr("day6_core.link.join", self._join)
        monkeypatch.setattr("day6_core.link.leave", self._leave)

    def _join(self, graph: Graph) -> None:
        if graph.domain_id not in self._joined:
            self._joined.add(graph.domain_id)
            self.told.append(("join", graph.domain_id))

    def _leave(self, graph: Graph, *, ending: bool) -> None:
        if graph.domain_id in self._joined:
            self._joined.remove(graph.domain_id)
            self.told.append(("leave", graph.domain_id))


def begun(domain_id: int) -> Context:
    context = Context()
    context.init([], domain_id=domain_id)
    return context


def test_a_domain_is_joined_by_its_first_node_and_left_with_its_last_context(monkeypatch: pytest.MonkeyPatch) -> None:
    link = Link(monkeypatch)
    first, second, other = begun(71), begun(71), begun(72)
    assert link.told == []
    nodes = [Node("a", context=first), Node("b", context=first), Node("c", context=second), Node("d", context=other)]
    assert link.told == [("join", 71), ("join", 72)]
    nodes[0].destroy_node()
    first.shutdown()
    assert link.told[2:] == [], "the second context still uses the domain"
    other.shutdown()
    assert link.told[2:] == [("leave", 72)]
    second.shutdown()
    assert link.told[2:] == [("leave", 72), ("leave", 71)]
    third = begun(71)
    Node("e", context=third)
    third.try_shutdown()
    third.try_shutdown()
    assert link.told[4:] == [("join", 71), ("leave", 71)]


def test_a_context_without_nodes_or_with_the_link_off_joins_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    link = Link(monkeypatch)
    begun(71).shutdown()
    monkeypatch.setenv("DAY6_LINK", "off")
    alone = begun(71)
    Node("n", context=alone)
    alone.shutdown()
    assert link.told == []


def test_a_program_without_a_link_runs_alone_and_says_so(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    link = Link(monkeypatch)

    def fail(_graph: object) -> None:
        raise OSError("no network")

    monkeypatch.setattr("day6_core.link.join", fail)
    context = begun(71)
    nodes = [Node(name, context=context) for name in ("alone", "alone_too")]
    assert [node.get_name() for node in nodes] == ["alone", "alone_too"]
    assert capsys.readouterr().err == "day6-tui: no link to other programs (OSError: no network)\n"
    context.shutdown()
    assert link.told == []


def test_an_executor_that_waits_is_told_when_others_end_its_context(world: Any) -> None:
    for end in (Context.shutdown, lambda _: world.interrupt()):
        context = begun(71)
        executor = SingleThreadedExecutor(context=context)
        node = Node("n", context=context)
        executor.add_node(node)
        ended: list[str] = []

        def spin(executor: SingleThreadedExecutor = executor, ended: list[str] = ended) -> None:
            try:
                executor.spin()
            except ExternalShutdownException:
                ended.append("told")

        spinning = Event()
        node.create_guard_condition(spinning.set).trigger()
        thread = Thread(target=spin, daemon=True)
        thread.start()
        assert spinning.wait(30)
        thread.join(0.1)
        end(context)
        thread.join(30)
        assert not thread.is_alive()
        assert ended == ["told"], "it was waiting, so it is told"
        context.try_shutdown()


def test_a_graph_that_is_waited_for_ends_with_the_context() -> None:
    context = begun(71)
    node = Node("n", context=context)
    client = node.create_client(Trigger, "s")
    failed: list[str] = []

    def wait() -> None:
        try:
            client.wait_for_service(30)
        except RuntimeError as error:
            failed.append(str(error))

    thread = Thread(target=wait, daemon=True)
    thread.start()
    thread.join(0.02)
    context.shutdown()
    thread.join(20)
    assert failed == ["cannot use Destroyable because destruction was requested"]


# signals


@pytest.mark.parametrize(
    ("options", "sigint", "sigterm"),
    [
        (None, True, True),
        (SignalHandlerOptions.ALL, True, True),
        (SignalHandlerOptions.SIGINT, True, False),
        (SignalHandlerOptions.SIGTERM, False, True),
        (SignalHandlerOptions.NO, False, False),
    ],
)
def test_signals_are_handled_while_ros_runs(options: SignalHandlerOptions | None, sigint: bool, sigterm: bool) -> None:
    from rclpy.signals import get_current_signal_handlers_options

    before = [signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)]
    rclpy.init(args=[], signal_handler_options=options)
    assert get_current_signal_handlers_options() == (SignalHandlerOptions.ALL if options is None else options)
    now = [signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)]
    assert [one is not other for one, other in zip(before, now, strict=True)] == [sigint, sigterm]
    rclpy.shutdown()
    assert [signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)] == before
    assert get_current_signal_handlers_options() == SignalHandlerOptions.NO


def test_a_context_of_its_own_handles_no_signals() -> None:
    before = signal.getsignal(signal.SIGINT)
    context = Context()
    rclpy.init(args=[], context=context)
    assert signal.getsignal(signal.SIGINT) is before
    rclpy.shutdown(context=context)


def test_a_signal_makes_every_context_invalid_and_goes_on_to_the_earlier_handler() -> None:
    other = Context()
    other.init([])
    caught: list[int] = []
    before = signal.signal(signal.SIGTERM, lambda number, _frame: caught.append(number))
    try:
        rclpy.init(args=[])
        signal.raise_signal(signal.SIGTERM)
        assert caught == [signal.SIGTERM]
        assert not rclpy.ok()
        assert not other.ok()
        rclpy.try_shutdown()
        rclpy.uninstall_signal_handlers()
    finally:
        signal.signal(signal.SIGTERM, before)


def test_handlers_can_stay_after_a_shutdown() -> None:
    before = signal.getsignal(signal.SIGINT)
    rclpy.init(args=[])
    rclpy.shutdown(uninstall_handlers=False)
    assert signal.getsignal(signal.SIGINT) is not before
    rclpy.uninstall_signal_handlers()
    assert signal.getsignal(signal.SIGINT) is before
    with pytest.raises(TypeError, match=r"install_signal_handlers\(\): incompatible function arguments"):
        rclpy.install_signal_handlers(3)  # type: ignore[arg-type]


# small things


@pytest.mark.parametrize(
    ("seconds", "nanoseconds"),
    [(None, -1), (-1, -1), (-0.1, -1), (0, 0), (1, 10**9), (0.5, 5 * 10**8), (2.5, 25 * 10**8)],
)
def test_a_timeout_is_given_in_seconds(seconds: float | None, nanoseconds: int) -> None:
    assert timeout_sec_to_nsec(seconds) == nanoseconds


def test_the_middleware_has_a_name(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("RMW_IMPLEMENTATIONS", raising=False)
    monkeypatch.delenv("RMW_IMPLEMENTATION", raising=False)
    assert get_rmw_implementation_identifier() == "rmw_fastrtps_cpp"
    assert get_available_rmw_implementations() == {"rmw_fastrtps_cpp"}
    monkeypatch.setenv("RMW_IMPLEMENTATIONS", "rmw_fastrtps_cpp")
    assert get_available_rmw_implementations() == {"rmw_fastrtps_cpp"}
    monkeypatch.setenv("RMW_IMPLEMENTATIONS", "rmw_other")
    with pytest.raises(RuntimeError, match=r"The RMW implementations {'rmw_other'} specified"):
        get_available_rmw_implementations()


@pytest.mark.parametrize(
    ("error", "text"),
    [
        (NotInitializedException(), "rclpy.init() has not been called."),
        (NotInitializedException("why"), "rclpy.init() has not been called. msg:why"),
        (NoTypeSupportImportedException(), "no type_support imported"),
        (ROSInterruptException(), "rclpy.shutdown() has been called"),
        (ParameterNotDeclaredException(["a"]), "Invalid access to undeclared parameter(s): ['a']"),
        (ParameterAlreadyDeclaredException("a"), "Parameter(s) already declared: a"),
        (ParameterImmutableException("a"), "Attempted to modify read-only parameter: a"),
        (ParameterUninitializedException("a"), "The parameter 'a' is not initialized: a"),
        (
            InvalidParameterValueException("a", 5, "no"),
            "Invalid parameter value (5) for parameter. Reason: no: a",
        ),
        (
            InvalidParameterTypeException(Parameter("a", value=5), "STRING"),
            "Trying to set parameter 'a' to '5' of type 'INTEGER', expecting type 'STRING': a",
        ),
    ],
)
def test_exceptions_say_what_happened(error: Exception, text: str) -> None:
    assert str(error).replace("called.msg", "called. msg") == text
