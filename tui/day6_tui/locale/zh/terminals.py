"""Terminals, and one window on a real terminal."""

TEXTS = {
    # one window on a real terminal
    "single.end": "结束",
    "single.help": "帮助",
    "single.log": "日志",
    "single.next": "换窗口",
    "single.no_log": "程序还没有输出任何内容。",
    "help.single.end": "结束程序",
    "help.single.help": "说明这个窗口",
    "help.single.log": "查看程序的输出；程序结束后这些内容也会打印在终端里",
    "help.single.next": "切换到该程序的下一个窗口（如果有多个）",
    "help.single.glyphs": "换一套字符来画图",
    "help.single.language": "切换语言：English",
    "help.single.suspend": "暂停程序并回到命令行，用 fg 继续",
    # terminal
    "window.hidden": "{title} 打开了：按 {key} 去看",
    "terminal.stubborn": "它不理会 Ctrl-C。按 Ctrl-\\ 可以结束它；或者先按 Ctrl-Z，再输入 kill -9 %%",
    "glyphs.no_chinese": "中文要用 UTF-8 的 locale 才能显示，比如 LANG=C.UTF-8，所以现在是英文",
    "input.gbk": "你的终端发送的是 GBK 而不是 UTF-8：请把终端编码设为 UTF-8（PuTTY：Window > Translation）",
    "input.not_utf8": "你的终端发送的不是 UTF-8：请把终端编码设为 UTF-8",
    "pixels.slow": "这条连接传送像素图太慢，已改用字符来画",
    "pixels.missing": "用像素画图需要 pillow，这里没有安装：pip install pillow",
    "terminal.hint": "{keys}只在这个终端里有用：点一下这里，或按 {key}",
    "terminal.hint.short": "{keys}：点这里，或按 {key}",
    "terminal.arrows": "{keys}只在终端 {number}（遥控）里有用：按 {key} 切换过去",
    "terminal.not_arrows": "这个程序不用方向键驾驶，要用{keys}",
    "teleop.arrows": "方向键",
    "teleop.twist_keyboard": "按键 i j k l 和逗号",
    "teleop.turtlebot3": "按键 w a d x 和 s",
    "teleop.other": "这个程序的按键",
    "terminal.scrolled": "下面还有 {count} 行 · 按任意键回到底部",
    "terminal.close.title": "关闭终端",
    "terminal.close.ask": "{what} 还在里面运行。结束它吗？",
    "terminal.copied": "已复制",
    "terminal.no_room": "开不了新终端：运行的程序太多了。先结束一些（Ctrl-C、kill、关掉它们的终端）",
    "help.terminal": (
        "这是终端：输入一条命令，按 Enter 运行。\n\n"
        "Tab 补全，↑ 找回以前的命令，Ctrl-R 搜索历史。Ctrl-C 结束正在运行的程序，在空行上按 Ctrl-D 结束 shell。"
        "Ctrl-Z 再输入 bg 让程序到后台去；命令末尾写 & 也一样。\n\n"
        "看到报错，按 F1（或者输入 why）：它说是什么意思、为什么会这样、接着输入什么。"
        "点一下那行报错，或者选中它再按 F1 也行。\n\n"
        "Shift+PageUp 或鼠标滚轮可以往回看。用鼠标拖选就会复制；Shift+Insert 或鼠标中键粘贴。\n\n"
        "~ 是你的主目录。这里的主目录不是 /home/用户名：先输入 cd，再输入 pwd，就能看到它在硬盘上的真实位置。"
    ),
}
