"""`rqt` and `ros2 run rqt_gui rqt_gui`: opens plugins side by side, on one node, and keeps them as perspectives.

`rqt --standalone rqt_plot` is `ros2 run rqt_plot rqt_plot`. Without a screen it lists the plugins, or goes on as the one that was
named (see `programs/_without_screen.py`).
"""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from day6_core.reason import named_reason
from day6_core.ros.programs.rqt_gui import perspectives
from day6_core.ros.programs.rqt_gui.catalogue import PluginEntry, matching, plugins
from day6_core.ros.programs.rqt_gui.command_line import container_parser, own_words
from day6_core.ros.programs.rqt_gui.model import Open, Rqt
from day6_core.ros.programs.rqt_gui.perspectives import DEFAULT, Instance, Perspectives, folder_of
from day6_core.ros.programs.rqt_gui.plugin import Plugin, PluginPlace, Settings, create_node, open_first, plugin_of
from day6_core.session.argument_parser import ParserExit
from day6_core.session.session import Session, Terminated
from day6_core.session.task import Signal
from day6_core.session.threads import Newest, in_thread

if TYPE_CHECKING:
    import argparse

    from day6_core.session.display import Window
    from rclpy.node import Node

KEEP_SECONDS = 20.0
"""Seconds after which changed settings of plugins are written at the latest; the real rqt writes them when it is closed."""


async def main(session: Session) -> int | None:
    """Show the plugins to choose from, and run those that are open until interrupted; without a display list them."""
    words = own_words(session.argv)
    at = words.index("--args") if "--args" in words else len(words)
    try:
        options = container_parser(session).parse_args(words[:at])
    except ParserExit as end:
        return end.status
    store = Perspectives(folder_of(session))
    if at < len(words) and options.standalone is None:
        # The sentences of qt_gui's main.py.
        session.print(
            "Option --args can only be used together with either --standalone, --command-start-plugin or --embed-plugin option"
        )
        return 1
    if options.perspective is not None and options.perspective_file is not None:
        session.print("Only one --perspective-* option can be used at a time")
        return 1
    file = options.perspective_file
    if file is not None and not await in_thread(session.path(file).is_file):
        session.print("Option --perspective-file must reference existing file")
        return 1
    if options.list_perspectives:
        session.print("\n".join(await in_thread(store.names)))
        return 0
    if options.standalone is not None:
        return await _standalone(session, options.standalone, words[at + 1 :])
    if session.display is None or options.list_plugins:
        session.print("\n".join(sorted(entry.type for entry in plugins())))
        return 0
    return await Container(session, store).run(options)


async def _standalone(session: Session, name: str, words: list[str]) -> int | None:
    from day6_core.ros.programs import load

    found = matching(name)
    if not found:
        session.print(f'qt_gui_main() found no plugin matching "{name}"')
        return 1
    if len(found) > 1:
        types = "\n".join(entry.type for entry in found)
        session.print(f'qt_gui_main() found multiple plugins matching "{name}"\n{types}')
        return 1
    package = found[0].package
    return await session.execute(load(package, package), [package, *words])


class _Running:
    """A plugin that runs in the container."""

    def __init__(self, plugin: Plugin[Any], window: Window[Any]) -> None:
        self.plugin = plugin
        self.window = window


class Container:
    """Runs the plugins of one rqt. Its public methods are the requests of the window (`model.Request`)."""

    def __init__(self, session: Session, store: Perspectives) -> None:
        assert session.display is not None
        self._session = session
        self._display = session.display
        self._store = store
        self._woken = Signal()
        self._nodes: dict[bool, Node] = {}
        """By whether it is of plugins written in C++."""
        self._running: dict[Open, _Running] = {}
        self._absent: list[Instance] = []
        """Of the perspective: plugins that are not here. They stay in it."""
        self._kept = True
        """Whether the perspective is written when something changes: not over one that could not be read."""
        self._written: list[Instance] = []
        """What the perspective's file has."""
        self._newest = Newest()
        """What writes it: Ctrl-C leaves that behind, and what is newer must not be lost to it."""
        self.model = Rqt(plugins(), session.path, self._woken.set)

    async def run(self, options: argparse.Namespace) -> int:
        """Open the window and work off its requests until the program is ended, as by closing it."""
        open_first(self._session, "rqt", "rqt", self.model)
        self._session.defer(self._end_all)
        if options.clear_config:
            await self._try(self._store.clear)
        if options.perspective_file is not None:
            await self.load(self.model.path(options.perspective_file))
        else:
            await self.switch(options.perspective or await in_thread(self._store.current))
        try:
            while True:
                await self._session.wait(self._woken, KEEP_SECONDS)
                if self._instances() != self._written:
                    await self._keep()
                self._woken.clear()
                while self.model.requests:
                    deed, subject = self.model.requests[0]
                    self.model.trouble = ""
                    await getattr(self, deed)(subject)
                    self.model.version += 1
                    self.model.requests.pop(0)
        except (KeyboardInterrupt, Terminated) as end:
            await self._keep()  # settings have changed since the last plugin was opened
            if isinstance(end, Terminated):
                raise
            return 0  # Ctrl-C closes rqt's window (qt_gui's main.py)

    # -- requests ------------------------------------------------------------------------------------------------------

    async def start(self, entry: PluginEntry) -> None:
        """Open a plugin with the lowest number that is free."""
        taken = {each.serial for each in self._running if each.entry == entry}
        serial = next(number for number in range(1, len(taken) + 2) if number not in taken)
        self._begin(Open(entry, serial), {}, chosen=True)
        await self._keep()

    async def stop(self, plugin: Open) -> None:
        """Close a plugin."""
        self._end(plugin)
        await self._keep()

    async def switch(self, name: str) -> None:
        """Close all plugins and open those of a perspective."""
        name = name.replace("/", "__").replace("\\", "__")  # qt_gui's perspective_manager.py; it is a file's name here
        found = await self._try(partial(self._store.load, name))
        self._replace_all(name, found or [])
        self._kept = found is not None
        await self._keep()

    async def keep_as(self, name: str) -> None:
        """Make a perspective of what is open."""
        self.model.perspective = name
        self._kept = True
        await self._keep()

    async def remove(self, name: str) -> None:
        """Forget a perspective."""
        await self._try(partial(self._store.remove, name))
        self._tell_names(await in_thread(self._store.names))

    async def load(self, path: Path) -> None:
        """Open a file's perspective, under its name; the user's own one of that name stays, as `<name> (1)` is free."""
        found = await self._try(partial(perspectives.load_file, path))
        if found is None:
            return
        names = await in_thread(self._store.names)
        name = stem = path.stem if not perspectives.wrong_name(path.stem) else DEFAULT
        number = 1
        while name in names:
            name, number = f"{stem} ({number})", number + 1
        self._replace_all(name, found)
        await self._keep()

    async def export(self, path: Path) -> None:
        """Write a file of the perspective."""
        await self._try(partial(perspectives.save_file, path, self._instances()))

    # -- plugins -------------------------------------------------------------------------------------------------------

    def _replace_all(self, name: str, found: list[Instance]) -> None:
        self._end_all()
        known = {entry.name: entry for entry in self.model.plugins}
        self._absent = [each for each in found if each.name not in known]
        for each in self._absent:
            # qt_gui's plugin_manager.py
            self._session.print_error(
                f"PluginManager._load_plugin() could not load plugin {each.name!r}: plugin not available"
            )
        for name_of, serial, settings in found:
            if name_of in known:
                self._begin(Open(known[name_of], serial), settings)
        self.model.perspective = name
        self._kept = True

    def _begin(self, opened: Open, settings: Settings, *, chosen: bool = False) -> None:
        plugin_type = plugin_of(opened.entry.package)
        place = PluginPlace(self._session, self._node(in_cpp=plugin_type.in_cpp), settings=settings)
        plugin: Plugin[Any] = plugin_type(place)
        window = self._display.open(plugin.kind, opened.title, plugin.model, chosen=chosen)
        window.on_close = partial(self.model.stop, opened)
        self._running[opened] = _Running(plugin, window)
        place.spawn(plugin.run())
        self._tell()

    def _node(self, *, in_cpp: bool) -> Node:
        if in_cpp not in self._nodes:
            node = self._nodes[in_cpp] = create_node(self._session, in_cpp=in_cpp)
            self._session.spawn(self._session.spin(node))
        return self._nodes[in_cpp]

    def _end(self, opened: Open) -> None:
        running = self._running.pop(opened, None)
        if running is None:
            return
        running.window.close()
        running.plugin.place.end()
        running.plugin.close()
        self._tell()

    def _end_all(self) -> None:
        for opened in list(self._running):
            self._end(opened)

    def _instances(self) -> list[Instance]:
        present = [
            Instance(each.entry.name, each.serial, running.plugin.settings()) for each, running in self._running.items()
        ]
        return present + self._absent

    # -- what the window shows -----------------------------------------------------------------------------------------

    def _tell(self) -> None:
        self.model.open = tuple(self._running)
        self.model.version += 1

    def _tell_names(self, names: list[str]) -> None:
        self.model.perspectives = tuple(sorted({*names, self.model.perspective}))
        self.model.version += 1

    async def _keep(self) -> None:
        """Write the perspective, so that the next rqt begins with it."""
        self._written = self._instances()
        if self._kept:
            save = partial(self._store.save, self.model.perspective, self._written)
            await self._try(self._newest.of(save))
        self._tell_names(await in_thread(self._store.names))

    async def _try(self, work: Any) -> Any:
        """Return what work at the disk returns; what fails is told in the window, and None returned."""
        try:
            return await in_thread(work) or []
        except (OSError, ValueError) as error:
            self.model.trouble = named_reason(error)
            self.model.version += 1
            return None
