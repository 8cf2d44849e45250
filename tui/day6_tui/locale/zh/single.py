"""One window on a real terminal."""

TEXTS = {
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
}
