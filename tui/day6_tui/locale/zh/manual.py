"""The manual: its titles in the order of its pages, and the pages of no window."""

TEXTS = {
    # help
    "help.title": "帮助",
    "help.keys": "↑ ↓ 滚动   Tab 下一页   Esc 返回",
    "help.everywhere": "到处都能用的按键",
    "help.desk": (
        "这是一台装了 ROS 2 的小 Ubuntu 电脑的桌面。桌面上有终端，你在里面输入命令；还有程序打开的窗口。\n\n"
        "这里发生的每一件事都来自一条命令。在这里学会的，到真正的 Ubuntu 上一样能用。\n\n"
        "用 day6-tui --detach 启动，桌面就不会随终端消失：F7 选“暂离”（或者直接关掉窗口），一切继续运行；day6-tui attach 再回来。"
    ),
    # 手册
    "help.search": "输入文字，在所有页里查找",
    "manual.desk": "桌面",
    "manual.welcome": "开始时的选项",
    "manual.guide": "可以试试的命令",
    "manual.terminal": "终端",
    "manual.editor": "编辑器",
    "manual.turtlesim": "turtlesim",
    "manual.car": "小车俯视图",
    "manual.world": "小世界",
    "manual.joint_state_publisher": "关节滑块",
    "manual.rviz2": "RViz",
    "manual.rqt": "rqt",
    "manual.rqt_graph": "rqt_graph",
    "manual.rqt_console": "rqt_console",
    "manual.rqt_bag": "rqt_bag",
    "manual.rqt_plot": "rqt_plot",
    "manual.service_caller": "服务调用器",
    "manual.publisher": "消息发布器",
    "manual.type_browser": "类型浏览器",
    "manual.action_browser": "动作类型浏览器",
    "manual.topics": "话题监视器",
    "manual.rqt_tf_tree": "TF 树",
    "manual.rqt_reconfigure": "参数调节",
    "manual.rqt_logger_level": "日志级别",
    "manual.rqt_image_view": "图像",
    "manual.showimage": "showimage",
    "manual.rqt_shell": "rqt 的 Shell",
    "manual.rqt_py_console": "rqt 的 Python 控制台",
    "manual.rqt_robot_steering": "机器人转向",
    "manual.inspector": "检查器",
    "manual.lesson": "课程",
    "manual.kitchen": "厨房",
    "manual.classroom": "班级",
    "manual.shown": "展示的屏幕",
    "manual.classroom_pupil": "上课：举手、老师",
}
