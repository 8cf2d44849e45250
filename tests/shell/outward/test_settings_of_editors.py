"""What `day6-tui env` makes of an editor's files, to the letter: JSON with comments, .env, and PyCharm's XML."""

from __future__ import annotations

import json
import os
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Any

import pytest

from day6_core.ros.environment import PYTHON_PATH
from day6_core.shell.outward import ide, jsonc

OURS = {"PYTHONPATH": "/ros", "ROS_DOMAIN_ID": "3"}
STUBS = Path("/stubs")


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(ide, "variables", lambda: dict(OURS))
    monkeypatch.setattr(ide, "python_folders", lambda: [str(Path("/ros"))])
    folder = tmp_path / "project"
    folder.mkdir()
    return folder


def put(project: Path, name: str, text: str) -> Path:
    file = project / name
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8")
    return file


@pytest.mark.parametrize(
    ("text", "values", "after"),
    [
        ("{}", {"a": 1}, '{\n    "a": 1\n}'),
        ("  ", {"ü": None}, '{\n    "ü": null\n}\n'),
        ('{"a": 1}', {"a": 1}, '{"a": 1}'),
        ('{"a": 1.0}', {"a": 1}, '{"a": 1.0}'),
        ('{"a": 1}', {"b": [1, 2]}, '{"a": 1,\n    "b": [\n        1,\n        2\n    ]\n}'),
        ('{"a": 1,}', {"a": 2}, '{"a": 2,}'),
        ('{"a": 1,}', {"b": 2}, '{"a": 1,\n    "b": 2\n}'),
        (
            '{\n    "a": {"b": 2, "c": [1, {"a": 3}]}, // x\n    "b": "t,}"\n}\n',
            {"a": 5, "b": 6, "c": 7},
            '{\n    "a": 5, // x\n    "b": 6,\n    "c": 7\n}\n',
        ),
        ('{"a": /* old */ 1 /* after */}', {"a": 2}, '{"a": /* old */ 2 /* after */}'),
        ('{"a" : "b" , "b" : "a"}', {"b": 1}, '{"a" : "b" , "b" : 1}'),
        ('{"a": [] // c\n}', {"n": {}}, '{"a": [], // c\n    "n": {}\n}'),
        ('{"a": {"x": 1}, "b": {"x": 2}}', {"b": {"x": 3}}, '{"a": {"x": 1}, "b": {\n        "x": 3\n    }}'),
        ('{"a": [1, 2,], }', {"a": [1]}, '{"a": [\n        1\n    ], }'),
        ('{"x": {"a": 1}, "a": 2}', {"a": 3}, '{"x": {"a": 1}, "a": 3}'),
        ("{// c\n}", {"a": 1}, '{// c\n    "a": 1\n}'),
        ('{"q\\"": "\\\\", "r": 1}', {"r": 2}, '{"q\\"": "\\\\", "r": 2}'),
    ],
)
def test_a_key_is_set_and_every_other_character_stays(text: str, values: dict[str, Any], after: str) -> None:
    assert jsonc.set_keys(text, values) == after


@pytest.mark.parametrize(
    "text",
    ["[1]", "{", "}", "{]", '{"a": 1', "1", '"a"', '{"a": 1}}', '{"a"}', "x", "{a: 1}", "{\"a\": 'b'}", "/"],
)
def test_a_text_without_an_object_gets_no_keys(text: str) -> None:
    with pytest.raises(ValueError):
        jsonc.set_keys(text, {"b": 1})


def test_a_text_that_ends_in_the_middle_says_where_it_is_not_understood() -> None:
    with pytest.raises(ValueError, match=r"^not understood: '/abcdefghijklmnopqrs'$"):
        jsonc.parse("{/abcdefghijklmnopqrstuvwxyz")
    with pytest.raises(ValueError, match=r"^brackets do not match$"):
        jsonc.spans('{"a": [1}')


def test_vs_code_gets_a_whole_set_of_files_where_there_is_none(project: Path) -> None:
    settings, launch, env = ide.write_vscode(project, STUBS)
    assert settings == project / ".vscode" / "settings.json" and launch == project / ".vscode" / "launch.json"
    names = {"win32": "windows", "darwin": "osx"}
    assert json.loads(settings.read_text(encoding="utf-8")) == {
        "python.analysis.extraPaths": [str(STUBS), str(Path("/ros"))],
        f"terminal.integrated.env.{names.get(sys.platform, 'linux')}": OURS,
        "python.envFile": "${workspaceFolder}/.env",
        "python.defaultInterpreterPath": sys.executable,
    }
    assert json.loads(launch.read_text(encoding="utf-8")) == {
        "version": "0.2.0",
        "configurations": [
            {
                "name": "day6: this Python file",
                "type": "debugpy",
                "request": "launch",
                "program": "${file}",
                "console": "integratedTerminal",
                "python": sys.executable,
                "env": OURS,
            }
        ],
    }
    assert (env, env.read_text(encoding="utf-8")) == (project / ".env", "PYTHONPATH=/ros\nROS_DOMAIN_ID=3\n")


@pytest.mark.parametrize(("system", "name"), [("win32", "windows"), ("darwin", "osx"), ("linux", "linux")])
@pytest.mark.skipif(os.name != "posix", reason="plays the other systems on one with modes")
def test_the_terminal_of_vs_code_keeps_its_own_variables(
    project: Path, monkeypatch: pytest.MonkeyPatch, system: str, name: str
) -> None:
    key = f"terminal.integrated.env.{name}"
    text = json.dumps({key: {"A": "1", "ROS_DOMAIN_ID": "0"}, "python.envFile": "mine"})
    file = put(project, ".vscode/settings.json", text)
    monkeypatch.setattr(sys, "platform", system)
    ide.write_vscode(project, STUBS)
    settings = json.loads(file.read_text(encoding="utf-8"))
    assert settings[key] == {"A": "1", **OURS} and settings["python.envFile"] == "mine"
    assert [each for each in settings if each.startswith("terminal.")] == [key]


def test_folders_of_an_older_installation_and_our_own_are_not_named_twice(project: Path) -> None:
    old = os.path.join("/old", "core", "ros", "python")
    text = json.dumps({"python.analysis.extraPaths": ["a", str(STUBS), "", old, "b"]})
    settings, _, _ = ide.write_vscode(put(project, ".vscode/settings.json", text).parents[1], STUBS)
    paths = json.loads(settings.read_text(encoding="utf-8"))["python.analysis.extraPaths"]
    assert paths == [str(STUBS), str(Path("/ros")), "a", "b"]


@pytest.mark.parametrize(
    ("configurations", "after"),
    [
        ([], [ide.LAUNCH_NAME]),
        ([{"name": "Mine"}], [ide.LAUNCH_NAME, "Mine"]),
        (
            [{"name": "Mine"}, {"name": ide.LAUNCH_NAME, "old": 1}, {"name": "Other"}],
            ["Mine", ide.LAUNCH_NAME, "Other"],
        ),
    ],
)
def test_our_launch_configuration_is_put_anew_in_its_place(
    project: Path, configurations: list[Any], after: list[str]
) -> None:
    file = put(project, ".vscode/launch.json", json.dumps({"version": "0.1", "configurations": configurations}))
    for _ in range(2):
        ide.write_vscode(project, STUBS)
        launch = json.loads(file.read_text(encoding="utf-8"))
        assert [each["name"] for each in launch["configurations"]] == after and launch["version"] == "0.1"
        (ours,) = [each for each in launch["configurations"] if each["name"] == ide.LAUNCH_NAME]
        assert ours["env"] == OURS and "old" not in ours


def test_a_launch_configuration_is_indented_as_vs_code_does(project: Path) -> None:
    file = put(project, ".vscode/launch.json", '{"version": "1", "configurations": [\n        {"name": "Mine"}\n    ]}')
    ide.write_vscode(project, STUBS)
    lines = file.read_text(encoding="utf-8").splitlines()
    assert lines[:3] == [
        '{"version": "1", "configurations": [',
        "        {",
        '            "name": "day6: this Python file",',
    ]
    assert lines[-4:] == ["            }", "        },", '        {"name": "Mine"}', "    ]}"]


def test_an_env_file_keeps_its_other_lines_and_folders(project: Path) -> None:
    theirs = os.pathsep.join(["/mine", os.path.join("/old", "core", "ros", "python"), "/ros"])
    text = f"A=1\n# c\nROS_DOMAIN_ID = 9\nPYTHONPATH='{theirs}'\nno\nPYTHONPATH\n"
    file = put(project, ".env", text)
    ide.write_vscode(project, STUBS)
    path = os.pathsep.join(["/ros", "/mine"])
    assert file.read_text(encoding="utf-8") == f"A=1\n# c\nno\nPYTHONPATH\nPYTHONPATH={path}\nROS_DOMAIN_ID=3\n"


@pytest.mark.parametrize(
    ("name", "text", "why"),
    [
        (".vscode/settings.json", "[]", "it isn't an object"),
        (".vscode/launch.json", '{"configurations": [1]}', "object has no attribute"),
        (".vscode/launch.json", '{"version": 1', "delimiter"),
    ],
)
def test_a_file_of_vs_code_that_is_not_understood_is_named_and_stays(
    project: Path, name: str, text: str, why: str
) -> None:
    file = put(project, name, text)
    with pytest.raises(ValueError, match="is not understood and was left as it is: .*" + why) as told:
        ide.write_vscode(project, STUBS)
    assert str(told.value).startswith(str(file)) and file.read_text(encoding="utf-8") == text


@pytest.mark.skipif(os.name != "posix", reason="how folders are written there")
def test_pycharm_gets_a_whole_project_where_there_is_none(project: Path) -> None:
    module, modules, template = ide.write_pycharm(project, STUBS)
    assert module.read_text(encoding="utf-8") == (
        '<?xml version="1.0" encoding="UTF-8"?>\n<module type="PYTHON_MODULE" version="4">\n'
        '  <component name="NewModuleRootManager">\n    <content url="file:///stubs">\n'
        '      <sourceFolder url="file:///stubs" isTestSource="false" />\n    </content>\n'
        '    <content url="file:///ros">\n      <sourceFolder url="file:///ros" isTestSource="false" />\n    </content>\n'
        '    <content url="file://$MODULE_DIR$" />\n    <orderEntry type="inheritedJdk" />\n'
        '    <orderEntry type="sourceFolder" forTests="false" />\n  </component>\n</module>\n'
    )
    assert module == project / ".idea" / "project.iml" and modules == project / ".idea" / "modules.xml"
    (entry,) = ElementTree.parse(modules).iter("module")
    assert entry.attrib == {
        "fileurl": "file://$PROJECT_DIR$/.idea/project.iml", "filepath": "$PROJECT_DIR$/.idea/project.iml",
    }  # fmt: skip
    assert template == project / ".idea" / "runConfigurations" / "_template__of_Python.xml"
    root = ElementTree.parse(template).getroot()
    assert root.get("name") == "ProjectRunConfigurationManager"
    assert root[0].attrib == {"default": "true", "type": "PythonConfigurationType", "factoryName": "Python"}
    assert [(env.get("name"), env.get("value")) for env in root.iter("env")] == [
        ("PYTHONUNBUFFERED", "1"),
        *OURS.items(),
    ]
    assert [option.attrib for option in root.iter("option")] == [{"name": "ADD_SOURCE_ROOTS", "value": "true"}]


@pytest.mark.skipif(os.name != "posix", reason="how folders are written there")
def test_pycharm_keeps_its_own_module_list_roots_and_variables(project: Path) -> None:
    old = "".join(
        f'<content url="file://{name}"/>' for name in ("/x/day6-tui/stubs", "/old/core/ros/python", "/ros", "/mine")
    )
    module = put(project, ".idea/a.iml", f'<module><component name="NewModuleRootManager">{old}</component></module>')
    put(project, ".idea/b.iml", "<module/>")
    modules = put(project, ".idea/modules.xml", "theirs")
    envs = '<env name="ROS_DOMAIN_ID" value="9"/><env name="MY" value="1"/><env name="PYTHONUNBUFFERED" value="0"/>'
    template = put(
        project,
        ".idea/runConfigurations/_template__of_Python.xml",
        f"<component><configuration><envs>{envs}</envs></configuration></component>",
    )
    assert ide.write_pycharm(project, STUBS) == [module, modules, template]
    roots = [content.get("url") for content in ElementTree.parse(module).iter("content")]
    assert roots == ["file:///stubs", "file:///ros", "file:///mine"]
    assert modules.read_text(encoding="utf-8") == "theirs"
    assert [(env.get("name"), env.get("value")) for env in ElementTree.parse(template).iter("env")] == [
        ("MY", "1"),
        ("PYTHONUNBUFFERED", "0"),
        *OURS.items(),
    ]


def test_what_pycharm_lacks_is_added_and_what_is_no_template_is_refused(project: Path) -> None:
    module = put(project, ".idea/a.iml", '<module><component name="Other"/></module>')
    template = put(
        project, ".idea/runConfigurations/_template__of_Python.xml", "<component><configuration/></component>"
    )
    ide.write_pycharm(project, STUBS)
    names = [component.get("name") for component in ElementTree.parse(module).iter("component")]
    assert names == ["Other", "NewModuleRootManager"]
    assert [env.get("name") for env in ElementTree.parse(template).iter("env")] == ["PYTHONUNBUFFERED", *OURS]
    for text, why in (("<component/>", "it has no configuration"), ("<component", "unclosed token")):
        template.write_text(text, encoding="utf-8")
        with pytest.raises(ValueError, match=why):
            ide.write_pycharm(project, STUBS)
        assert template.read_text(encoding="utf-8") == text


def test_the_variables_are_those_of_this_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    for name, value in {
        "ROS_DOMAIN_ID": "7",
        "AMENT_PREFIX_PATH": "/ws",
        "DAY6_RUNTIME_DIR": "/run/x",
        "OTHER": "no",
    }.items():
        monkeypatch.setenv(name, value)
    values = ide.variables()
    assert next(iter(values)) == "PYTHONPATH" and values["PYTHONPATH"].split(os.pathsep)[0] == str(PYTHON_PATH)
    assert list(values)[1:] == sorted(list(values)[1:]) and "OTHER" not in values
    assert (values["ROS_DOMAIN_ID"], values["DAY6_RUNTIME_DIR"]) == ("7", "/run/x")
    assert values["AMENT_PREFIX_PATH"].split(os.pathsep)[0] == "/ws" or "/ws" in values["AMENT_PREFIX_PATH"]


def test_the_stubs_are_files_of_their_packages_and_are_counted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("day6_core.interfaces.packages", lambda: ["std_srvs", "std_msgs"])
    assert ide.write_stubs(tmp_path) == 2
    assert sorted(path.name for path in tmp_path.iterdir()) == ["std_msgs", "std_srvs"]
    assert "class SetBool" in (tmp_path / "std_srvs" / "srv" / "__init__.pyi").read_text(encoding="utf-8")
