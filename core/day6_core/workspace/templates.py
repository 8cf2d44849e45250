"""The files of a new package, word for word as `ros2 pkg create` writes them."""

from __future__ import annotations

from dataclasses import dataclass, field

_TEST_HEADER = """\
# Copyright {year} Open Source Robotics Foundation, Inc.
#
# Licensed under the Apache License, Version 2.0 (the "License");
# you may not use this file except in compliance with the License.
# You may obtain a copy of the License at
#
#     http://www.apache.org/licenses/LICENSE-2.0
#
# Unless required by applicable law or agreed to in writing, software
# distributed under the License is distributed on an "AS IS" BASIS,
# WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
# See the License for the specific language governing permissions and
# limitations under the License.

"""

_TEST_COPYRIGHT = """\
from ament_copyright.main import main
import pytest


# Remove the `skip` decorator once the source file(s) have a copyright header
@pytest.mark.skip(reason='No copyright header has been placed in the generated source file.')
@pytest.mark.copyright
@pytest.mark.linter
def test_copyright():
    rc = main(argv=['.', 'test'])
    assert rc == 0, 'Found errors'
"""

_TEST_FLAKE8 = """\
from ament_flake8.main import main_with_errors
import pytest


@pytest.mark.flake8
@pytest.mark.linter
def test_flake8():
    rc, errors = main_with_errors(argv=[])
    assert rc == 0, \\
        'Found %d code style errors / warnings:\\n' % len(errors) + \\
        '\\n'.join(errors)
"""

_TEST_PEP257 = """\
from ament_pep257.main import main
import pytest


@pytest.mark.linter
@pytest.mark.pep257
def test_pep257():
    rc = main(argv=['.', 'test'])
    assert rc == 0, 'Found code style errors / warnings'
"""

TESTS = {
    "test_copyright.py": _TEST_HEADER.format(year=2015) + _TEST_COPYRIGHT,
    "test_flake8.py": _TEST_HEADER.format(year=2017) + _TEST_FLAKE8,
    "test_pep257.py": _TEST_HEADER.format(year=2015) + _TEST_PEP257,
}
"""The linters' tests of an ament_python package."""


@dataclass
class PackagePlan:
    """The arguments of `ros2 pkg create`."""

    name: str
    build_type: str
    description: str
    license: str
    maintainer: str
    email: str
    package_format: int = 3
    dependencies: list[str] = field(default_factory=list)
    node: str | None = None
    library: str | None = None


def package_xml(plan: PackagePlan) -> str:
    """Return package.xml. As in the original nothing is escaped, so an argument can make it malformed XML."""
    tools = {
        "ament_cmake": ["ament_cmake_ros" if plan.library else "ament_cmake"],
        "ament_cargo": ["ament_cargo"],
    }.get(plan.build_type, [])
    tests = {
        "ament_cmake": ["ament_lint_auto", "ament_lint_common"],
        "ament_python": ["ament_copyright", "ament_flake8", "ament_pep257", "python3-pytest"],
    }.get(plan.build_type, [])
    blocks = "".join(
        "".join(f"  <{tag}>{name}</{tag}>\n" for name in names) + "\n"
        for tag, names in (("buildtool_depend", tools), ("depend", plan.dependencies), ("test_depend", tests))
        if names
    )
    schema = f"http://download.ros.org/schema/package_format{plan.package_format}.xsd"
    return f"""<?xml version="1.0"?>
<?xml-model href="{schema}" schematypens="http://www.w3.org/2001/XMLSchema"?>
<package format="{plan.package_format}">
  <name>{plan.name}</name>
  <version>0.0.0</version>
  <description>{plan.description}</description>
  <maintainer email="{plan.email}">{plan.maintainer}</maintainer>
  <license>{plan.license}</license>

{blocks}  <export>
    <build_type>{plan.build_type}</build_type>
  </export>
</package>
"""


def setup_py(plan: PackagePlan) -> str:
    """Return setup.py of an ament_python package."""
    script = f"            '{plan.node} = {plan.name}.{plan.node}:main'\n" if plan.node else ""
    return f"""from setuptools import find_packages, setup

package_name = '{plan.name}'

setup(
    name=package_name,
    version='0.0.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages',
            ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='{plan.maintainer}',
    maintainer_email='{plan.email}',
    description='{plan.description}',
    license='{plan.license}',
    tests_require=['pytest'],
    entry_points={{
        'console_scripts': [
{script}        ],
    }},
)
"""


def setup_cfg(plan: PackagePlan) -> str:
    """Return setup.cfg of an ament_python package: where its executables go."""
    return f"[develop]\nscript_dir=$base/lib/{plan.name}\n[install]\ninstall_scripts=$base/lib/{plan.name}\n"


def python_node(plan: PackagePlan) -> str:
    """Return the Python module of `--node-name`."""
    return f"def main():\n    print('Hi from {plan.name}.')\n\n\nif __name__ == '__main__':\n    main()\n"


# -- C++ ---------------------------------------------------------------------------------------------------------------

_WARNINGS = """
if(CMAKE_COMPILER_IS_GNUCXX OR CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  add_compile_options(-Wall -Wextra -Wpedantic)
endif()
"""

_NO_DEPENDENCIES = """\
# uncomment the following section in order to fill in
# further dependencies manually.
# find_package(<dependency> REQUIRED)
"""

_LINT = """
if(BUILD_TESTING)
  find_package(ament_lint_auto REQUIRED)
  # the following line skips the linter which checks for copyrights
  # comment the line when a copyright and license is added to all source files
  set(ament_cmake_copyright_FOUND TRUE)
  # the following line skips cpplint (only works in a git repo)
  # comment the line when this package is in a git repo and when
  # a copyright and license is added to all source files
  set(ament_cmake_cpplint_FOUND TRUE)
  ament_lint_auto_find_test_dependencies()
endif()
"""


def _features(target: str) -> str:
    return f"target_compile_features({target} PUBLIC c_std_99 cxx_std_17)  # Require C99 and C++17\n"


def _includes(target: str, installed: str) -> str:
    return (
        f"target_include_directories({target} PUBLIC\n  $<BUILD_INTERFACE:${{CMAKE_CURRENT_SOURCE_DIR}}/include>\n"
        f"  $<INSTALL_INTERFACE:{installed}>)\n"
    )


def _ament_dependencies(target: str, plan: PackagePlan) -> str:
    names = "".join(f'  "{name}"\n' for name in plan.dependencies)
    return f"ament_target_dependencies(\n  {target}\n{names})\n" if names else ""


def _install_library(plan: PackagePlan, folder: str, export: str) -> str:
    return (
        f"\n# on Windows the library exports what its users import\n"
        f'target_compile_definitions({plan.library} PRIVATE "{plan.name.upper()}_BUILDING_LIBRARY")\n\n'
        f"install(\n  DIRECTORY include/\n  DESTINATION {folder}\n)\n"
        f"install(\n  TARGETS {plan.library}\n  EXPORT {export}\n"
        "  ARCHIVE DESTINATION lib\n  LIBRARY DESTINATION lib\n  RUNTIME DESTINATION bin\n)\n"
    )


def ament_cmake_lists(plan: PackagePlan) -> str:
    """Return CMakeLists.txt of an ament_cmake package."""
    found = "".join(f"find_package({name} REQUIRED)\n" for name in plan.dependencies) or _NO_DEPENDENCIES
    parts = [
        f"cmake_minimum_required(VERSION 3.8)\nproject({plan.name})\n{_WARNINGS}\n# find dependencies\n",
        "find_package(ament_cmake REQUIRED)\n",
        "find_package(ament_cmake_ros REQUIRED)\n" if plan.library else "",
        found,
    ]
    if plan.library:
        parts += [
            f"\nadd_library({plan.library} src/{plan.library}.cpp)\n",
            f"add_library({plan.name}::{plan.library} ALIAS {plan.library})\n",
            _features(plan.library),
            _includes(plan.library, "include/${PROJECT_NAME}"),
            _ament_dependencies(plan.library, plan),
            _install_library(plan, "include/${PROJECT_NAME}", "export_${PROJECT_NAME}"),
        ]
    if plan.node:
        parts += [
            f"\nadd_executable({plan.node} src/{plan.node}.cpp)\n",
            _includes(plan.node, "include/${PROJECT_NAME}"),
        ]
        if plan.library:
            parts.append(f"target_link_libraries({plan.node} {plan.library})\n")
        else:
            parts += [_features(plan.node), _ament_dependencies(plan.node, plan)]
        parts.append(f"\ninstall(TARGETS {plan.node}\n  DESTINATION lib/${{PROJECT_NAME}})\n")
    parts.append(_LINT)
    if plan.library:
        parts.append(
            '\nament_export_include_directories(\n  "include/${PROJECT_NAME}"\n)\n'
            f"ament_export_libraries(\n  {plan.library}\n)\nament_export_targets(\n  export_${{PROJECT_NAME}}\n)\n"
        )
    parts.append("\nament_package()\n")
    return "".join(parts)


def cmake_lists(plan: PackagePlan) -> str:
    """Return CMakeLists.txt of a plain CMake package."""
    version = "".join(f"set({plan.name}_{part}_VERSION 0)\n" for part in ("MAJOR", "MINOR", "PATCH"))
    joined = ".".join(f"${{{plan.name}_{part}_VERSION}}" for part in ("MAJOR", "MINOR", "PATCH"))
    found = "".join(f"find_package({name} REQUIRED)\n" for name in plan.dependencies)
    parts = [
        f"cmake_minimum_required(VERSION 3.8)\nproject({plan.name})\n\n{version}set({plan.name}_VERSION\n  {joined})\n",
        _WARNINGS,
        f"\n\n# find dependencies\n{found}" if found else f"\n{_NO_DEPENDENCIES}",
    ]
    libraries = "".join(f" ${{{name}_LIBRARIES}}\n" for name in plan.dependencies)
    for target, kind in ((plan.library, "library"), (plan.node, "executable")):
        if not target:
            continue
        shared = " SHARED" if kind == "library" else ""
        parts += [f"\nadd_{kind}({target}{shared} src/{target}.cpp)\n", _features(target), _includes(target, "include")]
        if libraries:
            parts.append(f"target_link_libraries({target}\n{libraries})\n")
        if kind == "library":
            parts.append(_install_library(plan, "include", f"export_{plan.name}"))
        else:
            linked = f"target_link_libraries({target} {plan.library})\n" if plan.library else ""
            parts.append(
                f"{linked}\ninstall(\n  TARGETS {target}\n  EXPORT export_{plan.name}\n  DESTINATION lib/${{PROJECT_NAME}})\n"
            )
    if plan.library or plan.node:
        parts.append(_cmake_export(plan))
    return "".join(parts)


def _cmake_export(plan: PackagePlan) -> str:
    name = plan.name
    return f"""
# what other packages find with find_package({name})
export(EXPORT export_{name}
  FILE "${{PROJECT_BINARY_DIR}}/export_{name}.cmake")
set(CONF_INCLUDE_DIRS "${{CMAKE_INSTALL_PREFIX}}/include")
configure_file({name}Config.cmake.in
  "${{PROJECT_BINARY_DIR}}/${{CMAKE_FILES_DIRECTORY}}/{name}Config.cmake" @ONLY)
configure_file({name}ConfigVersion.cmake.in
  "${{PROJECT_BINARY_DIR}}/{name}ConfigVersion.cmake" @ONLY)
install(FILES
  "${{PROJECT_BINARY_DIR}}/${{CMAKE_FILES_DIRECTORY}}/{name}Config.cmake"
  "${{PROJECT_BINARY_DIR}}/{name}ConfigVersion.cmake"
  DESTINATION "share/${{PROJECT_NAME}}/cmake" COMPONENT dev)
install(EXPORT export_{name}
  DESTINATION "share/${{PROJECT_NAME}}/cmake"
  FILE export_{name}.cmake
  COMPONENT dev)
"""


def cmake_config(plan: PackagePlan) -> str:
    """Return the file that `find_package` reads of a plain CMake package."""
    name = plan.name
    lines = [f"# tells find_package({name}) where its parts are\n"]
    lines += [f'set({name}_INCLUDE_DIRS "@CONF_INCLUDE_DIRS@")\n', f'include("${{{name}_DIR}}/export_{name}.cmake")\n']
    lines += [f"set({name}_LIBRARIES {plan.library})\n"] if plan.library else []
    lines += [f"set({name}_EXECUTABLE {plan.node})\n"] if plan.node else []
    return "".join(lines)


def cmake_config_version(plan: PackagePlan) -> str:
    """Return the version file, for `find_package(… VERSION)`."""
    return f"""set(PACKAGE_VERSION "@{plan.name}_VERSION@")

if("${{PACKAGE_VERSION}}" VERSION_LESS "${{PACKAGE_FIND_VERSION}}")
  set(PACKAGE_VERSION_COMPATIBLE FALSE)
else()
  set(PACKAGE_VERSION_COMPATIBLE TRUE)
  if("${{PACKAGE_VERSION}}" VERSION_EQUAL "${{PACKAGE_FIND_VERSION}}")
    set(PACKAGE_VERSION_EXACT TRUE)
  endif()
endif()
"""


def cpp_node(plan: PackagePlan) -> str:
    """Return the C++ source of `--node-name`."""
    return f"""#include <cstdio>

int main(int argc, char ** argv)
{{
  (void) argc;
  (void) argv;

  printf("hello world {plan.name} package\\n");
  return 0;
}}
"""


def _class_name(library: str) -> str:
    return library.replace("_", " ").title().replace(" ", "")


def cpp_header(plan: PackagePlan) -> str:
    """Return the header of `--library-name`."""
    assert plan.library is not None
    guard, name = f"{plan.name.upper()}__{plan.library.upper()}_HPP_", _class_name(plan.library)
    return f"""#ifndef {guard}
#define {guard}

#include "{plan.name}/visibility_control.h"

namespace {plan.name}
{{

class {name}
{{
public:
  {name}();

  virtual ~{name}();
}};

}}  // namespace {plan.name}

#endif  // {guard}
"""


def cpp_library(plan: PackagePlan) -> str:
    """Return the source of `--library-name`."""
    assert plan.library is not None
    name = _class_name(plan.library)
    return f"""#include "{plan.name}/{plan.library}.hpp"

namespace {plan.name}
{{

{name}::{name}()
{{
}}

{name}::~{name}()
{{
}}

}}  // namespace {plan.name}
"""


def cpp_visibility(plan: PackagePlan) -> str:
    """Return the header with the export macros of a library."""
    name = plan.name.upper()
    return f"""#ifndef {name}__VISIBILITY_CONTROL_H_
#define {name}__VISIBILITY_CONTROL_H_

// what of the library others may use, in the words of each compiler
#if defined _WIN32 || defined __CYGWIN__
  #ifdef {name}_BUILDING_LIBRARY
    #define {name}_PUBLIC __declspec(dllexport)
  #else
    #define {name}_PUBLIC __declspec(dllimport)
  #endif
  #define {name}_LOCAL
#else
  #define {name}_PUBLIC __attribute__ ((visibility("default")))
  #define {name}_LOCAL __attribute__ ((visibility("hidden")))
#endif

#endif  // {name}__VISIBILITY_CONTROL_H_
"""


def cargo_toml(plan: PackagePlan) -> str:
    """Return Cargo.toml of an ament_cargo package."""
    named = "".join(f'{name} = "*"\n' for name in plan.dependencies)
    return f"""[package]
name = "{plan.name}"
version = "0.0.1"
authors = ["{plan.maintainer} <{plan.email}>"]
edition = "2021"

[[bin]]
name = "{plan.name}"
path = "src/main.rs"

[dependencies]
anyhow = {{version = "1", features = ["backtrace"]}}
rclrs = "*"

# newer ones need a newer Rust than 1.75
backtrace = "=0.3.74"

{named or '# what else it needs: NAME = "*"' + chr(10)}"""


def rust_node(plan: PackagePlan) -> str:
    """Return the source file of a Rust node: it says hello and spins."""
    return f"""use anyhow::Result;
use rclrs::{{Context, CreateBasicExecutor, RclrsErrorFilter, SpinOptions}};

fn main() -> Result<()> {{
    let mut executor = Context::default_from_env()?.create_basic_executor();
    let _node = executor.create_node("{plan.node or f"{plan.name}_node"}")?;
    println!("Hello from {plan.name} package!");
    executor.spin(SpinOptions::default()).first_error()?;
    Ok(())
}}
"""
