"""`day6-tui env --vscode` and `--pycharm`: settings are added, nothing of the user's is lost, and imports resolve."""

from __future__ import annotations

import ast
import json
import os
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest

from day6_core.interfaces import get_message, interface_names
from day6_core.interfaces.stubs import package_stubs
from day6_core.ros.environment import PYTHON_PATH, python_folders
from day6_core.shell.outward import ide, jsonc
from day6_core.shell.outward.variables import main

MINE = """\
// my settings
{
    "editor.fontSize": 16, // large
    "python.analysis.extraPaths": ["lib", "/old/day6/core/ros/python"],
    /* keep */
    "python.defaultInterpreterPath": "/my/python",
}
"""

LESSON = """\
import rclpy
from geometry_msgs.msg import TransformStamped, Twist
from rclpy.action import ActionServer
from rclpy.node import Node
from sensor_msgs.msg import JointState, LaserScan
from std_srvs.srv import SetBool
from tf2_ros import Buffer, TransformBroadcaster, TransformListener
from turtlesim.action import RotateAbsolute


class Lesson(Node):
    def __init__(self) -> None:
        super().__init__('lesson')
        self.publisher_ = self.create_publisher(JointState, 'joint_states', 10)
        self.create_service(SetBool, 'on', self.switch)
        self.create_timer(0.5, self.tick)
        self.server = ActionServer(self, RotateAbsolute, 'turn', self.execute)

    def switch(self, request: SetBool.Request, response: SetBool.Response) -> SetBool.Response:
        response.success = request.data
        return response

    def execute(self, goal_handle):
        goal_handle.succeed()
        return RotateAbsolute.Result(delta=0.5)

    def tick(self) -> None:
        message = JointState()
        message.header.stamp = self.get_clock().now().to_msg()
        message.name = ['left_wheel_joint']
        message.position = [0.1]
        self.publisher_.publish(message)
        self.get_logger().info(f'{LaserScan(ranges=[1.0]).ranges[0] + Twist().linear.x}')


def main(args=None):
    rclpy.init(args=args)
    node = Lesson()
    rclpy.spin(node)
    node.destroy_node()
    rclpy.shutdown()
"""


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    monkeypatch.setattr(ide, "stub_folder", lambda: tmp_path / "stubs")
    folder = tmp_path / "project"
    folder.mkdir()
    return folder


def test_keys_are_set_in_json_with_comments_and_the_rest_stays_as_it_is() -> None:
    changed = jsonc.set_keys(MINE, {"editor.fontSize": 18, "new": {"a": [1]}})
    assert changed.startswith("// my settings\n") and "// large" in changed and "/* keep */" in changed
    value = jsonc.parse(changed)
    assert value["editor.fontSize"] == 18 and value["new"] == {"a": [1]}
    assert jsonc.set_keys(changed, {"new": {"a": [1]}}) == changed
    assert jsonc.parse(jsonc.set_keys('{"a": "//, }"}', {"b": 1})) == {"a": "//, }", "b": 1}
    assert jsonc.parse(jsonc.set_keys("", {"b": 1})) == {"b": 1}


@pytest.mark.parametrize("text", ["[1]", '{"a": ', "{a: 'b'}", '{"a" 1}'])
def test_what_is_no_object_is_refused(text: str) -> None:
    with pytest.raises(ValueError):
        jsonc.set_keys(text, {"b": 1})


def test_the_users_settings_are_kept_and_ours_come_first(project: Path) -> None:
    (project / ".vscode").mkdir()
    (project / ".vscode" / "settings.json").write_text(MINE, encoding="utf-8")
    (project / ".env").write_text("TOKEN=1\nPYTHONPATH=/mine\n", encoding="utf-8")
    assert main(["--vscode", str(project)]) == 0
    text = (project / ".vscode" / "settings.json").read_text(encoding="utf-8")
    settings = jsonc.parse(text)
    assert "// large" in text
    assert settings["python.defaultInterpreterPath"] == "/my/python"
    assert settings["python.analysis.extraPaths"] == [str(ide.stub_folder()), *python_folders(), "lib"]
    lines = (project / ".env").read_text(encoding="utf-8").splitlines()
    assert "TOKEN=1" in lines
    (path,) = [line for line in lines if line.startswith("PYTHONPATH=")]
    assert path.startswith(f"PYTHONPATH={PYTHON_PATH}") and path.endswith("/mine")


def test_a_launch_configuration_is_added_beside_the_users_and_only_once(project: Path) -> None:
    (project / ".vscode").mkdir()
    launch = project / ".vscode" / "launch.json"
    launch.write_text(
        '{"version": "0.2.0", "configurations": [ // mine\n{"name": "Mine", "type": "node"}\n]}\n', encoding="utf-8"
    )
    for _ in range(2):
        assert main(["--vscode", str(project)]) == 0
    assert "// mine" in launch.read_text(encoding="utf-8")
    names = [each["name"] for each in jsonc.parse(launch.read_text(encoding="utf-8"))["configurations"]]
    assert names == [ide.LAUNCH_NAME, "Mine"]


def test_a_second_run_changes_nothing(project: Path) -> None:
    def contents() -> dict[str, str]:
        return {str(file): file.read_text(encoding="utf-8") for file in project.rglob("*") if file.is_file()}

    main(["--vscode", "--pycharm", str(project)])
    first = contents()
    main(["--vscode", "--pycharm", str(project)])
    assert contents() == first and len(first) == 6


def test_a_file_that_is_not_understood_is_left_alone_and_named(
    project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (project / ".vscode").mkdir()
    settings = project / ".vscode" / "settings.json"
    settings.write_text("{ broken", encoding="utf-8")
    assert main(["--vscode", str(project)]) == 1
    assert str(settings) in capsys.readouterr().err
    assert settings.read_text(encoding="utf-8") == "{ broken"


def test_pycharm_gets_source_roots_and_variables_beside_its_own(project: Path) -> None:
    idea = project / ".idea"
    (idea / "runConfigurations").mkdir(parents=True)
    (idea / "mine.iml").write_text(
        '<module type="PYTHON_MODULE" version="4"><component name="NewModuleRootManager">'
        '<content url="file://$MODULE_DIR$"><excludeFolder url="file://$MODULE_DIR$/build"/></content>'
        '<orderEntry type="jdk" jdkName="Python 3.12" jdkType="Python SDK"/></component></module>',
        encoding="utf-8",
    )
    assert main(["--pycharm", str(project)]) == 0
    module = ElementTree.parse(idea / "mine.iml")
    assert module.find(".//orderEntry[@jdkName='Python 3.12']") is not None
    assert module.find(".//excludeFolder") is not None
    urls = [each.get("url") for each in module.iterfind(".//sourceFolder")]
    assert f"file://{'' if os.name == 'posix' else '/'}{PYTHON_PATH.as_posix()}" in urls
    template = ElementTree.parse(idea / "runConfigurations" / "_template__of_Python.xml")
    path = template.find(".//env[@name='PYTHONPATH']")
    assert path is not None and str(PYTHON_PATH) in str(path.get("value"))


def test_the_stubs_have_every_interface_with_its_fields_and_constants() -> None:
    stubs = package_stubs("sensor_msgs")
    tree = ast.parse(stubs["sensor_msgs/msg/__init__.pyi"])
    classes = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
    assert [f"msg/{name}" for name in classes] == interface_names("sensor_msgs", "msg")
    for name, node in classes.items():
        cls = get_message(f"sensor_msgs/msg/{name}")
        properties = {
            each.name
            for each in node.body
            if isinstance(each, ast.FunctionDef) and any(ast.unparse(d) == "property" for d in each.decorator_list)
        }
        assert properties == set(cls.get_fields_and_field_types())
    assert "    DEGREES" not in stubs["sensor_msgs/msg/__init__.pyi"]
    assert stubs["sensor_msgs/msg/__init__.pyi"].count("POWER_SUPPLY_STATUS_FULL: ClassVar[int]") == 1
    assert "Request = SetCameraInfo_Request" in stubs["sensor_msgs/srv/__init__.pyi"]


@pytest.mark.process
def test_a_plain_python3_with_the_editors_variables_is_a_ros_program(project: Path) -> None:
    main(["--vscode", str(project)])
    launch = json.loads((project / ".vscode" / "launch.json").read_text(encoding="utf-8"))
    (ours,) = launch["configurations"]
    env = {"PATH": os.environ.get("PATH", ""), "SYSTEMROOT": os.environ.get("SYSTEMROOT", ""), **ours["env"]}
    (project / "a.py").write_text(
        "import rclpy, std_msgs.msg\nprint(rclpy.__file__, std_msgs.msg.String())\n", encoding="utf-8"
    )
    done = subprocess.run(
        [ours["python"], "a.py"], cwd=project, env=env, capture_output=True, text=True, timeout=60, encoding="utf-8"
    )
    assert done.returncode == 0, done.stderr
    assert str(PYTHON_PATH) in done.stdout


PYRIGHT = os.environ.get("DAY6_PYRIGHT") or shutil.which("basedpyright", path=os.path.dirname(sys.executable))


@pytest.mark.process
@pytest.mark.skipif(PYRIGHT is None, reason="basedpyright is not installed (DAY6_PYRIGHT may name another pyright)")
def test_pyright_finds_nothing_wrong_with_a_lesson_and_much_with_a_slip(project: Path) -> None:
    main(["--vscode", str(project)])
    paths = jsonc.parse((project / ".vscode" / "settings.json").read_text(encoding="utf-8"))[
        "python.analysis.extraPaths"
    ]
    (project / "pyrightconfig.json").write_text(
        json.dumps({"extraPaths": paths, "typeCheckingMode": "standard"}), encoding="utf-8"
    )
    (project / "lesson.py").write_text(LESSON, encoding="utf-8")
    (project / "slip.py").write_text(
        LESSON.replace("message.name", "message.nam").replace("Twist()", "Twist(linar=1)"), encoding="utf-8"
    )

    def errors(file: str) -> list[str]:
        command = [str(PYRIGHT), "--outputjson", "--pythonpath", sys.executable, file]
        done = subprocess.run(command, cwd=project, capture_output=True, text=True, timeout=300, encoding="utf-8")
        return [
            each["message"] for each in json.loads(done.stdout)["generalDiagnostics"] if each["severity"] == "error"
        ]

    assert errors("lesson.py") == []
    assert len(errors("slip.py")) == 2
