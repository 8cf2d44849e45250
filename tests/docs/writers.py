"""Which modules write into files, and how long what they write has been in memory only: what is lost by `kill -9`.

`tests/project/test_late_writers.py` compares it with the sources; `tests/docs/reference.py` writes it into reference/files.md.
"""

from __future__ import annotations

import pkgutil
from typing import NamedTuple

from day6_core.ros.environment import activate
from day6_core.session.streams import FILE_BLOCK

Both = tuple[str, str]
"""A text in English and in Chinese."""


class Late(NamedTuple):
    """Something that is not written at once."""

    what: Both
    constant: str
    """Which constant says how many seconds it is in memory only, at the longest; '' if that is not a matter of time."""
    modules: tuple[str, ...]
    until: Both = ("", "")
    """Without a constant: what has to happen."""

    @property
    def seconds(self) -> float:
        activate()  # some are in the packages that programs import
        return float(pkgutil.resolve_name(self.constant))


LATE = (
    Late(
        ("text typed into the editor and not saved", "在编辑器里输入、还没有保存的文字"),
        "day6_tui.windows.editor.editor:KEEP_SECONDS",
        ("day6_core/shell/editing/copies.py",),
    ),
    Late(
        ("steps of lessons that were solved, exams", "课程里完成的步骤、测验"),
        "day6_core.lessons.course:LOOK_SECONDS",
        ("day6_core/lessons/progress.py",),
    ),
    Late(
        (
            "terminals (folder, text, what runs), the layout, what windows such as RViz show",
            "终端（目录、文字、正在运行的程序）、布局、RViz 等窗口显示的内容",
        ),
        "day6_tui.app:SAVE_SECONDS",
        ("day6_tui/features/saved_desktop.py",),
    ),
    Late(
        ("settings of plugins in a perspective of rqt", "rqt 的 perspective 里插件的设置"),
        "day6_core.ros.programs.rqt_gui.rqt_gui:KEEP_SECONDS",
        ("day6_core/ros/programs/rqt_gui/perspectives.py",),
    ),
    Late(
        ("messages that are recorded into a bag", "正在录进 bag 的消息"),
        "rosbag2_py._writer:FLUSH_SECONDS",
        (
            "day6_core/ros/python/rosbag2_py/_mcap_write.py",
            "day6_core/ros/python/rosbag2_py/_sqlite.py",
            "day6_core/ros/python/rosbag2_py/_writer.py",
        ),
    ),
    Late(
        (
            "output of a program of ours that goes into a file (`ros2 … > FILE`)",
            "写进文件的程序输出（`ros2 … > FILE`）",
        ),
        "",
        ("day6_core/session/streams.py",),
        (f"a block of {FILE_BLOCK:,} bytes is full, or the program ends", f"攒满 {FILE_BLOCK:,} 字节，或者程序结束"),
    ),
)
"""What is lost at most when day6-tui is killed."""

AT_ONCE: dict[str, tuple[str, ...]] = {
    "what the user has chosen or typed, with every change": (
        "day6_core/shell/line/history.py",
        "day6_tui/settings.py",
        "day6_tui/panes/arranging.py",
    ),
    "logs, recordings and what is open in a class, with every line": (
        "day6_core/classroom/journal.py",
        "day6_core/classroom/kept.py",
        "day6_core/ros/python/launch/logging/__init__.py",
        "day6_core/ros/python/rclpy/_day6/log_file.py",
        "day6_core/workspace/logs.py",
        "day6_tui/cast/recorder.py",
        "day6_tui/screen/log_file.py",
    ),
    "what a command or a key asks for, before it is done": (
        "day6_core/lessons/command.py",
        "day6_core/lessons/report.py",
        "day6_core/lessons/stage.py",
        "day6_core/lessons/submission.py",
        "day6_core/lessons/tables.py",
        "day6_core/lessons/grading/command.py",
        "day6_core/ros/programs/_drawn_pdf.py",
        "day6_tui/features/rewind.py",
        "day6_core/ros/programs/rqt_console/model.py",
        "day6_core/ros/programs/rqt_graph/model/image.py",
        "day6_core/ros/programs/rqt_graph/model/rqt_graph.py",
        "day6_core/ros/programs/rqt_image_view/model.py",
        "day6_core/ros/programs/rqt_reconfigure/model.py",
        "day6_core/ros/programs/rqt_tf_tree/model.py",
        "day6_core/ros/programs/rviz2/reading.py",
        "day6_core/ros/programs/tf2_tools/view_frames.py",
        "day6_core/ros/programs/urdfdom/urdf_to_graphviz.py",
        "day6_core/ros/python/rosbag2_py/_csv.py",
        "day6_core/ros/python/rosbag2_py/_metadata.py",
        "day6_core/ros/ros2/param/dump.py",
        "day6_core/shell/builtins/columns.py",
        "day6_core/shell/builtins/text.py",
        "day6_core/shell/builtins/transfer.py",
        "day6_core/shell/editing/file.py",
        "day6_core/shell/outward/ide.py",
        "day6_core/workspace/build_cmake.py",
        "day6_core/workspace/build_interfaces.py",
        "day6_core/workspace/build_python.py",
        "day6_core/workspace/colcon.py",
        "day6_core/workspace/create.py",
        "day6_core/workspace/export.py",
        "day6_core/workspace/files.py",
        "day6_core/workspace/left_out.py",
        "day6_core/workspace/package_tests.py",
        "day6_core/workspace/run_tests.py",
        "day6_core/workspace/setup_scripts.py",
        "day6_tui/cast/command.py",
        "day6_tui/windows/classroom/report.py",
        "day6_tui/wheelhouse/closure.py",
        "day6_tui/wheelhouse/folder.py",
        "day6_tui/wheelhouse/own_wheel.py",
        "day6_tui/windows/rviz/dialogs.py",
        "day6_urdf/shipped.py",
    ),
    "who may come into a class and which desktops run, before it counts": (
        "day6_core/isolation/users.py",
        "day6_tui/web/places.py",
        "day6_tui/web/records.py",
        "day6_tui/web/tokens.py",
    ),
    "a class's groups, assignments and marks, and files that a teacher hands out, as soon as the teacher asks for it": (
        "day6_tui/web/class_groups.py",
        "day6_core/classroom/handed.py",
        "day6_tui/web/pupil_files.py",
        "day6_tui/web/assignments.py",
        "day6_tui/classes/marks.py",
    ),
    "locks, sockets, copies and files of the system, which are made again": (
        "day6_core/isolation/enter.py",
        "day6_core/isolation/groups.py",
        "day6_tui/web/room.py",
        "day6_core/lessons/collected.py",
        "day6_core/lessons/grading/archive.py",
        "day6_core/lessons/grading/apart.py",
        "day6_core/lessons/work.py",
        "day6_core/lessons/grading/shield.py",
        "day6_core/link/file_lock.py",
        "day6_core/link/gateway.py",
        "day6_core/link/local/place.py",
        "day6_core/link/paths.py",
        "day6_core/link/state.py",
        "day6_core/ros/executables.py",
        "day6_core/ros/home_python.py",
        "day6_core/ros/programs/rqt_bag/model/loading.py",
        "day6_core/ros/python/rosbag2_py/_reader.py",
        "day6_core/ros/ros2/cli/lone_daemon.py",
        "day6_core/shell/outward/subshell.py",
    ),
    "pipes, descriptors and modes, no files of anybody": (
        "day6_core/lessons/grading/judge.py",
        "day6_core/lessons/grading/warden.py",
        "day6_core/ros/programs/xacro/limits.py",
        "day6_core/session/blocking_files.py",
        "day6_core/session/real_streams.py",
        "day6_core/session/watch.py",
        "day6_core/shell/builtins/search.py",
        "day6_core/shell/language/substitution.py",
        "day6_core/shell/process/prepared.py",
        "day6_core/shell/process/process.py",
        "day6_core/virtual/ready/becoming.py",
        "day6_tui/main.py",
        "day6_tui/textual_private/output.py",
    ),
    "trials, whose files nobody needs": (
        "day6_core/isolation/attacks.py",
        "day6_core/isolation/trial.py",
        "day6_core/lessons/drills/check_nightlamp.py",
    ),
    "the functions themselves": ("day6_core/whole_file.py",),
}
"""Modules that write before anything else happens, by what they write."""
