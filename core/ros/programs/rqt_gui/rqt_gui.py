"""`rqt` and `ros2 run rqt_gui rqt_gui`: choose a window; `rqt --standalone rqt_plot` opens one at once.

Without a screen it lists what there is, or goes on as the plugin that was named (see `programs/_without_screen.py`).
"""

from __future__ import annotations

from day6_tui.core.ros.programs.rqt_gui.model import PLUGINS, Menu, Plugin, find
from day6_tui.core.session.session import Session
from day6_tui.core.session.task import Signal

USAGE = "usage: rqt [-h] [-l] [-s PLUGIN] [--args ...]"


async def main(session: Session) -> int | None:
    """Show the menu, then go on as the program that was chosen; without a display list what there is."""
    words = session.argv[1:]
    if "-h" in words or "--help" in words:
        session.print(f"{USAGE}\n\n  -l, --list-plugins         list the windows there are\n"
                      "  -s, --standalone PLUGIN    open this one at once")  # fmt: skip
        return 0
    for option in ("-s", "--standalone"):
        if option in words:
            return await _standalone(session, words[words.index(option) + 1 :])
    if session.display is None or "-l" in words or "--list-plugins" in words:
        for plugin in PLUGINS:
            session.print(plugin.package)
        return 0
    chosen = Signal()
    menu = Menu(chosen.set)
    window = session.display.open("rqt", "rqt", menu)
    await session.wait(chosen)
    window.on_close = None
    window.close()
    return await _go_on(session, menu.chosen or PLUGINS[0], [])


async def _standalone(session: Session, rest: list[str]) -> int | None:
    plugin = find(rest[0]) if rest else None
    if plugin is None:
        session.print_error(f"{USAGE}\nrqt: error: there is no plugin {rest[0]!r}" if rest else USAGE)
        return 2
    return await _go_on(session, plugin, [word for word in rest[1:] if word != "--args"])


async def _go_on(session: Session, plugin: Plugin, words: list[str]) -> int | None:
    from day6_tui.core.ros.programs import load

    return await session.execute(load(plugin.package, plugin.package), [plugin.package, *words])
