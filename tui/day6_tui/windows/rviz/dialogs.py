"""The dialogs over the RViz window: choosing a value, typing one, adding a display, files."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.reason import reason
from day6_core.ros.programs.rviz2.model.config import ConfigError, write_config
from day6_core.ros.programs.rviz2.model.display import Display
from day6_core.ros.programs.rviz2.model.displays import TYPES
from day6_core.ros.programs.rviz2.model.properties import ENUM, FRAME, TOPIC, BadValue, Property
from day6_core.ros.programs.rviz2.model.views import SavedView
from day6_core.whole_file import replace_file
from day6_tui.overlays.menu import Menu, MenuEntry
from day6_tui.overlays.prompt import Prompt, before_replacing
from day6_tui.windows.rviz.tree import MOST_LINES

if TYPE_CHECKING:
    from day6_tui.windows.rviz.rviz2 import RVizPane

WANTED_FIRST = ("RobotModel", "TF")
"""What is added to RViz most often is seen without scrolling."""


def edit(pane: RVizPane, prop: Property) -> None:
    """Choose or type a value."""
    options = list(prop.options) if prop.kind in (ENUM, FRAME, TOPIC) else []
    if options:
        _choose(pane, prop, options)
    else:
        type_value(pane, prop)


def show_menu(pane: RVizPane, choices: list[tuple[str, Callable[[], object]]]) -> None:
    """The menu of an interactive marker."""
    entries = [MenuEntry(title, "", partial(pane.rviz.request, action)) for title, action in choices]
    pane.lay_over(Menu(pane.look, "rviz.choose", entries))


def _choose(pane: RVizPane, prop: Property, options: list[str]) -> None:
    texts = pane.look.texts
    entries = [MenuEntry(option, "", partial(pane.set, prop, option)) for option in options]
    if prop.kind in (FRAME, TOPIC):
        entries.append(MenuEntry(texts("rviz.type_it"), "", partial(type_value, pane, prop)))
    chosen = options.index(prop.value) if prop.value in options else 0
    pane.lay_over(Menu(pane.look, "rviz.choose", entries, chosen=chosen))


def type_value(pane: RVizPane, prop: Property) -> None:
    """Type a value in its place; a wrong one is explained in the status bar and the line stays open."""

    def taken(text: str) -> str | None:
        try:
            pane.rviz.edit_text(prop, text)
        except BadValue as error:
            complaint = pane.look.texts(error.key, **error.parameters)
            pane.show_message(complaint, 10.0)
            return complaint
        pane.rviz.message = None
        pane.look.wake()
        return None

    pane.panel.type_value(prop, taken)


def find(pane: RVizPane) -> None:
    """Search all lines of the panel, also those of closed branches, and go to one."""
    rviz = pane.rviz
    entries: list[MenuEntry] = []

    def collect(properties: list[Property], above: str) -> None:
        for prop in properties:
            if len(entries) < MOST_LINES and not prop.hidden:
                entries.append(MenuEntry(prop.name, above, partial(pane.choose, prop), words=prop.text))
                collect(prop.children, f"{above} / {prop.name}" if above else prop.name)

    collect(rviz.panels, "")
    pane.lay_over(Menu(pane.look, "rviz.find", entries))


def add(pane: RVizPane) -> None:
    """The Add dialog: every display type, then every topic with the types that show it."""
    rviz, texts = pane.rviz, pane.look.texts

    def add_it(type_name: str, topic: str = "") -> None:
        def work() -> None:
            display = rviz.add_display(type_name, topic)
            pane.app.call_later(pane.choose, display)

        pane.request(work)

    by_topic = texts("rviz.add.by_topic")
    entries = [
        MenuEntry(name, texts(f"rviz.type.{name}"), partial(add_it, name), words=texts("rviz.add.by_type"))
        for name in sorted(TYPES, key=lambda name: name not in WANTED_FIRST)
    ]
    for topic, types in rviz.topics():
        for message_type in types:
            for name in rviz.displays_for(message_type):
                entries.append(MenuEntry(topic, f"{name}  {by_topic}", partial(add_it, name, topic)))
    pane.lay_over(Menu(pane.look, "rviz.add.title", entries))


def rename(pane: RVizPane, thing: Display | SavedView) -> None:
    """Give a display or a saved view another name."""

    def taken(text: str) -> str | None:
        if not text.strip():
            return pane.look.texts("rviz.bad.name")
        rviz, name = pane.rviz, text.strip()
        if isinstance(thing, SavedView):
            pane.request(partial(rviz.rename_view, thing, name))
        else:
            pane.request(partial(rviz.rename_display, thing, name))
        return None

    pane.lay_over(Prompt(pane.look, pane.look.texts("rviz.rename"), thing.name, taken))


# -- files -------------------------------------------------------------------------------------------------------------


def save(pane: RVizPane, then: Callable[[], object] = lambda: None) -> None:
    """Save the configuration where it came from; the first time it becomes the user's default, as in RViz.

    `then` follows once it is saved.
    """
    path = pane.rviz.config_file or pane.rviz.default_file
    if path is None:
        save_as(pane, then)
    else:
        _write(pane, path, then)


def save_as(pane: RVizPane, then: Callable[[], object] = lambda: None) -> None:
    """Save under a name."""

    def taken(text: str) -> str | None:
        name = text.strip()
        if not name:
            return pane.look.texts("rviz.bad.name")
        _write(pane, target(name), then)
        return None

    def target(text: str) -> Path:
        name = text.strip()
        return pane.rviz.path(name if name.endswith(".rviz") else f"{name}.rviz")

    old = str(pane.rviz.config_file or "robot.rviz")
    sure = before_replacing(pane.look, target, taken)
    pane.lay_over(Prompt(pane.look, pane.look.texts("rviz.save_as"), old, sure))


def _write(pane: RVizPane, path: Path, then: Callable[[], object]) -> None:
    rviz, texts = pane.rviz, pane.look.texts

    def work() -> None:
        # On the program's thread, after every change that was requested before.
        try:
            rviz.write_file(path, write_config(rviz.save()))
        except OSError as error:
            text = texts("rviz.not_saved", file=path.name, reason=reason(error))
        else:
            rviz.config_file, rviz.modified = path, False
            text = texts("rviz.saved", file=str(path))
            pane.app.call_later(then)
        pane.app.call_later(pane.show_message, text, 6.0)

    pane.request(work)


def leave(pane: RVizPane) -> None:
    """RViz's question before its window is closed with changes: Save, Discard, Cancel."""
    texts, close = pane.look.texts, pane.window.close_by_user
    path = pane.rviz.config_file or pane.rviz.default_file
    entries = [
        MenuEntry(
            "Save", texts("rviz.leave.save", file=path.name if path is not None else "…"), lambda: save(pane, close)
        ),
        MenuEntry("Discard", texts("rviz.leave.discard"), close),
        MenuEntry("Cancel", texts("rviz.leave.cancel"), lambda: None),
    ]
    pane.lay_over(Menu(pane.look, "rviz.leave.title", entries))


def load(pane: RVizPane) -> None:
    """Load a configuration."""

    def taken(text: str) -> str | None:
        path = pane.rviz.path(text.strip())
        try:
            content = path.read_text(encoding="utf-8", errors="replace")
            read = pane.rviz.check_text(content)
        except (OSError, ConfigError) as error:
            return pane.look.texts("rviz.not_loaded", file=path.name, reason=reason(error))
        pane.request(partial(pane.rviz.load_config, read, path))
        return None

    old = str(pane.rviz.config_file or "")
    pane.lay_over(Prompt(pane.look, pane.look.texts("rviz.load"), old, taken, note=_near(pane)))


def _near(pane: RVizPane) -> str:
    """The .rviz files at hand."""
    try:
        names = sorted(each.name for each in pane.rviz.path(".").glob("*.rviz"))
    except OSError:
        names = []
    return ", ".join(names[:5])


def screenshot(pane: RVizPane) -> None:
    """Save the view as a picture; the suffix determines the format."""

    def taken(text: str) -> str | None:
        from day6_tui.render.image_file import png, svg

        texts, path = pane.look.texts, pane.rviz.path(text.strip())
        if path.suffix not in (".png", ".svg"):
            return texts("rviz.bad.picture")
        try:
            if path.suffix == ".png":
                replace_file(path, png(pane.view.snapshot()))
            else:
                replace_file(path, svg(pane.view.snapshot(240)).encode("utf-8"))
        except OSError as error:
            return texts("rviz.not_saved", file=path.name, reason=reason(error))
        pane.show_message(texts("rviz.saved", file=str(path)))
        return None

    note = pane.look.texts("rviz.picture_note")
    sure = before_replacing(pane.look, lambda text: pane.rviz.path(text.strip()), taken)
    pane.lay_over(Prompt(pane.look, pane.look.texts("rviz.picture"), "rviz.png", sure, note=note))
