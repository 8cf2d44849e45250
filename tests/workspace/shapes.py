"""Shapes that strangers' packages have: what a setup.py or CMakeLists.txt can name, and what then lies in the folder.

Each is a package of its own, so one call of colcon builds them all. `compare_shapes.py` builds them with the real colcon.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

_MANIFEST = """\
<?xml version="1.0"?>
<package format="3">
  <name>{n}</name>
  <version>0.0.0</version>
  <description>A shape</description>
  <maintainer email="pupil@example.org">pupil</maintainer>
  <license>Apache-2.0</license>
{more}  <export>
    <build_type>{kind}</build_type>
  </export>
</package>
"""

_SETUP = """\
import os
from glob import glob
from setuptools import find_packages, setup

here = os.path.dirname(os.path.abspath(__file__))
setup(
    name='{n}',
    version='0.0.0',
    packages={packages},
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/{n}']),
        ('share/{n}', ['package.xml']),
        {data}
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='pupil',
    maintainer_email='pupil@example.org',
    description='A shape',
    license='Apache-2.0',
    entry_points={{'console_scripts': ['node = {n}.node:main']}},
    {more}
)
"""

_CFG = "[develop]\nscript_dir=$base/lib/{n}\n[install]\ninstall_scripts=$base/lib/{n}\n"

_NODE = "WORD = 'first'\n\n\ndef main():\n    print(WORD)\n"


_LISTS = "cmake_minimum_required(VERSION 3.8)\nproject({n})\nfind_package(ament_cmake REQUIRED)\n"


@dataclass(frozen=True)
class Shape:
    """One package. In every text `{n}` is its name; paths are relative to its folder."""

    packages: str = "['{n}']"
    data: str = ""
    """More of data_files."""
    more: str = ""
    """More arguments of setup()."""
    files: Mapping[str, str] = field(default_factory=dict)
    links: Mapping[str, str] = field(default_factory=dict)
    modes: Mapping[str, int] = field(default_factory=dict)
    cfg: str = _CFG
    setup: str = _SETUP
    lists: str = ""
    """CMakeLists.txt; then there is no setup.py."""
    gone: tuple[str, ...] = ()
    """What of the usual files is not there."""
    later: Shape | None = None
    """What a pupil makes of it before the second build; the third is of the first again, and so on."""
    fails: bool = False
    """The build fails, in the real colcon too (Ubuntu 24.04's setuptools or the one beside colcon 0.21)."""
    fails_linked: bool = False
    """The same, only with --symlink-install."""
    either: bool = False
    """What an earlier build installed may be in the way, a file where a folder has to be: setuptools then gives up."""
    refused: bool = False
    """Refused here alone: the real colcon writes outside its folders or into the sources."""

    def write(self, folder: Path, name: str) -> None:
        """Write it, in place of what was there before."""
        shutil.rmtree(folder, ignore_errors=True)

        def filled(text: str) -> str:
            return text.replace("{n}", name)

        usual = {"package.xml": "", f"{name}/__init__.py": "", f"{name}/node.py": _NODE, f"resource/{name}": ""}
        if self.lists:
            group = "  <member_of_group>rosidl_interface_packages</member_of_group>\n" if "rosidl" in self.lists else ""
            usual["package.xml"] = _MANIFEST.format(n=name, kind="ament_cmake", more=group)
            usual["CMakeLists.txt"] = filled(self.lists)
        else:
            usual["package.xml"] = _MANIFEST.format(n=name, kind="ament_python", more="")
            usual["setup.cfg"] = filled(self.cfg)
            words = {"packages": filled(self.packages), "data": filled(self.data), "more": filled(self.more)}
            usual["setup.py"] = self.setup.format(n=name, **words)
        usual.update({filled(path): filled(text) for path, text in self.files.items()})
        for path in map(filled, self.gone):
            usual.pop(path, None)
        for path, text in usual.items():
            target = folder / path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text, encoding="utf-8")
        for path, to in self.links.items():
            target = folder / filled(path)
            target.parent.mkdir(parents=True, exist_ok=True)
            target.symlink_to(filled(to))
        for path, mode in self.modes.items():
            os.chmod(folder / filled(path), mode)


_PARAMS = {"{n}/config/params.yaml": "speed: 1\n"}
_PACKAGE_AND_TOOL = {"{n}/tool.py": "#!/usr/bin/env python3\nprint('tool')\n"}

PYTHON: dict[str, Shape] = {
    "usual": Shape(),
    # -- packages ------------------------------------------------------------------------------------------------------
    "slash_below_package": Shape("['{n}', '{n}/submodules']", files={"{n}/submodules/part.py": "PART = 1\n"}),
    "slash_first": Shape("['{n}/submodules', '{n}']", files={"{n}/submodules/part.py": "PART = 1\n"}),
    "slash_without_package": Shape("['{n}/deep/er']", files={"{n}/deep/er/part.py": "PART = 1\n"}),
    "slash_at_end": Shape("['{n}/']", files={"{n}/part.py": "PART = 1\n"}),
    "dot_below_package": Shape(
        "['{n}', '{n}.sub']", files={"{n}/sub/__init__.py": "", "{n}/sub/part.py": "PART = 1\n"}
    ),
    "found": Shape("find_packages(exclude=['test'])", files={"{n}/sub/__init__.py": "", "test/test_x.py": ""}),
    "two_packages": Shape("['{n}', 'beside_{n}']", files={"beside_{n}/__init__.py": "BESIDE = 1\n"}),
    "same_package_twice": Shape("['{n}', '{n}']"),
    "package_missing": Shape("['{n}', 'nowhere_{n}']", fails=True),
    "package_without_init": Shape(gone=("{n}/__init__.py",)),
    "no_package": Shape("[]", data="('share/{n}', ['only.txt']),", files={"only.txt": "only\n"}),
    "package_called_build": Shape("['{n}', 'build']", files={"build/__init__.py": "", "build/steps.py": "STEPS = 1\n"}),
    "package_called_prefix_override": Shape(
        "['{n}', 'prefix_override']",
        files={"prefix_override/__init__.py": "", "prefix_override/sitecustomize.py": "MINE = 1\n"},
    ),
    "package_called_lib": Shape("['{n}', 'lib']", files={"lib/__init__.py": "LIB = 1\n"}),
    "package_above": Shape("['{n}', '../{n}/{n}']", refused=True),
    "package_absolute": Shape("['{n}', here + '/{n}']", refused=True),
    "package_of_the_whole_folder": Shape("['{n}']", more="package_dir={'{n}': '.'},", files={"top.py": "TOP = 1\n"}),
    # -- package_dir and modules ---------------------------------------------------------------------------------------
    "folder_src": Shape(more="package_dir={'': 'src'},", files={"src/{n}/__init__.py": "", "src/{n}/node.py": _NODE}),
    "folder_src_is_package": Shape(
        "['{n}', 'src']", more="package_dir={'': 'src'},", files={"src/{n}/__init__.py": "", "src/src/__init__.py": ""}
    ),
    "folder_renamed": Shape(more="package_dir={'{n}': 'code'},", files={"code/__init__.py": "", "code/node.py": _NODE}),
    "folder_renamed_deep": Shape(
        more="package_dir={'{n}': 'python/code'},", files={"python/code/__init__.py": "", "python/code/node.py": _NODE}
    ),
    "folder_renamed_with_data": Shape(
        data="('share/{n}/config', ['code/params.yaml']),",
        more="package_dir={'{n}': 'code'},",
        files={"code/__init__.py": "", "code/node.py": _NODE, "code/params.yaml": "a: 1\n"},
    ),
    "folder_above": Shape(
        "['{n}', 'above_{n}']", more="package_dir={'above_{n}': '../{n}/{n}'},", files={"{n}/more.py": "MORE = 1\n"}
    ),
    "module": Shape("[]", more="py_modules=['single_{n}'],", files={"single_{n}.py": "SINGLE = 1\n"}),
    "module_in_package": Shape(more="py_modules=['{n}.node'],"),
    "module_missing": Shape(more="py_modules=['nowhere_{n}'],", fails_linked=True),
    # -- data files ----------------------------------------------------------------------------------------------------
    "data_in_package": Shape(data="('share/{n}/config', ['{n}/config/params.yaml']),", files=_PARAMS),
    "data_beside_package": Shape(
        data="('share/{n}/launch', glob('launch/*.py')),",
        files={"launch/a.launch.py": "A = 1\n", "launch/b.py": "B = 1\n"},
    ),
    "data_twice": Shape(data="('share/{n}/one', ['a.txt']), ('share/{n}/two', ['a.txt']),", files={"a.txt": "a\n"}),
    "data_of_one_name": Shape(
        data="('share/{n}/x', ['one/a.txt', 'two/a.txt']),", files={"one/a.txt": "one\n", "two/a.txt": "two\n"}
    ),
    "data_plain_string": Shape(data="'loose_{n}.txt',", files={"loose_{n}.txt": "loose\n"}),
    "data_is_setup": Shape(data="('share/{n}', ['setup.py', 'setup.cfg']),"),
    "data_is_module": Shape(data="('lib/{n}', ['{n}/node.py']),"),
    "data_is_folder": Shape(data="('share/{n}', ['{n}/config']),", files=_PARAMS, fails=True),
    "data_missing": Shape(data="('share/{n}', ['nowhere.txt']),", fails=True),
    "data_dot": Shape(data="('share/{n}', ['./a.txt', '{n}/../b.txt']),", files={"a.txt": "a\n", "b.txt": "b\n"}),
    "data_absolute": Shape(data="('share/{n}', [os.path.join(here, 'a.txt')]),", files={"a.txt": "a\n"}, fails=True),
    "data_absolute_folder": Shape(data="(here + '/out', ['a.txt']),", files={"a.txt": "a\n"}, fails=True),
    "data_from_above": Shape(data="('share/{n}', ['../{n}/a.txt']),", files={"a.txt": "a\n"}),
    "data_to_above": Shape(data="('../../src/{n}/made', ['a.txt']),", files={"a.txt": "a\n"}, refused=True),
    "data_onto_itself": Shape(data="('../../src/{n}/', ['a.txt']),", files={"a.txt": "a\n"}, refused=True),
    "data_with_spaces": Shape(
        data="('share/{n}/my files', ['my files/a b.txt', '数据/配置.yaml']),",
        files={"my files/a b.txt": "a\n", "数据/配置.yaml": "b: 1\n"},
    ),
    "data_in_folder_called_build": Shape(data="('share/{n}', ['build/notes.txt']),", files={"build/notes.txt": "n\n"}),
    "data_called_install_log": Shape(data="('share/{n}', ['install.log']),", files={"install.log": "mine\n"}),
    "package_data": Shape(more="package_data={'{n}': ['config/*.yaml']},", files=_PARAMS),
    "package_data_from_above": Shape(more="package_data={'{n}': ['../config/*']},", files={"config/a.yaml": "a: 1\n"}),
    "manifest_in": Shape(
        more="include_package_data=True,", files={**_PARAMS, "MANIFEST.in": "recursive-include {n} *\n"}
    ),
    # -- scripts -------------------------------------------------------------------------------------------------------
    "script_in_package": Shape(more="scripts=['{n}/tool.py'],", files=_PACKAGE_AND_TOOL),
    "script_beside": Shape(more="scripts=['scripts/tool'],", files={"scripts/tool": "#!/bin/sh\necho tool\n"}),
    "script_missing": Shape(more="scripts=['nowhere.py'],", fails=True),
    "scripts_into_the_sources": Shape(
        cfg="[develop]\nscript_dir=$base/../../src/{n}/{n}\n[install]\ninstall_scripts=$base/../../src/{n}/{n}\n",
        refused=True,
    ),
    "cfg_of_foxy": Shape(cfg="[develop]\nscript-dir=$base/lib/{n}\n[install]\ninstall-scripts=$base/lib/{n}\n"),
    "cfg_missing": Shape(gone=("setup.cfg",)),
    "cfg_declarative": Shape(
        cfg="[metadata]\nname = {n}\nversion = 0.0.0\n[options]\npackages = find:\n[options.entry_points]\n"
        "console_scripts =\n    node = {n}.node:main\n[develop]\nscript_dir=$base/lib/{n}\n"
        "[install]\ninstall_scripts=$base/lib/{n}\n",
        setup="from setuptools import setup\n\nsetup()\n",
    ),
    "script_is_data_too": Shape(
        data="('lib/{n}', ['scripts/node']),", files={"scripts/node": "#!/bin/sh\necho mine\n"}
    ),
    # -- links, modes and strange files in the sources -----------------------------------------------------------------
    "link_to_module": Shape(links={"{n}/again.py": "node.py"}),
    "link_as_data": Shape(data="('share/{n}', ['a.txt']),", files={"real.txt": "a\n"}, links={"a.txt": "real.txt"}),
    "link_as_package": Shape(
        "['{n}', 'other_{n}']", files={"hidden/__init__.py": "HIDDEN = 1\n"}, links={"other_{n}": "hidden"}
    ),
    "link_to_folder_in_package": Shape(
        "['{n}', '{n}/sub']", files={"hidden/__init__.py": "HIDDEN = 1\n"}, links={"{n}/sub": "../hidden"}
    ),
    "link_in_a_loop": Shape(links={"{n}/loop": "."}),
    "link_to_nothing": Shape(links={"{n}/nothing": "nowhere"}),
    "link_is_setup": Shape(
        setup="",
        gone=("setup.py",),
        files={"real_setup.py": _SETUP.format(n="{n}", packages="['{n}']", data="", more="")},
        links={"setup.py": "real_setup.py"},
    ),
    "read_only_files": Shape(
        data="('share/{n}', ['a.txt']),", files={"a.txt": "a\n"}, modes={"a.txt": 0o444, "{n}/node.py": 0o444}
    ),
    "read_only_folder": Shape(modes={"{n}": 0o555}),
    "program_as_data": Shape(data="('lib/{n}', ['run.sh']),", files={"run.sh": "#!/bin/sh\n"}, modes={"run.sh": 0o755}),
    "own_build_install_log": Shape(
        files={"build/{n}/setup.py": "MINE = 1\n", "install/{n}/notes.txt": "n\n", "log/latest/notes.txt": "n\n"}
    ),
    "own_egg_info": Shape(files={"{n}.egg-info/PKG-INFO": "Name: {n}\n"}),
    "package_in_package": Shape(
        files={"inner/package.xml": _MANIFEST.format(n="inner_{n}", kind="ament_python", more="")}
    ),
    "syntax_error": Shape(files={"{n}/broken.py": "def broken(:\n"}),
    "setup_broken": Shape(setup="import nowhere_at_all\n", fails=True),
    "no_marker": Shape(setup="from setuptools import setup\n\nsetup(name='{n}', version='0.0.0', packages=['{n}'])\n"),
    # -- what changes between two builds -------------------------------------------------------------------------------
    "data_dropped": Shape(
        data="('share/{n}', ['a.txt', 'b.txt']),",
        files={"a.txt": "a\n", "b.txt": "b\n"},
        later=Shape(data="('share/{n}', ['a.txt']),", files={"a.txt": "a\n"}),
    ),
    "package_dropped": Shape("['{n}', 'extra_{n}']", files={"extra_{n}/__init__.py": "E = 1\n"}, later=Shape()),
    "package_added_above_data": Shape(
        data="('share/{n}', ['more_{n}/a.txt']),",
        files={"more_{n}/a.txt": "a\n"},
        later=Shape(
            "['{n}', 'more_{n}']",
            "('share/{n}', ['more_{n}/a.txt']),",
            files={"more_{n}/a.txt": "a\n", "more_{n}/__init__.py": "M = 1\n"},
        ),
    ),
    "data_becomes_folder": Shape(
        data="('share/{n}', ['config']),",
        files={"config": "a: 1\n"},
        either=True,
        later=Shape(data="('share/{n}/config', ['config/a.yaml']),", files={"config/a.yaml": "a: 1\n"}),
    ),
    "data_becomes_file": Shape(
        data="('share/{n}/config', ['config/a.yaml']),",
        files={"config/a.yaml": "a: 1\n"},
        either=True,
        later=Shape(data="('share/{n}', ['config']),", files={"config": "a: 1\n"}),
    ),
    "module_becomes_package": Shape(
        more="py_modules=['part_{n}'],",
        files={"part_{n}.py": "PART = 1\n"},
        later=Shape("['{n}', 'part_{n}']", files={"part_{n}/__init__.py": "PART = 1\n"}),
    ),
    "package_moves_to_src": Shape(
        later=Shape(more="package_dir={'': 'src'},", files={"src/{n}/__init__.py": "", "src/{n}/node.py": _NODE}),
    ),
    "package_src_then_folder_src": Shape(
        "['{n}', 'src']",
        files={"src/__init__.py": ""},
        later=Shape(more="package_dir={'': 'src'},", files={"src/{n}/__init__.py": "", "src/{n}/node.py": _NODE}),
    ),
    "data_folder_becomes_link": Shape(
        data="('share/{n}/config', ['config/a.yaml']),",
        files={"config/a.yaml": "a: 1\n"},
        later=Shape(
            data="('share/{n}/config', ['config/a.yaml']),", files={"real/a.yaml": "a: 1\n"}, links={"config": "real"}
        ),
    ),
}


CMAKE: dict[str, Shape] = {
    "cmake_folder": Shape(
        lists=_LISTS + "install(DIRECTORY launch config/ DESTINATION share/${PROJECT_NAME})\nament_package()\n",
        files={"launch/a.launch.py": "A = 1\n", "config/deep/a.yaml": "a: 1\n"},
        links={"config/again.yaml": "deep/a.yaml", "launch/loop": "."},
    ),
    "cmake_programs": Shape(
        lists=_LISTS + "install(PROGRAMS scripts/run.py DESTINATION lib/${PROJECT_NAME})\nament_package()\n",
        files={"scripts/run.py": "#!/usr/bin/env python3\n"},
        modes={"scripts/run.py": 0o444},
    ),
    "cmake_python": Shape(
        lists=_LISTS + "ament_python_install_package(${PROJECT_NAME})\nament_package()\n",
        files={"{n}/sub/part.py": "PART = 1\n"},
    ),
    "cmake_messages": Shape(
        lists=_LISTS + "find_package(rosidl_default_generators REQUIRED)\n"
        'rosidl_generate_interfaces(${PROJECT_NAME} "msg/One.msg")\nament_package()\n',
        files={"msg/One.msg": "int32 one\n"},
    ),
    "cmake_folder_becomes_file": Shape(
        lists=_LISTS + "install(DIRECTORY data DESTINATION share/${PROJECT_NAME})\nament_package()\n",
        files={"data/a.txt": "a\n"},
        either=True,
        later=Shape(
            lists=_LISTS + "install(FILES data DESTINATION share/${PROJECT_NAME})\nament_package()\n",
            files={"data": "a\n"},
        ),
    ),
    "cmake_file_becomes_folder": Shape(
        lists=_LISTS + "install(FILES data DESTINATION share/${PROJECT_NAME})\nament_package()\n",
        files={"data": "a\n"},
        either=True,
        later=Shape(
            lists=_LISTS + "install(DIRECTORY data DESTINATION share/${PROJECT_NAME})\nament_package()\n",
            files={"data/a.txt": "a\n"},
        ),
    ),
    "cmake_into_the_sources": Shape(
        lists=_LISTS + "install(FILES a.txt DESTINATION ${CMAKE_SOURCE_DIR}/made)\nament_package()\n",
        files={"a.txt": "a\n"},
        refused=True,
    ),
    "cmake_onto_itself": Shape(
        lists=_LISTS + "install(DIRECTORY . DESTINATION ${CMAKE_SOURCE_DIR})\nament_package()\n", refused=True
    ),
    "cmake_above": Shape(
        lists=_LISTS + "install(FILES a.txt DESTINATION ../../src/${PROJECT_NAME})\nament_package()\n",
        files={"a.txt": "a\n"},
        refused=True,
    ),
}
"""Built here alone: the real one needs CMake and a ROS installation."""

STEPS = (("", False), ("", True), ("--symlink-install", True), ("--symlink-install", False), ("", True))
"""The builds one after the other: the option of each, and whether what is `later` is built."""


def lay_out(source: Path, shapes: Mapping[str, Shape], later: bool) -> None:
    """Write the packages that change between two builds, or (if the folder is empty) all of them."""
    for name, shape in shapes.items():
        if shape.later is not None or not (source / name).exists():
            (shape.later if later and shape.later is not None else shape).write(source / name, name)


def snapshot(folder: Path) -> dict[str, tuple[object, ...]]:
    """Return for each path below a folder what may not change: kind, mode and time, and content or goal."""
    found: dict[str, tuple[object, ...]] = {}
    for current, folders, files in os.walk(folder):
        for name in (*folders, *files):
            path = Path(current, name)
            status = path.lstat()
            what: tuple[object, ...] = (oct(status.st_mode), status.st_ino)
            if path.is_symlink():
                what += (os.readlink(path),)
            elif path.is_file():
                what += (status.st_mtime_ns, path.read_bytes())
            found[path.relative_to(folder).as_posix()] = what
    return found


def changes(before: Mapping[str, tuple[object, ...]], after: Mapping[str, tuple[object, ...]]) -> list[str]:
    """Return a line for each path that was lost, made or changed."""
    lines = [f"{path}: {'changed' if path in after else 'lost'}" for path in before if before[path] != after.get(path)]
    return sorted(lines + [f"{path}: made" for path in after if path not in before])
