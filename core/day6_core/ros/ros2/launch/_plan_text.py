"""The plan of a launch as lines to read, at most 80 columns, in a language."""

from __future__ import annotations

import shlex
from collections.abc import Iterable, Iterator
from itertools import groupby
from typing import Any

from day6_core.command_line.texts import CommandTexts, Wording
from day6_core.width import text_width
from day6_core.wrapping import wrap

WIDTH = 80
_INDENT = 2


def lines_of(plan: dict[str, Any], language: str) -> Iterator[str]:
    """Yield the lines of what `plan_of` returns."""
    yield from _Lines(CommandTexts(language)).of(plan)


class _Lines:
    def __init__(self, texts: Wording) -> None:
        self._texts = texts

    def _text(self, key: str, **values: object) -> str:
        return self._texts(f"cli.launch-plan.{key}", **values)

    def of(self, plan: dict[str, Any]) -> Iterator[str]:
        yield from self._row(0, "file", plan["file"])
        for file in plan["includes"]:
            yield from self._row(_INDENT, "includes", file)
        if plan["arguments"]:
            yield ""
            yield self._text("arguments")
        for argument in plan["arguments"]:
            origin = self._text(argument["origin"])
            yield from _wrapped(_INDENT, f"{argument['name']} := {_value(argument['value'])}  ({origin})")
        for when, items in groupby(plan["items"], lambda item: item.get("when", [])):
            yield ""
            yield from _wrapped(0, self._when(when))
            for item in items:
                yield from self._item(item)
        if not plan["items"] and not plan["error"]:
            yield ""
            yield self._text("nothing")
        if plan["error"]:
            yield ""
            yield from _wrapped(0, self._text("fails", error=plan["error"]))

    def _when(self, triggers: list[dict[str, Any]]) -> str:
        return self._text("then").join(map(self._trigger, triggers)) if triggers else self._text("at_once")

    def _trigger(self, trigger: dict[str, Any]) -> str:
        if trigger["wait"] == "timer":
            return self._text(f"timer.{trigger['clock']}", seconds=f"{trigger['seconds']:g}")
        who = trigger.get("of")
        name = self._text("anyone") if who is None else who or self._text("someone")
        return self._text(f"wait.{trigger['wait']}", name=name, text=trigger.get("text") or self._text("other_event"))

    def _item(self, item: dict[str, Any]) -> Iterator[str]:
        kind = item["kind"]
        if kind == "node":
            yield from self._node(item)
        elif kind == "process":
            yield from _wrapped(_INDENT, self._text("process", name=item["process"]))
            yield from self._process(item)
        elif kind == "components":
            yield from _wrapped(_INDENT, self._text("components", name=item["container"]))
            yield from self._components(item["components"])
        elif kind == "left_out":
            what = ", ".join(item["entities"]) or self._text("something")
            yield from _wrapped(_INDENT, self._text("left_out", what=what, why=self._condition(item["condition"])))
        elif kind == "cannot_start":
            yield from _wrapped(
                _INDENT, self._text("cannot_start", what=", ".join(item["entities"]), why=item["error"])
            )
        elif kind == "transitions":
            nodes, steps = ", ".join(item["nodes"]), ", ".join(item["steps"])
            yield from _wrapped(_INDENT, self._text("transitions", nodes=nodes, steps=steps))
        elif kind == "event":
            reason = f" ({item['reason']})" if "reason" in item else ""
            ends = item["event"] == "launch.events.Shutdown"
            yield from _wrapped(_INDENT, self._text("ends" if ends else "event", name=item["event"]) + reason)
        else:
            yield from _wrapped(_INDENT, self._text(f"unknown.{item['why']}", error=item.get("error", "")))

    def _condition(self, condition: dict[str, Any]) -> str:
        return self._text("condition", **condition) if "value" in condition else condition["text"]

    def _node(self, item: dict[str, Any]) -> Iterator[str]:
        name = item["name"] or self._text("unnamed", namespace=item["namespace"])
        yield from _wrapped(_INDENT, self._text("container" if "components" in item else "node", name=name))
        program = " ".join(item[key] for key in ("package", "executable") if key in item)
        yield from self._row(2 * _INDENT, "program", f"{program}  ({item['process']})")
        if "prefix" in item:
            yield from self._row(2 * _INDENT, "prefix", shlex.join(item["prefix"]))
        if "lifecycle" in item:
            yield from self._row(2 * _INDENT, "state", item["lifecycle"])
        if "refused" in item:
            yield from self._row(2 * _INDENT, "refused", item["refused"])
        yield from self._settings(2 * _INDENT, item)
        for key in ("other_nodes", "if_named"):
            for other in item.get(key, ()):
                source = other["source"] or self._text("launch_file")
                yield from _wrapped(2 * _INDENT, self._text(key, node=other["node"], source=source))
        if item["arguments"]:
            yield from self._row(2 * _INDENT, "argument", shlex.join(item["arguments"]))
        for words in item.get("ros_arguments", ()):
            yield from self._row(2 * _INDENT, "argument", words)
        yield from self._process(item, with_command=False)
        yield from self._components(item.get("components", ()))

    def _settings(self, indent: int, item: dict[str, Any]) -> Iterator[str]:
        for parameter in item.get("parameters", ()):
            source = parameter["source"] or self._text("launch_file")
            yield from self._row(indent, "parameter", f"{parameter['name']} = {_value(parameter['value'])}  ({source})")
        for rule in item.get("remaps", ()):
            yield from self._row(indent, "remap", rule)

    def _process(self, item: dict[str, Any], *, with_command: bool = True) -> Iterator[str]:
        if with_command:
            yield from self._row(2 * _INDENT, "command", shlex.join(item["command"]))
        if "folder" in item:
            yield from self._row(2 * _INDENT, "folder", item["folder"])
        for name, value in item["environment"].items():
            yield from self._row(2 * _INDENT, "variable", f"{name}={value}")
        if "respawn" in item:
            yield from _wrapped(2 * _INDENT, self._text("respawn"))

    def _components(self, components: Iterable[dict[str, Any]]) -> Iterator[str]:
        for each in components:
            name = each["name"] or self._text("unnamed_component")
            yield from _wrapped(2 * _INDENT, self._text("component", name=name))
            yield from self._row(3 * _INDENT, "program", f"{each['package']} {each['plugin']}")
            yield from self._settings(3 * _INDENT, each)

    def _row(self, indent: int, key: str, text: str) -> Iterator[str]:
        return _wrapped(indent, self._text("row", label=self._text(f"row.{key}"), text=text))


def _value(value: object) -> str:
    """A value in a line: strings that could be something else are quoted, long ones are cut."""
    text = repr(value) if not isinstance(value, str) or value == "" or value != value.strip() else value
    text = text.replace("\n", " ")
    return text if len(text) <= MOST else f"{text[:MOST]}… ({len(text):,})"


MOST = 120
"""Characters of a value (a robot's description has thousands); `--json` has all of them."""


def _wrapped(indent: int, text: str) -> Iterator[str]:
    first, *others = wrap(text, WIDTH - indent - _INDENT, text_width)
    yield " " * indent + first
    yield from (" " * (indent + _INDENT) + each for each in others)
