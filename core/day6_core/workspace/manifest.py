"""Reads and checks `package.xml`, with the error messages of catkin_pkg, which the real colcon uses."""

from __future__ import annotations

import re
import stat
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from xml.etree import ElementTree

FILE_NAME = "package.xml"
_SCHEMA = re.compile(r"<\?xml-model\s[^>]*href=\"https?://download\.ros\.org/schema/package_format[123]\.xsd\"")

_DEPENDENCIES = frozenset({"build_depend", "buildtool_depend", "test_depend", "conflict", "replace"})
_TAGS = {
    1: _DEPENDENCIES | {"run_depend"},
    2: _DEPENDENCIES | {"build_export_depend", "buildtool_export_depend", "depend", "exec_depend", "doc_depend"},
}
_TAGS[3] = _TAGS[2] | {"group_depend", "member_of_group"}
_OTHER_TAGS = frozenset({"name", "version", "description", "maintainer", "license", "url", "author", "export"})
_MEANT_BY = {
    "build_depend": ("depend",),
    "buildtool_depend": (),
    "build_export_depend": ("depend", "run_depend"),
    "buildtool_export_depend": (),
    "exec_depend": ("depend", "run_depend"),
    "test_depend": (),
    "doc_depend": (),
}
"""Kinds of dependency, and the tags that stand for several of them."""
_UPDATE = (
    ", please update catkin_pkg (e.g. on Ubuntu/Debian use: "
    "sudo apt-get update && sudo apt-get install --only-upgrade python-catkin-pkg)"
)
_VERSION_LIMITS = ("version_lt", "version_lte", "version_eq", "version_gte", "version_gt")


class ManifestError(ValueError):
    """A manifest is invalid. `schema_named` is whether it at least names the ROS schema (then colcon warns)."""

    def __init__(self, path: str, text: str, schema_named: bool) -> None:
        super().__init__(f"Error(s) in package '{path}':\n{text}")
        self.schema_named = schema_named


@dataclass
class Manifest:
    """The parts of a `package.xml` that a build uses."""

    name: str
    version: str
    build_type: str
    maintainers: list[str] = field(default_factory=list)
    """Like 'Lei Li <lei@example.org>'."""
    build_depends: list[str] = field(default_factory=list)
    run_depends: list[str] = field(default_factory=list)
    test_depends: list[str] = field(default_factory=list)
    groups: list[str] = field(default_factory=list)
    """Groups the package is a member of."""
    warnings: list[str] = field(default_factory=list)


def read_manifest(folder: Path, shown: str, environment: Mapping[str, str]) -> Manifest | None:
    """Read `folder/package.xml`; returns None if it does not exist.

    `shown` is the folder as messages name it; `environment` has the variables of conditions like `$ROS_VERSION == 2`.

    Raises:
        ManifestError: it cannot be read, or is invalid.
    """
    try:
        if not stat.S_ISREG((folder / FILE_NAME).stat().st_mode):  # as catkin_pkg; reading a pipe waits for its writer
            return None
        data = (folder / FILE_NAME).read_bytes()
    except (FileNotFoundError, NotADirectoryError, IsADirectoryError):
        return None
    except OSError as error:
        raise ManifestError(f"{shown}/{FILE_NAME}", str(error.strerror), schema_named=True) from error
    path = f"{shown}/{FILE_NAME}"
    try:
        root = parse_xml(data)
    except (ValueError, LookupError) as error:
        # The real one searches for the schema by parsing the same malformed text, and so stays silent.
        raise ManifestError(path, f"The manifest contains invalid XML:\n{error}", schema_named=False) from error
    try:
        return _Reader(root, environment).manifest()
    except _Fault as fault:
        named = bool(_SCHEMA.search(data.decode("utf-8", "replace")))
        failure = ManifestError(path, str(fault), named)
        if isinstance(fault, _BareFault):
            failure.args = (str(fault),)
        raise failure from fault


def parse_xml(data: bytes) -> ElementTree.Element:
    """Parse untrusted XML; a document that defines entities is refused.

    Raises:
        ValueError: the data is not XML, or defines entities.
    """
    if b"<!ENTITY" in data:
        raise ValueError("entities are not allowed")
    try:
        return ElementTree.fromstring(data)
    except ElementTree.ParseError as error:
        raise ValueError(error) from error


class _Fault(ValueError):
    pass


class _BareFault(_Fault):
    """A fault that catkin_pkg reports without the file's name."""


class _Reader:
    def __init__(self, root: ElementTree.Element, environment: Mapping[str, str]) -> None:
        if root.tag != "package":
            raise _Fault('The manifest must contain a single "package" root tag')
        self.root = root
        self.environment = environment
        text = root.get("format", "1")
        self.format = int(text) if text.isdigit() else 0
        if self.format not in (1, 2, 3):
            raise _BareFault(f"Unable to handle package.xml format version '{text}'{_UPDATE}")

    def manifest(self) -> Manifest:
        name, version = self._one("name"), self._one("version")
        description = self._one("description")
        people = [node for node in self.root if node.tag == "maintainer"]
        if any(person.get("email") is None for person in people):
            raise _BareFault('The "maintainer" tag must have the attribute "email"')
        self._check_tags(name)
        manifest = Manifest(
            name,
            version,
            self._build_type(),
            maintainers=[f"{_text(node)} <{node.get('email')}>" for node in people if node.get("email")],
            build_depends=self._depends("build_depend", "depend", "buildtool_depend"),
            run_depends=self._depends(
                "build_export_depend", "depend", "buildtool_export_depend", "exec_depend", "run_depend"
            ),
            test_depends=self._depends("test_depend"),
            groups=self._depends("member_of_group"),
        )
        self._check_values(manifest, description, people)
        return manifest

    def _one(self, tag: str) -> str:
        nodes = [node for node in self.root if node.tag == tag]
        if len(nodes) != 1:
            raise _Fault(f'The manifest must contain exactly one "{tag}" tag')
        return _text(nodes[0])

    def _conditioned(self, *tags: str) -> Iterator[ElementTree.Element]:
        for tag in tags:
            for node in self.root:
                if node.tag == tag and _is_met(node.get("condition"), self.environment):
                    yield node

    def _depends(self, *tags: str) -> list[str]:
        return list(dict.fromkeys(_text(node) for node in self._conditioned(*tags)))

    def _build_type(self) -> str:
        exports = [
            node for export in self.root if export.tag == "export" for node in export if node.tag == "build_type"
        ]
        types = [_text(node) for node in exports if _is_met(node.get("condition"), self.environment)]
        if len(types) > 1:
            raise _Fault("Only one <build_type> element is permitted.")
        return types[0] if types else "catkin"

    def _check_tags(self, name: str) -> None:
        known = _TAGS[self.format] | _OTHER_TAGS
        errors = self._redundant()
        unknown = list(dict.fromkeys(node.tag for node in self.root if node.tag not in known))
        if unknown:
            errors.append(
                f'The manifest of package "{name}" (with format version {self.format}) must not contain the following tags: '
                + ", ".join(unknown)
            )
        if "run_depend" in unknown and self.format >= 2:
            errors.append("Please replace <run_depend> tags with <exec_depend> tags.")
        elif "exec_depend" in unknown and self.format < 2:
            errors.append("Either update to a newer format or replace <exec_depend> tags with <run_depend> tags.")
        for node in self.root:
            if node.tag not in known:
                continue
            unknown_attributes = [attribute for attribute in node.attrib if attribute not in self._attributes(node.tag)]
            if unknown_attributes:
                errors.append(
                    f'The "{node.tag}" tag must not have the following attributes: {", ".join(unknown_attributes)}'
                )
            if len(node) and node.tag not in ("description", "export"):
                children = ", ".join(child.tag for child in node)
                errors.append(f'The "{node.tag}" tag must not contain the following children: {children}')
        if errors:
            raise _Fault("Error(s):" + "".join(f"\n- {error}" for error in errors))

    def _attributes(self, tag: str) -> tuple[str, ...]:
        if tag in ("group_depend", "member_of_group"):
            return ("condition",)
        if tag in _TAGS[self.format]:
            return (*_VERSION_LIMITS, "condition") if self.format > 2 else _VERSION_LIMITS
        allowed = {"version": "compatibility", "maintainer": "email", "author": "email", "url": "type"}
        if tag == "license" and self.format > 2:
            return ("file",)
        return (allowed[tag],) if tag in allowed else ()

    def _redundant(self) -> list[str]:
        errors = []
        for node in self.root:
            if node.tag == "depend" and self.format > 1:
                same = [
                    tag
                    for tag in ("build_depend", "build_export_depend", "exec_depend")
                    for other in self.root
                    if other.tag == tag and _text(other) == _text(node) and other.attrib == node.attrib
                ]
                if same:
                    errors.append(f"The generic dependency on '{_text(node)}' is redundant with: {', '.join(same)}")
        return errors

    def _check_values(self, manifest: Manifest, description: str, people: list[ElementTree.Element]) -> None:
        name, version = manifest.name, manifest.version
        errors = []
        if not name:
            errors.append("Package name must not be empty")
        if not re.fullmatch(r"[a-zA-Z0-9][a-zA-Z0-9_-]*", name):
            errors.append(f'Package name "{name}" does not follow naming conventions')
        elif not re.fullmatch(r"[a-z][a-z0-9_-]*", name):
            manifest.warnings.append(
                f'Package name "{name}" does not follow the naming conventions. It should start with a lower case letter '
                "and only contain lower case letters, digits, underscores, and dashes."
            )
        if not version:
            errors.append("Package version must not be empty")
        elif not re.fullmatch(r"\d+\.\d+\.\d+", version):
            errors.append(f'Package version "{version}" does not follow version conventions')
        if not description:
            errors.append("Package description must not be empty")
        if not people:
            errors.append(f"Package '{name}' must declare at least one maintainer")
        for person in people:
            email = person.get("email") or ""
            if not email:
                errors.append("Maintainers must have an email address")
            if not re.fullmatch(
                r"[-a-zA-Z0-9_%+]+(\.[-a-zA-Z0-9_%+]+)*@[-a-zA-Z0-9%]+(\.[-a-zA-Z0-9%]+)*\.[a-zA-Z]{2,}", email
            ):
                errors.append(f'Invalid email "{email}" for person "{_text(person)}"')
        licenses = [_text(node) for node in self.root if node.tag == "license"]
        if not licenses:
            errors.append('The package node must contain at least one "license" tag')
        if any(not each for each in licenses):
            errors.append("The license tag must neither be empty nor only contain whitespaces")
        own = {node.tag for node in self.root if isinstance(node.tag, str) and _text(node) == name}
        errors += [
            f'The package "{name}" must not "{kind}" on a package with the same name as this package'
            for kind, tags in _MEANT_BY.items()
            if own & {kind, *tags}
        ]
        if errors:
            raise _Fault("\n".join(errors))


def _text(node: ElementTree.Element) -> str:
    return "".join(node.itertext()).strip()


_CONDITION = re.compile(r"\s*(\$\w+|\"[^\"]*\"|'[^']*'|[\w.]+|==|!=|<=|>=|<|>|\(|\))")


def _is_met(condition: str | None, environment: Mapping[str, str]) -> bool:
    """Evaluate a REP 149 condition like `$ROS_VERSION == 2 and $ROS_DISTRO != "humble"`; no condition is always met."""
    if not condition:
        return True
    tokens: list[str] = []
    at = 0
    while condition[at:].strip():
        match = _CONDITION.match(condition, at)
        if match is None:
            raise _Fault(f'condition "{condition}" failed to parse')
        tokens.append(match.group(1))
        at = match.end()
    value = _any_of(tokens, environment, condition)
    if tokens:
        raise _Fault(f'condition "{condition}" failed to parse')
    return value


def _any_of(tokens: list[str], environment: Mapping[str, str], whole: str) -> bool:
    value = _all_of(tokens, environment, whole)
    while tokens and tokens[0] == "or":
        tokens.pop(0)
        value = _all_of(tokens, environment, whole) or value
    return value


def _all_of(tokens: list[str], environment: Mapping[str, str], whole: str) -> bool:
    value = _comparison(tokens, environment, whole)
    while tokens and tokens[0] == "and":
        tokens.pop(0)
        value = _comparison(tokens, environment, whole) and value
    return value


def _comparison(tokens: list[str], environment: Mapping[str, str], whole: str) -> bool:
    if tokens and tokens[0] == "(":
        tokens.pop(0)
        value = _any_of(tokens, environment, whole)
        if not tokens or tokens.pop(0) != ")":
            raise _Fault(f'condition "{whole}" failed to parse')
        return value
    if len(tokens) < 3:
        raise _Fault(f'condition "{whole}" failed to parse')
    left, operator, right = (tokens.pop(0) for _ in range(3))
    one, other = (
        environment.get(each[1:], "") if each.startswith("$") else each.strip("\"'") for each in (left, right)
    )
    results = {
        "==": one == other,
        "!=": one != other,
        "<": one < other,
        "<=": one <= other,
        ">": one > other,
        ">=": one >= other,
    }
    if operator not in results:
        raise _Fault(f'condition "{whole}" failed to parse')
    return results[operator]
