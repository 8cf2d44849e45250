"""Reads and checks `package.xml` with catkin_pkg, as the real colcon does."""

from __future__ import annotations

import stat
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

FILE_NAME = "package.xml"


class ManifestError(ValueError):
    """A manifest is invalid. `schema_named` is whether it at least names the ROS schema (then colcon warns)."""

    def __init__(self, text: str, schema_named: bool) -> None:
        super().__init__(text)
        self.schema_named = schema_named


@dataclass
class Manifest:
    """The parts of a `package.xml` that a build uses."""

    name: str
    version: str
    build_type: str
    maintainers: list[str]
    """Like 'Lei Li <lei@example.org>'."""
    build_depends: list[str]
    run_depends: list[str]
    test_depends: list[str]
    groups: list[str]
    """Groups the package is a member of."""
    warnings: list[str]


def read_manifest(folder: Path, shown: str, environment: Mapping[str, str]) -> Manifest | None:
    """Read `folder/package.xml`; returns None if it does not exist.

    `shown` is the folder as messages name it; `environment` has the variables of conditions like `$ROS_VERSION == 2`.

    Raises:
        ManifestError: it cannot be read, or is invalid.
    """
    path = f"{shown}/{FILE_NAME}"
    try:
        if not stat.S_ISREG((folder / FILE_NAME).stat().st_mode):  # as catkin_pkg; reading a pipe waits for its writer
            return None
        text = (folder / FILE_NAME).read_text(encoding="utf-8")
    except (FileNotFoundError, NotADirectoryError, IsADirectoryError):
        return None
    except OSError as error:
        raise ManifestError(f"Error(s) in package '{path}':\n{error.strerror}", schema_named=True) from error
    except UnicodeDecodeError as error:
        raise _malformed(path, error) from error
    return _parsed(text, path, environment)


def _parsed(text: str, path: str, environment: Mapping[str, str]) -> Manifest:
    # Its parser of conditions takes about as long to import as all of ours, and most commands read no manifest.
    from catkin_pkg.package import InvalidPackage, has_ros_schema_reference_string, parse_package_string

    if "<!ENTITY" in text:  # catkin_pkg would expand them
        raise _malformed(path, "entities are not allowed")
    warnings: list[str] = []
    try:
        package = parse_package_string(text, path, warnings)
        package.evaluate_conditions(environment)
        build_type = package.get_build_type()
    except (AssertionError, InvalidPackage, ValueError) as error:
        try:
            schema_named = has_ros_schema_reference_string(text)
        except AttributeError:  # its `href` has single quotes, or is missing
            schema_named = False
        raise ManifestError(str(error), schema_named) from error
    except RecursionError as error:
        raise _malformed(path, "the tags are nested too deeply") from error
    return Manifest(
        package.name,
        package.version,
        build_type,
        maintainers=[str(person) for person in package.maintainers],
        build_depends=_met(package.build_depends, package.buildtool_depends),
        run_depends=_met(package.build_export_depends, package.buildtool_export_depends, package.exec_depends),
        test_depends=_met(package.test_depends),
        groups=_met(package.member_of_groups),
        warnings=warnings,
    )


def _met(*dependencies: Iterable[Any]) -> list[str]:
    """Return the names of those whose condition holds, each once."""
    return list(dict.fromkeys(each.name for some in dependencies for each in some if each.evaluated_condition))


def _malformed(path: str, reason: object) -> ManifestError:
    """Return the error of a text that is no XML, in which no schema is found either."""
    return ManifestError(
        f"Error(s) in package '{path}':\nThe manifest contains invalid XML:\n{reason}", schema_named=False
    )
