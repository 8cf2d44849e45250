"""What a plugin of rqt is: a model and its window, on a node that all plugins of one program share.

`ros2 run rqt_graph rqt_graph` runs one plugin, `rqt` runs as many as its user opens (`rqt_gui.py`). A plugin is written once:

    class TopicMonitorPlugin(Plugin[TopicMonitor]):
        kind, title = "topics", "Topic Monitor"

        def __init__(self, place: Place) -> None:
            super().__init__(place, TopicMonitor(place.node, place.session.clock.now_ns))  # the model that the window draws
            self.model.on_request = place.wake                     # the window calls it, on any thread

        async def run(self) -> None:                               # cancelled when the plugin is closed
            await self.place.follow(self.model.refresh, 0.1)

        def close(self) -> None:                                   # gives back what it has on the shared node
            self.model.close()

    async def main(session: Session) -> int | None:
        return await run_alone(session, TopicMonitorPlugin)

and named in `catalogue.KNOWN`. Its module has the name of its package's executable.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Coroutine, Mapping
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, Generic, Protocol, TypeVar, cast

from day6_core.ros.programs.rqt_gui.command_line import own_words, plugin_parser
from day6_core.ros.programs.rqt_gui.perspectives import Perspectives, folder_of
from day6_core.session.argument_parser import ParserExit
from day6_core.session.task import Signal
from day6_core.session.threads import in_thread

if TYPE_CHECKING:
    from argparse import Namespace

    from day6_core.ros.programs.rqt_py_common.requests import Requests
    from day6_core.session.argument_parser import SessionParser
    from day6_core.session.session import Session
    from day6_core.session.task import Task
    from rclpy.node import Node

Model = TypeVar("Model")

Settings = Mapping[str, Any]
"""What a perspective keeps of a plugin: values that JSON has, by names that rqt's plugin has where it keeps the same."""


class PluginPlace:
    """Where one plugin runs: what it gets from its program, and what ends with it."""

    def __init__(
        self, session: Session, node: Node, options: Namespace | None = None, settings: Settings | None = None
    ) -> None:
        self.session = session
        self.node = node
        """The node of the program, `/rqt_gui_py_node_<pid>`: every plugin of it creates its endpoints there."""
        self.settings: Settings = settings or {}
        """What `Plugin.settings` returned when the perspective was kept; of a file, so of any shape."""
        self._options = options
        self._woken = Signal()
        self._worked = Signal()
        """Set after what `follow` and `serve` do, which may have given `repeat` something to do."""
        self._tasks: list[Task] = []
        self._deferred: list[Callable[[], object]] = []
        self._follows_graph = False

    def option(self, name: str, default: Any) -> Any:
        """What the command line says for an argument of `Plugin.add_arguments`; the container's plugins have none."""
        return getattr(self._options, name, default)

    def wake(self) -> None:
        """Have `follow` work again (any thread)."""
        self._woken.set()

    def spawn(self, coroutine: Coroutine[Any, Any, Any]) -> Task:
        """Start a task that ends with the plugin; an error in it is the program's."""
        task = self.session.spawn(coroutine)
        self._tasks.append(task)
        return task

    def defer(self, function: Callable[[], object]) -> None:
        """Call `function` when the plugin is closed or the program ends; the last one is called first."""
        self._deferred.append(function)

    async def follow(self, work: Callable[[], object], pause: float) -> None:
        """Call `work` now, and after every `wake` and change of the graph, at most once in `pause` world seconds; for ever."""
        if not self._follows_graph:
            self._follows_graph = True
            graph = self.session.graph
            assert graph is not None
            self.defer(graph.add_listener(lambda event: self._woken.set()))
            self._woken.set()  # other threads may have changed the graph before anybody listened
        while True:
            await self.session.wait(self._woken)
            self._woken.clear()
            work()
            self._worked.set()
            await self.session.sleep(pause)

    async def repeat(self, work: Callable[[], object], pause: float, needed: Callable[[], object]) -> None:
        """Call `work` every `pause` world seconds while it is needed; for ever. A window that stands still wakes nobody."""
        while True:
            while not needed():
                self._worked.clear()
                await self.session.wait(self._worked)
            await self.session.sleep(pause)
            work()

    def serve(self, requests: Requests) -> None:
        """Carry out the requests of the plugin's window as they come, while the plugin runs."""
        wanted = Signal()
        requests.on_request = wanted.set

        async def run() -> None:
            while True:
                await self.session.wait(wanted)
                wanted.clear()
                requests.handle()
                self._worked.set()

        self.spawn(run())

    def end(self) -> None:
        """End what the plugin has started."""
        tasks, self._tasks = self._tasks, []
        for task in tasks:
            task.cancel()
        while self._deferred:
            self._deferred.pop()()


class Plugin(ABC, Generic[Model]):
    """One plugin that runs. `model` is what its window draws; the window may read it and call its requests on any thread."""

    kind: ClassVar[str]
    """Of its window, see `day6_tui/windows/__init__.py`."""
    title: ClassVar[str]
    """Of its window, as in rqt."""
    in_cpp: ClassVar[bool] = False
    """Whether the real plugin is written in C++: then its node is `/rqt_gui_cpp_node_<pid>`."""

    def __init__(self, place: PluginPlace, model: Model) -> None:
        self.place = place
        self.model = model

    @staticmethod
    def add_arguments(parser: SessionParser) -> None:
        """Add what the plugin's own program takes on its command line; the plugin asks for it by `Place.option`."""

    @abstractmethod
    async def run(self) -> None:
        """Serve the window until the plugin is closed, which cancels this; the node is spun by the program."""

    def close(self) -> None:
        """Destroy what the plugin created on the shared node. Called once, after `run` was ended."""

    def settings(self) -> Settings:
        """What a perspective keeps of it."""
        return {}

    async def without_screen(self) -> int | None:
        """What the program does where there is no screen, by the rule of `programs/_without_screen.py`. Returns its status.

        By default it is a node until it is interrupted.
        """
        session, node = self.place.session, self.place.node
        session.spawn(self.run())
        node.get_logger().info("There is no screen for the window: the node runs without it")
        await session.spin(node)
        return 0


class PluginType(Protocol):
    """A class of plugins that makes its own model."""

    @property
    def in_cpp(self) -> bool: ...

    def add_arguments(self, parser: SessionParser, /) -> None: ...

    def __call__(self, place: PluginPlace, /) -> Plugin[Any]: ...


def plugin_of(package: str) -> PluginType:
    """Return the plugin of a package: the one that the module of its executable defines, which runs it alone."""
    module = import_module(f"day6_core.ros.programs.{package}.{package}")
    classes = (each for each in vars(module).values() if isinstance(each, type) and each.__module__ == module.__name__)
    return cast("PluginType", next(each for each in classes if issubclass(each, Plugin)))


def create_node(session: Session, *, in_cpp: bool = False) -> Node:
    """Return the node of a program of rqt (rqt_gui_py's ros_py_plugin_provider.py, rqt_gui_cpp's ros_cpp_plugin_provider)."""
    return session.create_node(f"rqt_gui_{'cpp' if in_cpp else 'py'}_node_{session.pid}")


def open_first(session: Session, kind: str, title: str, model: object) -> None:
    """Open the window with which a program of rqt begins.

    It gets the keyboard, as on a real desktop; not from somebody who has started it with `&` to go on typing.
    """
    assert session.display is not None
    session.display.open(kind, title, model, chosen=not session.background)


async def run_alone(session: Session, plugin_type: PluginType) -> int | None:
    """Run one plugin as a program of its own, `ros2 run rqt_graph rqt_graph`, until its window is closed."""
    parser = plugin_parser(session, Path(session.argv[0]).name, plugin_type.add_arguments)
    try:
        options = parser.parse_args(own_words(session.argv))
    except ParserExit as end:
        return end.status
    if options.clear_config:
        try:
            await in_thread(Perspectives(folder_of(session)).clear)
        except OSError as error:
            session.print_error(f"{error.filename}: {error.strerror}")
    node = create_node(session, in_cpp=plugin_type.in_cpp)
    place = PluginPlace(session, node, options)
    plugin = plugin_type(place)
    session.defer(place.end)
    if session.display is None:
        return await plugin.without_screen()
    open_first(session, plugin.kind, plugin.title, plugin.model)
    session.spawn(session.spin(node))
    await plugin.run()
    return 0
