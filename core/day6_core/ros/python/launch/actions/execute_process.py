"""Runs a command."""

from __future__ import annotations

import shlex
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, List  # noqa: UP035

from launch.actions.execute_local import ExecuteLocal
from launch.actions.shutdown_action import Shutdown
from launch.descriptions.executable import Executable
from launch.frontend.entity import Entity
from launch.frontend.expose import expose_action
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.substitutions.text_substitution import TextSubstitution

if TYPE_CHECKING:
    from launch.frontend.parser import Parser

_TEXTS = {"cwd": "cwd", "name": "name", "launch-prefix": "prefix", "output": "output", "respawn": "respawn"}
_SECONDS = ("respawn_delay", "sigkill_timeout", "sigterm_timeout")
_OTHERS: dict[str, type] = {"respawn_max_retries": int, "shell": bool, "emulate_tty": bool}


@expose_action("executable")
class ExecuteProcess(ExecuteLocal):
    """Runs `cmd`, a list of words that may each consist of several substitutions. The rest is as in `ExecuteLocal`."""

    def __init__(
        self,
        *,
        cmd: Iterable[SomeSubstitutionsType],
        prefix: SomeSubstitutionsType | None = None,
        name: SomeSubstitutionsType | None = None,
        cwd: SomeSubstitutionsType | None = None,
        env: Mapping[SomeSubstitutionsType, SomeSubstitutionsType] | None = None,
        additional_env: Mapping[SomeSubstitutionsType, SomeSubstitutionsType] | None = None,
        **kwargs: Any,
    ) -> None:
        executable = Executable(cmd=cmd, prefix=prefix, name=name, cwd=cwd, env=env, additional_env=additional_env)
        super().__init__(process_description=executable, **kwargs)

    @classmethod
    def parse(cls, entity: Entity, parser: Parser, ignore: Iterable[str] = ()) -> tuple[Any, dict[str, Any]]:
        """Read the attributes of the tag `executable`, except those in `ignore`, which a derived tag reads itself."""
        _, keywords = super().parse(entity, parser)
        if "cmd" not in ignore:
            keywords["cmd"] = cls._parse_cmdline(entity.get_attr("cmd"), parser)
        for attribute, keyword in _TEXTS.items():
            text = entity.get_attr(attribute, optional=True) if keyword not in ignore else None
            if text is not None:
                keywords[keyword] = parser.parse_substitution(text)
        for attribute in _SECONDS:
            seconds = entity.get_attr(attribute, data_type=float, optional=True) if attribute not in ignore else None
            if seconds is None:
                continue
            if seconds < 0.0:
                raise ValueError(
                    f"Attribute {attribute} of Entity node expected to be a non-negative value but got `{seconds}`"
                )
            keywords[attribute] = seconds if attribute == "respawn_delay" else str(seconds)
        for attribute, kind in _OTHERS.items():
            value = entity.get_attr(attribute, data_type=kind, optional=True) if attribute not in ignore else None
            if value is not None:
                keywords[attribute] = value
        on_exit = entity.get_attr("on_exit", optional=True) if "on_exit" not in ignore else None
        if on_exit is not None:
            if on_exit != "shutdown":
                raise ValueError(
                    f"Attribute on_exit of Entity node expected to be shutdown but got `{on_exit}`"
                    "Other on_exit actions not yet supported"
                )
            keywords["on_exit"] = [Shutdown()]
        if "additional_env" not in ignore:
            env = entity.get_attr("env", data_type=List[Entity], optional=True)  # noqa: UP006
            if env is not None:
                keywords["additional_env"] = _environment(env, parser)
        return cls, keywords

    @classmethod
    def _parse_cmdline(cls, cmd: str, parser: Parser) -> list[SomeSubstitutionsType]:
        """Split a text with substitutions into words as a shell does; a substitution's value is never split."""
        words: list[list[Substitution]] = [[]]
        for part in parser.parse_substitution(cmd):
            if not isinstance(part, TextSubstitution):
                words[-1].append(part)
                continue
            text = part.text
            if text[:1].isspace() and words[-1]:
                words.append([])
            for number, word in enumerate(shlex.split(text)):
                if number:
                    words.append([])
                words[-1].append(TextSubstitution(text=word))
            if text[-1:].isspace() and words[-1]:
                words.append([])
        return [word for word in words if word]

    @property
    def name(self) -> Any:
        return self.process_description.final_name or self.process_description.name

    @property
    def cmd(self) -> Any:
        final = self.process_description.final_cmd
        return self.process_description.cmd if final is None else final

    @property
    def cwd(self) -> Any:
        final = self.process_description.final_cwd
        return self.process_description.cwd if final is None else final

    @property
    def env(self) -> Any:
        final = self.process_description.final_env
        return self.process_description.env if final is None else final

    @property
    def additional_env(self) -> Any:
        return self.process_description.additional_env


def _environment(entities: Iterable[Entity], parser: Parser) -> dict[Any, Any]:
    found = {}
    for each in entities:
        name = tuple(parser.parse_substitution(each.get_attr("name")))
        found[name] = parser.parse_substitution(each.get_attr("value"))
        each.assert_entity_completely_parsed()
    return found
