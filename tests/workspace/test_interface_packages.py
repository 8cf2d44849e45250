"""Whose messages a package may use, and what is built of a package that has C++ beside them."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.workspace.workshop import Workshop, edit

MANIFEST = """\
<?xml version="1.0"?>
<package format="3">
  <name>{name}</name><version>0.0.0</version><description>x</description>
  <maintainer email="a@b.org">a</maintainer><license>MIT</license>
  <buildtool_depend>ament_cmake</buildtool_depend>
  {depends}
  <member_of_group>rosidl_interface_packages</member_of_group>
  <export><build_type>ament_cmake</build_type></export>
</package>
"""


def package(workshop: Workshop, name: str, lists: str, files: dict[str, str], depends: str = "") -> Path:
    """Make a CMake package with these commands between `find_package(rosidl_default_generators)` and `ament_package()`."""
    folder = workshop.workspace / "src" / name
    lists = (
        f"cmake_minimum_required(VERSION 3.8)\nproject({name})\nfind_package(ament_cmake REQUIRED)\n"
        f"find_package(rosidl_default_generators REQUIRED)\n{lists}\nament_package()\n"
    )
    needs = "".join(f"<depend>{each}</depend>" for each in depends.split())
    texts = {"CMakeLists.txt": lists, "package.xml": MANIFEST.format(name=name, depends=needs), **files}
    for path, text in texts.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text, encoding="utf-8")
    return folder


def generate(files: str, dependencies: str = "") -> str:
    finds = "".join(f"find_package({name} REQUIRED)\n" for name in dependencies.split())
    more = f" DEPENDENCIES {dependencies}" if dependencies else ""
    return f"{finds}rosidl_generate_interfaces(${{PROJECT_NAME}} {files}{more})"


# -- whose messages ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("file", "text", "dependencies"),
    [
        ("msg/A.msg", "std_msgs/Header header\ngeometry_msgs/Point p\n", "geometry_msgs"),
        ("msg/A.msg", "builtin_interfaces/Time t\n", "nav_msgs"),
        ("srv/A.srv", "builtin_interfaces/Time t\n---\n", ""),
        ("action/A.action", "unique_identifier_msgs/UUID id\n---\n---\n", ""),
    ],
)
def test_what_the_dependencies_bring_with_them_may_be_used(
    workshop: Workshop, file: str, text: str, dependencies: str
) -> None:
    package(workshop, "day6_own", generate(file, dependencies), {file: text})
    done = workshop.run("colcon build")
    assert (done.status, done.err) == (0, ""), done


@pytest.mark.process
def test_a_package_of_the_same_workspace_and_one_sourced_before_bring_theirs(workshop: Workshop) -> None:
    package(workshop, "day6_a", generate("msg/A.msg", "geometry_msgs"), {"msg/A.msg": "geometry_msgs/Point p\n"})
    package(
        workshop, "day6_b", generate("msg/B.msg", "day6_a"), {"msg/B.msg": "day6_a/A a\nstd_msgs/Header h\n"}, "day6_a"
    )
    assert workshop.run("colcon build").status == 0
    over = workshop.home / "over_ws"
    here = package(
        workshop,
        "day6_c",
        generate("msg/C.msg", "day6_b"),
        {"msg/C.msg": "day6_a/A a\ngeometry_msgs/Point p\nday6_b/B b\n"},
    )
    (over / "src").mkdir(parents=True)
    here.rename(over / "src" / "day6_c")
    shell = workshop.terminal(over)
    done = workshop.run("source ~/ros2_ws/install/setup.bash && colcon build", shell)
    assert (done.status, done.err) == (0, ""), done
    line = "source install/setup.bash; python3 -c 'from day6_c.msg import C; print(C().b.h.frame_id == str())'"
    assert workshop.run(line, shell).out == "True\n"


@pytest.mark.parametrize(
    ("lists", "text", "error"),
    [
        (generate("msg/A.msg", "builtin_interfaces"), "std_msgs/Header h\n", "KeyError: 'std_msgs'\n"),
        (generate("msg/A.msg"), "builtin_interfaces/Time t\n", "KeyError: 'builtin_interfaces'\n"),
        (
            generate("msg/A.msg", "geometry_msgs"),
            "geometry_msgs/Pont p\n",
            "geometry_msgs/msg/Pont.json'\n(msg/A.msg uses 'geometry_msgs/msg/Pont', but 'geometry_msgs' has no such message)\n",
        ),
        (generate("msg/A.msg"), "B b\n", "FileNotFoundError: [Errno 2] No such file or directory: '"),
        (
            "rosidl_generate_interfaces(${PROJECT_NAME} msg/A.msg DEPENDENCIES geometry_msgs)",
            "int8 a\n",
            "the passed dependency 'geometry_msgs' has not\n  been found before using find_package()\n",
        ),
    ],
)
def test_what_the_real_one_refuses_is_refused_in_its_words(
    workshop: Workshop, lists: str, text: str, error: str
) -> None:
    package(workshop, "day6_own", lists, {"msg/A.msg": text, "msg/B.msg": "int8 b\n"})
    done = workshop.run("colcon build")
    assert done.status == 1 and error in done.err, done.err
    assert not (workshop.workspace / "install/day6_own/share/day6_own/msg/A.msg").exists()


def test_a_dependency_that_another_one_found_needs_no_find_package_of_its_own(workshop: Workshop) -> None:
    lists = (
        "find_package(nav_msgs REQUIRED)\n"
        "rosidl_generate_interfaces(${PROJECT_NAME} msg/A.msg DEPENDENCIES geometry_msgs)"
    )
    package(workshop, "day6_own", lists, {"msg/A.msg": "geometry_msgs/Point p\n"})
    assert workshop.run("colcon build").status == 0


def test_dependencies_may_be_found_by_a_loop_and_by_ament_auto(workshop: Workshop) -> None:
    loop = (
        "set(needed geometry_msgs std_msgs)\nforeach(each IN LISTS needed)\n  find_package(${each} REQUIRED)\nendforeach()\n"
        "rosidl_generate_interfaces(${PROJECT_NAME} msg/A.msg DEPENDENCIES ${needed})"
    )
    package(workshop, "day6_loop", loop, {"msg/A.msg": "geometry_msgs/Point p\nstd_msgs/Header h\n"})
    auto = (
        "find_package(ament_cmake_auto REQUIRED)\nament_auto_find_build_dependencies()\n"
        "rosidl_generate_interfaces(${PROJECT_NAME} msg/A.msg DEPENDENCIES sensor_msgs)"
    )
    package(workshop, "day6_auto", auto, {"msg/A.msg": "sensor_msgs/Image i\nstd_msgs/Header h\n"}, "sensor_msgs")
    done = workshop.run("colcon build")
    assert (done.status, done.err) == (0, ""), done


# -- C++ beside other things -------------------------------------------------------------------------------------------

PROGRAM = "#!/usr/bin/env python3\nfrom day6_mixed.msg import A\nimport words\n\nprint(words.WORD, A(a=3).a)\n"
MIXED_FILES = {
    "msg/A.msg": "int64 a\n",
    "words/__init__.py": "WORD = 'said'\n",
    "scripts/say.py": PROGRAM,
    "launch/up.launch.py": "",
    "src/talker.cpp": "int main() {}\n",
    "include/day6_mixed/x.hpp": "",
}
PLAIN = """\
find_package(rclcpp REQUIRED)
find_package(OpenCV REQUIRED)
find_package(std_msgs REQUIRED)
rosidl_generate_interfaces(${PROJECT_NAME} "msg/A.msg" DEPENDENCIES std_msgs)
rosidl_get_typesupport_target(cpp_typesupport_target ${PROJECT_NAME} "rosidl_typesupport_cpp")
add_library(filter SHARED src/filter.cpp)
add_executable(talker src/talker.cpp)
target_include_directories(talker PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>)
ament_target_dependencies(talker rclcpp std_msgs)
target_link_libraries(talker filter "${cpp_typesupport_target}" ${OpenCV_LIBS})
install(TARGETS talker filter ARCHIVE DESTINATION lib LIBRARY DESTINATION lib RUNTIME DESTINATION lib/${PROJECT_NAME})
install(DIRECTORY include/ DESTINATION include)
ament_export_include_directories(include)
ament_export_dependencies(rosidl_default_runtime)
"""
IN_A_LOOP = """\
if(NOT CMAKE_CXX_STANDARD)
  set(CMAKE_CXX_STANDARD 17)
endif()
if(CMAKE_COMPILER_IS_GNUCXX OR CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  add_compile_options(-Wall)
endif()
rosidl_generate_interfaces(${PROJECT_NAME} "msg/A.msg")
set(programs talker)
foreach(program ${programs})
  add_executable(${program} src/${program}.cpp)
  install(TARGETS ${program} DESTINATION lib/${PROJECT_NAME})
endforeach()
add_library(filter SHARED src/filter.cpp)
"""
BY_A_FUNCTION = """\
rosidl_generate_interfaces(${PROJECT_NAME} "msg/A.msg")
function(make_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
endfunction()
macro(make_library name)
  add_library(${name} SHARED ${ARGN})
endmacro()
make_program(talker SOURCES src/talker.cpp)
make_library(filter src/filter.cpp)
"""
AUTO = """\
find_package(ament_cmake_auto REQUIRED)
ament_auto_find_build_dependencies()
rosidl_generate_interfaces(${PROJECT_NAME} "msg/A.msg")
ament_auto_add_library(filter SHARED src/filter.cpp)
rclcpp_components_register_node(filter PLUGIN "day6::Talker" EXECUTABLE talker)
"""
REST = """\
if(BUILD_TESTING)
  find_package(ament_lint_auto REQUIRED)
  find_package(launch_testing_nowhere REQUIRED)
  add_executable(only_a_test test/x.cpp)
  if(WIN32)
  endif()
endif()
ament_python_install_package(words)
install(PROGRAMS scripts/say.py DESTINATION lib/${PROJECT_NAME})
install(DIRECTORY launch DESTINATION share/${PROJECT_NAME}/)
"""


@pytest.mark.process
@pytest.mark.parametrize("lists", [PLAIN, IN_A_LOOP, BY_A_FUNCTION, AUTO], ids=["plain", "loop", "function", "auto"])
def test_of_a_package_with_c_plus_plus_everything_else_is_built_and_the_rest_is_named(
    workshop: Workshop, lists: str
) -> None:
    package(workshop, "day6_mixed", lists + REST, MIXED_FILES)
    done = workshop.run("colcon build")
    assert done.status == 0, done
    said = "left out of 'day6_mixed': executable talker; library filter.\n"
    assert f"--- stderr: day6_mixed\nday6-tui has no C++ compiler: {said}" in done.err
    assert ("Not found, and needed to compile it: OpenCV.\n" in done.err) == ("OpenCV" in lists)
    assert "only_a_test" not in done.err and "1 package had stderr output: day6_mixed" in done.out
    done = workshop.run("source install/setup.bash; ros2 run day6_mixed say.py; ros2 pkg executables day6_mixed")
    assert done.out == "said 3\nday6_mixed say.py\n", done
    assert (workshop.workspace / "install/day6_mixed/share/day6_mixed/launch/up.launch.py").is_file()


def test_ros2_run_of_what_was_left_out_says_why_there_is_no_such_program(workshop: Workshop) -> None:
    lists = package(workshop, "day6_mixed", PLAIN + REST, MIXED_FILES) / "CMakeLists.txt"
    workshop.run("colcon build")
    done = workshop.run("source install/setup.bash; ros2 run day6_mixed talker")
    assert (done.status, done.out) == (1, "")
    first, second, *more = done.err.splitlines()
    assert first == "No executable found" and "'talker'" in second and "C++" in second and not more
    assert workshop.run("source install/setup.bash; ros2 run day6_mixed other").err == "No executable found\n"
    edit(lists, "add_executable(talker src/talker.cpp)\n", "")
    workshop.run("colcon build")
    assert workshop.run("source install/setup.bash; ros2 run day6_mixed talker").err == "No executable found\n"


@pytest.mark.process
def test_the_words_of_install_may_stand_in_any_order(workshop: Workshop) -> None:
    """As packages of the ROS 2 tutorial of SmartArmStack have it: the permissions before the destination."""
    lists = """
install(DIRECTORY scripts/ FILE_PERMISSIONS OWNER_EXECUTE OWNER_WRITE OWNER_READ DESTINATION lib/${PROJECT_NAME})
install(FILES config/a.yaml COMPONENT data DESTINATION share/${PROJECT_NAME} RENAME b.yaml)
install(FILES nowhere.yaml OPTIONAL DESTINATION share/${PROJECT_NAME})
"""
    package(
        workshop, "day6_words", lists, {"scripts/say.py": "#!/usr/bin/env python3\nprint(1)\n", "config/a.yaml": ""}
    )
    done = workshop.run("colcon build")
    assert (done.status, done.err) == (0, ""), done
    assert workshop.run("source install/setup.bash; ros2 run day6_words say.py").out == "1\n"
    share = workshop.workspace / "install/day6_words/share/day6_words"
    assert sorted(path.name for path in share.glob("*.yaml")) == ["b.yaml"]


OFFICIAL = """\
add_executable(talker src/talker.cpp)
add_executable(of_mine src/of_mine.cpp)
install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})
"""


@pytest.mark.process
def test_a_program_that_was_left_out_is_the_one_that_day6_has_in_a_package_of_that_name(workshop: Workshop) -> None:
    """Built from source, ros2/demos hides the demo_nodes_cpp that was there before, with all of its programs."""
    launch = '<launch><node pkg="demo_nodes_cpp" exec="talker"/></launch>\n'
    package(workshop, "demo_nodes_cpp", OFFICIAL, {"launch/up.launch.xml": launch})
    done = workshop.run("colcon build")
    assert done.status == 0 and "left out of 'demo_nodes_cpp': executables talker, of_mine.\n" in done.err, done
    assert "day6-tui has its own versions of these programs and starts them instead: talker.\n" in done.err
    assert (
        workshop.run("source install/setup.bash; ros2 pkg executables demo_nodes_cpp").out == "demo_nodes_cpp talker\n"
    )
    for command in ("ros2 run demo_nodes_cpp talker", "ros2 launch demo_nodes_cpp up.launch.xml"):
        running = workshop.start(f"source install/setup.bash; {command}")
        workshop.wait(lambda done=running: "Publishing: 'Hello World: 1'" in done.err.text + done.out.text)
        running.program.interrupt()
        workshop.wait(lambda done=running: done.program.status is not None)
    said = workshop.run("source install/setup.bash; ros2 run demo_nodes_cpp of_mine").err
    assert said.startswith("No executable found\n('of_mine' is a C++ program")
    launch_file = workshop.workspace / "src/demo_nodes_cpp/launch/up.launch.xml"
    launch_file.write_text(launch.replace("talker", "of_mine"), encoding="utf-8")
    said = workshop.run(f"source install/setup.bash; ros2 launch '{launch_file}'").out
    assert "executable 'of_mine' of package 'demo_nodes_cpp' isn't there ('of_mine' is a C++ program" in said


@pytest.mark.parametrize(
    "lists",
    [
        "add_executable(node src/node.cpp)",
        "add_library(x SHARED x.cpp)\ninstall(DIRECTORY include/ DESTINATION include)",
    ],
)
def test_a_package_of_which_nothing_else_remains_is_left_out(workshop: Workshop, lists: str) -> None:
    package(workshop, "day6_cpp", lists, {"include/x.hpp": ""})
    done = workshop.run("colcon build")
    assert done.status == 0
    assert "day6-tui has no C++ compiler: left out of 'day6_cpp': " in done.err
    assert workshop.run("source install/setup.bash; ros2 pkg prefix day6_cpp").status == 0


def test_a_fault_in_the_messages_of_a_package_with_c_plus_plus_still_fails_it(workshop: Workshop) -> None:
    package(workshop, "day6_mixed", PLAIN + REST, {**MIXED_FILES, "msg/A.msg": "std_mgs/Header h\n"})
    done = workshop.run("colcon build")
    assert done.status == 1 and "KeyError: 'std_mgs'" in done.err


@pytest.mark.parametrize(
    ("lists", "error"),
    [
        ("while(TRUE)\nendwhile()", "runs at most"),
        ("function(f)\n  f()\nendfunction()\nf()", "Maximum recursion depth"),
        ("if(TRUE)", "Flow control statements are not properly nested."),
        ("set(x a)\n" + "list(APPEND x ${x})\n" * 60, "characters in a variable"),
        ("foreach(a RANGE 9999999999)\nendforeach()\nwhile(1)\nset(a 1)\nendwhile()", "runs at most"),
        ('message(FATAL_ERROR "Not with this ROS")', "  Not with this ROS\n"),
        ("if(A STREQUAL)\nendif()", "Unknown arguments specified"),
    ],
)
def test_a_lists_file_without_end_ends(workshop: Workshop, lists: str, error: str) -> None:
    package(workshop, "day6_own", lists, {})
    done = workshop.run("colcon build")
    assert done.status == 1 and error in done.err, done.err[-2000:]


def test_conditions_about_the_compiler_and_a_return_are_no_hindrance(workshop: Workshop) -> None:
    lists = """\
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang" AND ${CMAKE_CXX_COMPILER_VERSION} VERSION_LESS "16.0.0")
  message(FATAL_ERROR "no")
endif()
if(${NOBODY_KNOWS_THIS} STREQUAL "x")
endif()
macro(leave)
  if(NOT CMAKE_CXX_STANDARD AND (UNIX OR WIN32 OR APPLE))
    return()
  endif()
endmacro()
rosidl_generate_interfaces(${PROJECT_NAME} msg/A.msg)
leave()
message(FATAL_ERROR "never")"""
    package(workshop, "day6_own", lists, {"msg/A.msg": "int8 a\n"})
    done = workshop.run("colcon build")
    assert (done.status, done.err) == (0, ""), done


@pytest.mark.process
def test_other_files_of_the_package_are_read_too(workshop: Workshop) -> None:
    files = {
        "src/CMakeLists.txt": "add_executable(talker talker.cpp)\ninstall(PROGRAMS say.py DESTINATION lib/${PROJECT_NAME})\n",
        "src/say.py": "#!/usr/bin/env python3\nprint('from below')\n",
        "cmake/more.cmake": "rosidl_generate_interfaces(${PROJECT_NAME} msg/A.msg)\n",
        "msg/A.msg": "int8 a\n",
    }
    package(workshop, "day6_mixed", "include(cmake/more.cmake)\nadd_subdirectory(src)", files)
    done = workshop.run("colcon build > /dev/null; source install/setup.bash; ros2 run day6_mixed say.py")
    assert done.out == "from below\n" and "executable talker" in done.err


# -- what day6-tui has not ---------------------------------------------------------------------------------------------


def test_messages_for_which_a_package_of_ros_is_missing_are_left_out_with_those_that_use_them(
    workshop: Workshop,
) -> None:
    files = {"msg/A.msg": "geographic_msgs/GeoPoint p\n", "msg/B.msg": "A a\n", "msg/C.msg": "std_msgs/Header h\n"}
    package(workshop, "day6_own", generate(" ".join(files), "std_msgs geographic_msgs"), files, "geographic_msgs")
    more = {"srv/D.srv": "day6_own/B b\n---\n", "srv/E.srv": "day6_own/C c\n---\n"}
    package(workshop, "day6_more", generate(" ".join(more), "day6_own"), more, "day6_own")
    done = workshop.run("colcon build")
    assert done.status == 0, done.err
    assert (
        "day6-tui doesn't have these packages of ROS, which 'day6_own' looks for: geographic_msgs.\n"
        "It was built without them.\n"
        "Left out of 'day6_own': msg/A, msg/B (day6-tui doesn't have geographic_msgs)\n"
    ) in done.err
    assert "Left out of 'day6_more': srv/D (day6-tui doesn't have geographic_msgs)\n" in done.err
    said = workshop.run("source install/setup.bash; ros2 interface package day6_own; ros2 interface package day6_more")
    assert said.out == "day6_own/msg/C\nday6_more/srv/E\n"


def test_an_interface_in_idl_is_left_out(workshop: Workshop) -> None:
    files = {"msg/A.idl": "module day6_own { module msg { struct A { long x; }; }; };", "msg/B.msg": "int32 x\n"}
    package(workshop, "day6_own", generate(" ".join(files)), files)
    done = workshop.run("colcon build")
    assert done.status == 0, done.err
    assert "Left out of 'day6_own': msg/A (day6-tui reads .msg, .srv and .action, not .idl)\n" in done.err
    assert workshop.run("source install/setup.bash; ros2 interface package day6_own").out == "day6_own/msg/B\n"


@pytest.mark.parametrize(
    ("commands", "value"),
    [
        ('file(READ include/v.h x)\nstring(REGEX MATCH "MAJOR ([0-9]+)" _ "${x}")\nset(x ${CMAKE_MATCH_1})', "12"),
        (
            'file(STRINGS include/v.h x REGEX "MAJOR")\nstring(REGEX REPLACE ".*MAJOR ([0-9]+)" "v\\\\1.\\\\1" x "${x}")',
            "v12.12",
        ),
        ('string(REGEX MATCHALL "[a-c]+" x "ab1c2xb")', "ab;c;b"),
        ('string(LENGTH talker.cpp n)\nmath(EXPR n "${n} - 4")\nstring(SUBSTRING talker.cpp 0 ${n} x)', "talker"),
        (
            'string(SUBSTRING talker 2 -1 x)\nstring(STRIP "  ${x} " x)\nstring(FIND "${x}" k at)\nset(x ${x}${at})',
            "lker1",
        ),
        ('string(JOIN "-" x a b c)\nstring(PREPEND x "<")', "<a-b-c"),
        ('string(COMPARE EQUAL "a" "a" x)\nstring(REPEAT "ab" 2 y)\nset(x ${x}${y})', "1abab"),
        ("set(l a b c)\nlist(GET l 0 -1 x)\nlist(INSERT l 1 z)\nlist(FIND l z at)\nset(x ${x} ${at})", "a;c;1"),
        ('set(l a b c)\nlist(REMOVE_AT l 0)\nlist(JOIN l "+" x)\nlist(SUBLIST l 0 1 y)\nset(x ${x}${y})', "b+cb"),
        ("set(l a b c)\nlist(POP_BACK l x)\nlist(POP_FRONT l y)\nset(x ${x}${y}${l})", "cab"),
        ('math(EXPR x "(7 + 2) * 3 % 5 << 1")', "4"),
        ('math(EXPR x "255 & 0x1F" OUTPUT_FORMAT HEXADECIMAL)', "0x1f"),
    ],
)
def test_what_a_lists_file_works_out_is_what_cmake_works_out(workshop: Workshop, commands: str, value: str) -> None:
    """The values are those of cmake 3.25."""
    lists = f'{commands}\nif(NOT "${{x}}" STREQUAL "{value}")\n  message(FATAL_ERROR "it is ${{x}}")\nendif()'
    package(workshop, "day6_own", lists, {"include/v.h": "#define MAJOR 12\n#define MINOR 3\n"})
    done = workshop.run("colcon build")
    assert done.status == 0, done.err


def test_a_c_plus_plus_package_that_stops_itself_for_want_of_something_is_left_out(workshop: Workshop) -> None:
    lists = """\
find_package(Spinnaker)
if(NOT Spinnaker_FOUND)
  message(FATAL_ERROR "Install the Spinnaker SDK first")
endif()
add_executable(camera camera.cpp)
install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})
"""
    package(workshop, "day6_camera", lists, {"launch/up.launch.py": ""})
    done = workshop.run("colcon build")
    assert done.status == 0, done.err
    assert "left out of 'day6_camera': executable camera.\n" in done.err
    assert "Its CMakeLists.txt (line 7) would stop CMake here: Install the Spinnaker SDK first\n" in done.err
    assert (workshop.workspace / "install/day6_camera/share/day6_camera/launch/up.launch.py").is_file()


def test_a_left_out_component_is_listed_and_its_container_says_why_it_is_not_there(workshop: Workshop) -> None:
    lists = "add_library(parts SHARED parts.cpp)\nrclcpp_components_register_nodes(parts day6::Arm day6::Leg)\n"
    package(workshop, "day6_parts", lists, {})
    mine = "add_library(t SHARED t.cpp)\nrclcpp_components_register_node(t PLUGIN composition::Talker EXECUTABLE t)"
    package(workshop, "composition", mine, {})
    assert workshop.run("colcon build").status == 0
    shell = workshop.terminal()
    workshop.run("source install/setup.bash", shell)
    assert "day6_parts\n  day6::Arm\n  day6::Leg\n" in workshop.run("ros2 component types", shell).out
    said = workshop.run("ros2 component standalone day6_parts day6::Leg", shell)
    assert "lib/libparts.so is C++, and day6-tui runs no C++" in said.out + said.err
    running = workshop.start("ros2 component standalone composition composition::Talker", shell)
    workshop.wait(lambda: "Hello World: 1" in running.err.text + running.out.text)
    running.program.interrupt()
    workshop.wait(lambda: running.program.status is not None)


def test_what_the_build_of_cmake_would_make_is_not_missed_by_install(workshop: Workshop) -> None:
    lists = """\
add_custom_command(OUTPUT made.yaml COMMAND python3 make.py)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/made.yaml TYPE DATA)
install(FILES kept.yaml TYPE DATA)
install(FILES x.hpp TYPE INCLUDE)
"""
    package(workshop, "day6_own", lists, {"kept.yaml": "a: 1\n", "x.hpp": ""})
    done = workshop.run("colcon build")
    assert done.status == 0, done.err
    assert "Left out of 'day6_own': made.yaml (CMake itself makes it, and day6-tui doesn't run CMake)\n" in done.err
    prefix = workshop.workspace / "install/day6_own"
    assert (prefix / "share/kept.yaml").is_file() and (prefix / "include/x.hpp").is_file()
