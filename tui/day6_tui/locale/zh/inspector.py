"""The inspector."""

TEXTS = {
    "inspector.title": "检查",
    "inspector.quiet": "不说话",
    "inspector.count": "{errors} 个错误，共 {all} 条",
    "inspector.count.one": "{errors} 个错误，共 {all} 条",
    "action.inspector": "检查",
    "help.action.inspector": "现在有什么问题，接下来输入什么",
    "help.inspector": (
        "现在有什么问题：计算图里的（名字差一个字母、类型或 QoS 对不上、两个发布者打架、机器人没有的关节），"
        "终端里的（没有 source、没有编译、程序报的错），文件里的（改了没有再编译、setup.py 少写了什么），"
        "还有程序里面的（没有 spin、回调一直不返回）。\n\n"
        "标红的会让东西不能用。下面那一行是接下来可以输入的命令：按 Enter 或者点一下，它就写进终端，"
        "再按一次 Enter 才会运行。\n\n"
        "检查器只是看：它不在任何列表和数目里。练习和考试里，问题解决或放弃以前，它什么也不说。"
    ),
}
