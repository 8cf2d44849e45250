"""`day6-tui env --vscode` and `--pycharm`: settings for an editor: ROS imports resolve, and its Run button joins the desktop.

Existing settings stay; ours are added, and replaced when this is run again. The stubs of the interfaces, half
a megabyte that every project shares, lie in the user's data folder.
"""

from __future__ import annotations

import json
import os
import re
import sys
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

from day6_core.command_line.texts import CommandTexts, Wording
from day6_core.places import data_folder
from day6_core.ros.distribution import DEFAULT, current
from day6_core.ros.environment import program_environment, python_folders
from day6_core.shell.outward.jsonc import parse, set_keys, spans
from day6_core.whole_file import replace_file

LAUNCH_NAME = "day6: this Python file"
_SHELL_OF = {"win32": "windows", "darwin": "osx"}


class NotUnderstood(ValueError):
    """A file of the user's editor that cannot be parsed; it was left as it is."""

    def __init__(self, file: Path, reason: object) -> None:
        self._values = {"file": file, "reason": reason}
        super().__init__(self.said(CommandTexts("en")))

    def said(self, texts: Wording) -> str:
        """Say so in the language of the texts."""
        return texts("cli.env.not_understood", **self._values)


def variables() -> dict[str, str]:
    """The variables for an editor's programs: our packages on the path, ROS's variables, this terminal's workspace and domain."""
    env = program_environment()
    names = [
        "PYTHONPATH",
        *sorted(name for name in env if name.startswith(("ROS_", "AMENT_PREFIX_PATH", "DAY6_RUNTIME_DIR"))),
    ]
    return {name: env[name] for name in names}


def write_stubs(folder: Path) -> int:
    """Write the stubs of every interface package, including those of a sourced workspace; return their number."""
    from day6_core.interfaces import packages
    from day6_core.interfaces.stubs import package_stubs

    count = 0
    for package in packages():
        for path, text in package_stubs(package).items():
            file = folder / path
            file.parent.mkdir(parents=True, exist_ok=True)
            replace_file(file, text.encode("utf-8"), sync=False)
        count += 1
    return count


def stub_folder() -> Path:
    """The folder of the stubs; another distribution than the usual one has one of its own."""
    return data_folder() / ("stubs" if current() == DEFAULT else f"stubs-{current()}")


# -- VS Code -----------------------------------------------------------------------------------------------------------


def write_vscode(project: Path, stubs: Path) -> list[Path]:
    """Write .vscode/settings.json, .vscode/launch.json and .env; return them.

    Raises OSError, and NotUnderstood when an existing file cannot be parsed.
    """
    folder = project / ".vscode"
    folder.mkdir(exist_ok=True)
    settings, launch, env_file = folder / "settings.json", folder / "launch.json", project / ".env"
    _change(settings, lambda text: _vscode_settings(text, stubs))
    _change(launch, _vscode_launch)
    _change(env_file, _dot_env)
    return [settings, launch, env_file]


def _vscode_settings(text: str, stubs: Path) -> str:
    present = parse(text) if text.strip() else {}
    if not isinstance(present, dict):
        raise ValueError("it isn't an object")
    system = f"terminal.integrated.env.{_SHELL_OF.get(sys.platform, 'linux')}"
    values: dict[str, Any] = {
        "python.analysis.extraPaths": _with_ours(
            present.get("python.analysis.extraPaths"), [str(stubs), *python_folders()]
        ),
        system: {**(present.get(system) or {}), **variables()},
    }
    # These stay as they are if the user has set them.
    values.setdefault("python.envFile", present.get("python.envFile", "${workspaceFolder}/.env"))
    values.setdefault("python.defaultInterpreterPath", present.get("python.defaultInterpreterPath", sys.executable))
    return set_keys(text, values)


def _vscode_launch(text: str) -> str:
    ours = {
        "name": LAUNCH_NAME,
        "type": "debugpy",
        "request": "launch",
        "program": "${file}",
        "console": "integratedTerminal",
        "python": sys.executable,
        "env": variables(),
    }
    text = set_keys(text, {} if text.strip() and "version" in parse(text) else {"version": "0.2.0"})
    present = parse(text).get("configurations", [])
    names = [each.get("name") for each in present]
    if LAUNCH_NAME in names:
        if present[names.index(LAUNCH_NAME)] == ours:
            return text
        present[names.index(LAUNCH_NAME)] = ours
        return set_keys(text, {"configurations": present})
    if not present:
        return set_keys(text, {"configurations": [ours]})
    at = spans(text)["configurations"].start + 1
    new = json.dumps(ours, indent=4, ensure_ascii=False).replace("\n", "\n        ")
    return f"{text[:at]}\n        {new},{text[at:]}"


def _dot_env(text: str) -> str:
    """`.env` with our variables; other lines stay, other folders stay on PYTHONPATH."""
    ours = variables()
    lines = []
    for line in text.splitlines():
        name, equals, value = line.partition("=")
        name = name.strip()
        if not equals or name not in ours:
            lines.append(line)
        elif name == "PYTHONPATH":
            theirs = value.strip().strip("\"'").split(os.pathsep)
            ours[name] = os.pathsep.join(_with_ours(theirs, ours[name].split(os.pathsep)))
    lines += [f"{name}={value}" for name, value in ours.items()]
    return "\n".join([*lines, ""])


_OURS = re.compile(r"[/\\](?:core[/\\]ros[/\\]python(?:_of[/\\]\w+)?|day6-tui[/\\]stubs(?:-\w+)?)$")
"""Folders of any installation and distribution."""


def _with_ours(present: Iterable[str] | None, ours: list[str]) -> list[str]:
    """Our folders first, then the existing ones; an older installation's are left out."""
    return [*ours, *(each for each in present or () if each and each not in ours and not _OURS.search(each))]


# -- PyCharm -----------------------------------------------------------------------------------------------------------


def write_pycharm(project: Path, stubs: Path) -> list[Path]:
    """Make our folders source roots of the project, and give every new run configuration our variables; return the files.

    Raises OSError and NotUnderstood as `write_vscode`.
    """
    idea = project / ".idea"
    (idea / "runConfigurations").mkdir(parents=True, exist_ok=True)
    module = next(iter(sorted(idea.glob("*.iml"))), idea / f"{project.resolve().name}.iml")
    modules, template = idea / "modules.xml", idea / "runConfigurations" / "_template__of_Python.xml"
    _change(module, lambda text: _pycharm_module(text, [stubs, *map(Path, python_folders())]))
    if not modules.exists():
        replace_file(modules, _MODULES.format(name=module.name).encode("utf-8"))
    _change(template, _pycharm_template)
    return [module, modules, template]


_MODULES = """\
<?xml version="1.0" encoding="UTF-8"?>
<project version="4">
  <component name="ProjectModuleManager">
    <modules>
      <module fileurl="file://$PROJECT_DIR$/.idea/{name}" filepath="$PROJECT_DIR$/.idea/{name}" />
    </modules>
  </component>
</project>
"""

_MODULE = """\
<module type="PYTHON_MODULE" version="4">
  <component name="NewModuleRootManager">
    <content url="file://$MODULE_DIR$" />
    <orderEntry type="inheritedJdk" />
    <orderEntry type="sourceFolder" forTests="false" />
  </component>
</module>
"""

_TEMPLATE = """\
<component name="ProjectRunConfigurationManager">
  <configuration default="true" type="PythonConfigurationType" factoryName="Python">
    <envs />
    <option name="ADD_SOURCE_ROOTS" value="true" />
  </configuration>
</component>
"""


def _pycharm_module(text: str, folders: list[Path]) -> str:
    root = ElementTree.fromstring(text or _MODULE)
    manager = root.find("component[@name='NewModuleRootManager']")
    if manager is None:
        manager = ElementTree.SubElement(root, "component", name="NewModuleRootManager")
    wanted = {f"file://{'' if os.name == 'posix' else '/'}{folder.as_posix()}": folder for folder in folders}
    for content in list(manager.findall("content")):
        url = content.get("url", "")
        if url in wanted or _OURS.search(url):
            manager.remove(content)
    for number, url in enumerate(wanted):
        content = ElementTree.Element("content", url=url)
        ElementTree.SubElement(content, "sourceFolder", url=url, isTestSource="false")
        manager.insert(number, content)
    return _xml(root)


def _pycharm_template(text: str) -> str:
    root = ElementTree.fromstring(text or _TEMPLATE)
    configuration = root.find("configuration")
    if configuration is None:
        raise ValueError("it has no configuration")
    envs = configuration.find("envs")
    if envs is None:
        envs = ElementTree.SubElement(configuration, "envs")
    ours = variables()
    for env in list(envs.findall("env")):
        if env.get("name") in ours:
            envs.remove(env)
    for name, value in {"PYTHONUNBUFFERED": "1", **ours}.items():
        if envs.find(f"env[@name='{name}']") is None:
            ElementTree.SubElement(envs, "env", name=name, value=value)
    return _xml(root)


def _xml(root: ElementTree.Element) -> str:
    ElementTree.indent(root)
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{ElementTree.tostring(root, encoding="unicode")}\n'


def _change(file: Path, edit: Callable[[str], str]) -> None:
    """Replace the text of a file atomically."""
    before = file.read_text(encoding="utf-8-sig") if file.exists() else ""
    try:
        after = edit(before)
    except (ValueError, ElementTree.ParseError, AttributeError, TypeError) as error:
        raise NotUnderstood(file, error) from error
    if after != before:
        replace_file(file, after.replace("\n", os.linesep).encode("utf-8"))
