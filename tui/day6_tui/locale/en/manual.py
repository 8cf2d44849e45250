"""The manual: its titles in the order of its pages, and the pages of no window."""

TEXTS = {
    # help
    "help.title": "Help",
    "help.keys": "↑ ↓ scroll   Tab next page   Esc back",
    "help.everywhere": "Keys that work everywhere",
    "help.desk": (
        "This is the desktop of a small Ubuntu computer with ROS 2. It has terminals, where you type commands, and the "
        "windows that programs open.\n\n"
        "Nothing happens here unless a command causes it. Everything you learn here works the same on a real Ubuntu.\n\n"
        "If you start it with day6-tui --detach, the desktop outlives its terminal: leave it with F7, Detach, or just "
        "close the terminal's window, and everything keeps running; day6-tui attach brings it back."
    ),
    # the manual
    "help.search": "type to search all pages",
    "manual.desk": "The desktop",
    "manual.welcome": "The start menu",
    "manual.guide": "Commands to try",
    "manual.terminal": "Terminals",
    "manual.editor": "The editor",
    "manual.turtlesim": "turtlesim",
    "manual.car": "The car from above",
    "manual.world": "The world",
    "manual.joint_state_publisher": "Joint sliders",
    "manual.rviz2": "RViz",
    "manual.rqt": "rqt",
    "manual.rqt_graph": "rqt_graph",
    "manual.rqt_console": "rqt_console",
    "manual.rqt_bag": "rqt_bag",
    "manual.rqt_plot": "rqt_plot",
    "manual.service_caller": "Service Caller",
    "manual.publisher": "Message Publisher",
    "manual.type_browser": "Type browsers",
    "manual.action_browser": "Action Type Browser",
    "manual.topics": "Topic Monitor",
    "manual.rqt_tf_tree": "TF Tree",
    "manual.rqt_reconfigure": "Parameter Reconfigure",
    "manual.rqt_logger_level": "Logger Level",
    "manual.rqt_image_view": "Image View",
    "manual.showimage": "showimage",
    "manual.rqt_shell": "Shell of rqt",
    "manual.rqt_py_console": "Python Console of rqt",
    "manual.rqt_robot_steering": "Robot Steering",
    "manual.inspector": "Inspector",
    "manual.lesson": "Lessons",
    "manual.kitchen": "Kitchen",
    "manual.classroom": "Class",
    "manual.shown": "A screen that is shown",
    "manual.classroom_pupil": "Class: hand, teacher",
}
