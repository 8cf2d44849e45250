"""Makes the modules of commands and verbs when they are imported: `ros2topic.verb.info` with `InfoVerb`, around ours."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from collections.abc import Sequence
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec
from types import ModuleType
from typing import Any

from day6_core.ros.ros2.cli import tree


class _Finder(MetaPathFinder):
    def find_spec(
        self, name: str, path: Sequence[str] | None = None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        found = _place(name)
        return ModuleSpec(name, _Loader(*found), origin="day6-tui") if found is not None else None


def _place(name: str) -> tuple[str, str | None] | None:
    """Return command and verb of `ros2topic.verb.echo` or `ros2topic.command.topic` (no verb), None for other names."""
    where, _, word = name.rpartition(".")
    where = where.replace("ros2cli.verb.daemon", "ros2daemon.verb").replace("ros2cli.command", "ros2daemon.command")
    package, _, kind = where.partition(".")
    command = package.removeprefix("ros2")
    if command == package or command not in tree.command_names():
        return None
    if kind == "verb" and word in tree.verb_names(command):
        return command, word
    return (command, None) if kind == "command" and word == command else None


class _Loader(Loader):
    def __init__(self, command: str, verb: str | None) -> None:
        self._command = command
        self._verb = verb

    def exec_module(self, module: ModuleType) -> None:
        ours = tree.load(self._command, self._verb)
        module.__doc__ = ours.SUMMARY
        names = getattr(ours, "EXPORTS", {})
        module.__dict__.update(names)
        kind = "Command" if self._verb is None else "Verb"
        word = self._verb or self._command
        title = "".join(part.capitalize() for part in word.split("_")) + kind
        base = sys.modules["ros2cli.command"].CommandExtension if self._verb is None else _verb_base(module.__name__)
        made = type(title, (base,), {**_methods(self._command, self._verb), "__doc__": ours.SUMMARY})
        made.__module__ = module.__name__
        setattr(module, title, made)


def _verb_base(name: str) -> Any:
    from importlib import import_module

    return import_module(name.rpartition(".")[0]).VerbExtension


def _methods(command: str, verb: str | None) -> dict[str, Any]:
    from day6_core.ros.ros2.cli.embedded import run_verb

    def add_arguments(self: object, parser: ArgumentParser, cli_name: str, **_: object) -> None:
        module = tree.load(command, verb)
        if hasattr(module, "add_arguments"):
            module.add_arguments(parser)

    def main(self: object, *, args: Namespace, parser: object = None, **more: object) -> str | int | None:
        return run_verb(command, verb, Namespace(**{**vars(args), **more}))

    return {"add_arguments": add_arguments, "main": main}


def install() -> None:
    """Let the modules be found, once."""
    if not any(isinstance(finder, _Finder) for finder in sys.meta_path):
        sys.meta_path.append(_Finder())
