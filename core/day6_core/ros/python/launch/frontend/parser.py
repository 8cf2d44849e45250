"""Reads XML and YAML launch files into launch descriptions."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, TextIO

from launch._entry_points import load_extensions, load_parsers
from launch.frontend.entity import Entity
from launch.frontend.parse_substitution import (
    parse_if_substitutions,
    parse_substitution,
    replace_escaped_characters,
)
from launch.invalid_launch_file_error import InvalidLaunchFileError

if TYPE_CHECKING:
    from launch.action import Action
    from launch.launch_description import LaunchDescription
    from launch.substitution import Substitution


class InvalidFrontendLaunchFileError(InvalidLaunchFileError):
    """Raised when a file can't be read in any language of launch files."""


class Parser:
    """Base of the parsers of `launch_xml` and `launch_yaml`; its class methods select one of them."""

    frontend_parsers: dict[str, type[Parser]] | None = None

    @classmethod
    def load_parser_implementations(cls) -> None:
        """Import the parsers."""
        if Parser.frontend_parsers is None:
            Parser.frontend_parsers = load_parsers()

    @classmethod
    def load_launch_extensions(cls) -> None:
        """Import the modules that expose tags and substitutions."""
        load_extensions()

    @classmethod
    def _parsers(cls) -> dict[str, type[Parser]]:
        cls.load_parser_implementations()
        return Parser.frontend_parsers or {}

    @classmethod
    def get_available_extensions(cls) -> list[str]:
        """Return the names of the languages."""
        return list(cls._parsers())

    @classmethod
    def get_file_extensions(cls) -> set[str]:
        """The file name extensions of this parser's language."""
        return set()

    @classmethod
    def get_file_extensions_from_parsers(cls) -> set[str]:
        """Return the file name extensions of all languages."""
        return {extension for parser in cls._parsers().values() for extension in parser.get_file_extensions()}

    @classmethod
    def may_parse(cls, filename: str) -> bool:
        """Return whether a file has an extension of this parser's language."""
        return any(filename.endswith(f".{extension}") for extension in cls.get_file_extensions())

    @classmethod
    def is_filename_valid(cls, filename: str) -> bool:
        """Return whether a file has an extension of any language."""
        return any(parser.may_parse(filename) for parser in cls._parsers().values())

    @classmethod
    def get_parsers_from_filename(cls, filename: str) -> list[type[Parser]]:
        """Return the parsers whose extensions fit a file."""
        return [parser for parser in cls._parsers().values() if parser.may_parse(filename)]

    @classmethod
    def load(cls, file: str | bytes | os.PathLike[str] | TextIO) -> tuple[Entity, Parser]:
        """Return the root of a launch file and its parser; the languages that fit its extension are tried first."""
        if isinstance(file, (str, bytes, os.PathLike)):
            with open(file, encoding="utf-8") as opened:
                return cls.load(opened)
        name = str(getattr(file, "name", ""))
        fitting = cls.get_parsers_from_filename(name)
        errors: list[Exception] = []
        for parser in [*fitting, *(each for each in cls._parsers().values() if each not in fitting)]:
            try:
                return parser.load(file)
            except Exception as error:
                errors.append(error)
                file.seek(0)
        extension = os.path.splitext(name)[1][1:] if fitting else ""
        raise InvalidFrontendLaunchFileError(extension, likely_errors=errors)

    def parse_action(self, entity: Entity) -> Action:
        """Return the action of a tag."""
        from launch.frontend.expose import instantiate_action

        self.load_launch_extensions()
        return instantiate_action(entity, self)

    def parse_substitution(self, value: str) -> list[Substitution]:
        """Return the substitutions in a text. Raises UnexpectedInput, VisitError."""
        self.load_launch_extensions()
        return parse_substitution(value)

    def parse_if_substitutions(self, value: Any) -> Any:
        """Return a value with its substitutions parsed; see `parse_substitution.parse_if_substitutions`."""
        self.load_launch_extensions()
        return parse_if_substitutions(value)

    def escape_characters(self, value: str) -> str:
        """Remove the backslashes that escape characters."""
        return replace_escaped_characters(value)

    def parse_description(self, entity: Entity) -> LaunchDescription:
        """Return the launch description of a file's root."""
        from launch.launch_description import LaunchDescription

        if entity.type_name != "launch":
            raise RuntimeError("Expected 'launch' as root tag")
        deprecated = entity.get_attr("deprecated", optional=True)
        return LaunchDescription([self.parse_action(child) for child in entity.children], deprecated_reason=deprecated)
