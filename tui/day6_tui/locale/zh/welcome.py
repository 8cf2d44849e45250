"""The choices at the start, and the guide of an empty desk."""

TEXTS = {
    # welcome
    "welcome.title": "欢迎",
    "welcome.heading": "ROS 2，就在你的终端里",
    "welcome.question": "你想做什么？",
    "welcome.lessons": "上课",
    "welcome.lessons.on": "接着上次：{title}",
    "welcome.lessons.more": "六天的课程和排错练习",
    "welcome.keys": "↑ ↓ 加 Enter 或者按数字选择，也可以直接输入命令",
    "welcome.truth": "命令会一个字一个字地替你输入，你都看得见，它们就是真正的命令。",
    # guide
    "guide.title": "桌面",
    "guide.heading": "现在没有窗口。窗口由命令打开：",
    "guide.try": "按 Enter 或点一下，就会输入到终端里，由你来运行",
    "guide.ask": "看看现在发生了什么：",
    "guide.scene": "或者看我做一遍：",
    "help.guide": (
        "现在没有打开的窗口，这里列出几条值得一试的命令。用方向键和 Enter 选一条，或者点一下，它就会输入到终端里；"
        "在终端里再按一次 Enter 才会运行。\n\n最后几项会像老师一样，把一课的命令一条一条地替你输入。"
    ),
    "help.welcome": (
        "用方向键和 Enter 选择，也可以按数字或点鼠标。前三项会像老师一样，把命令一条一条地输入到终端里。\n\n"
        "直接输入命令也行，它会进到终端里。"
    ),
}
