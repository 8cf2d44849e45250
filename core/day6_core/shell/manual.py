"""The pages of `man`: what a command is for, in the language of the terminal, with examples. Our own short texts."""

from __future__ import annotations

from typing import NamedTuple


class Page(NamedTuple):
    """A page: the command's synopsis, what it does in English and Chinese, examples."""

    usage: str
    english: str
    chinese: str
    examples: tuple[str, ...] = ()


_PAGES: dict[str, Page] = {
    "man": Page("man COMMAND", "show what a command does; q quits", "显示一个命令的说明；按 q 退出", ("man ls",)),
    "ls": Page("ls [-l] [-a] [PLACE...]", "list files and folders", "列出文件和文件夹", ("ls -la", "ls src")),
    "cd": Page(
        "cd [FOLDER]", "go to a folder, or home without one", "进入文件夹；不写就回主目录", ("cd ~/ros2_ws", "cd ..")
    ),
    "pwd": Page("pwd", "print the folder you are in", "显示现在所在的文件夹"),
    "mkdir": Page(
        "mkdir [-p] FOLDER...",
        "make folders; -p also makes those above",
        "新建文件夹；-p 连上级一起建",
        ("mkdir -p ~/ros2_ws/src",),
    ),
    "touch": Page("touch FILE...", "make an empty file, or update its time", "新建空文件，或更新文件时间"),
    "cp": Page("cp [-r] FROM... TO", "copy; -r with everything inside", "复制；-r 连里面的一起复制"),
    "mv": Page("mv FROM... TO", "move or rename", "移动或改名"),
    "rm": Page("rm [-r] NAME...", "delete for good; -r with everything inside", "彻底删除；-r 连里面的一起删除"),
    "cat": Page("cat [FILE...]", "print files", "显示文件内容", ("cat package.xml",)),
    "less": Page(
        "less FILE", "read a file page by page: space, b, /text, n, q", "一页一页地看文件：空格、b、/查找、n、q"
    ),
    "head": Page("head [-n COUNT] [FILE]", "print the first lines", "开头几行"),
    "tail": Page("tail [-n COUNT] [-f] [FILE]", "print the last lines; -f waits for more", "最后几行；-f 等着看新的"),
    "grep": Page(
        "grep [-i] [-n] [-r] TEXT [FILE...]",
        "print the lines that contain a text",
        "找出含有某段文字的行",
        ("ros2 pkg list | grep day6", "grep -rn create_publisher src"),
    ),
    "find": Page(
        "find [FOLDER] [-name PATTERN] [-type f|d]",
        "look for files by name",
        "按名字找文件",
        ("find . -name '*.urdf'",),
    ),
    "tree": Page("tree [-L DEPTH] [FOLDER]", "show a folder as a tree", "用树的形式显示文件夹"),
    "wc": Page("wc [-l] [FILE...]", "count lines, words and bytes", "数行数、词数、字节数"),
    "sort": Page("sort [-n] [-r] [FILE...]", "sort lines", "按行排序"),
    "uniq": Page("uniq [-c] [FILE]", "drop repeated lines", "去掉相邻的重复行"),
    "cut": Page("cut -d CHARACTER -f NUMBERS [FILE]", "print some columns", "只取某几列"),
    "tr": Page("tr FROM TO", "replace characters one by one", "逐个替换字符"),
    "rev": Page("rev [FILE...]", "print every line backwards", "把每一行倒过来显示"),
    "sed": Page("sed [-i] 's/OLD/NEW/g' [FILE...]", "replace text in lines", "替换每行里的文字"),
    "diff": Page("diff [-u] OLD NEW", "show how two files differ", "比较两个文件的不同"),
    "chmod": Page("chmod +x FILE", "make a file executable", "让文件可以执行"),
    "echo": Page(
        "echo TEXT", "print a text; > writes, >> appends to a file", "输出文字；> 写入文件，>> 追加到文件末尾"
    ),
    "export": Page(
        "export NAME=VALUE", "set a variable for this terminal", "在这个终端里设置变量", ("export ROS_DOMAIN_ID=5",)
    ),
    "source": Page(
        "source FILE",
        "run a file's lines in this terminal; their settings stay. Every terminal has its own environment",
        "在当前终端里执行一个文件，设置会留下来。每个终端的环境是各自的",
        ("source install/setup.bash",),
    ),
    "history": Page("history", "list the lines typed so far", "看以前输入过的命令"),
    "alias": Page("alias NAME='COMMAND'", "define a short name for a command", "给命令起一个短名字"),
    "watch": Page(
        "watch [-n SECONDS] COMMAND",
        "run a command again and again and show its output; Ctrl-C ends it",
        "反复执行一个命令并显示它的输出；按 Ctrl-C 结束",
        ("watch -n 1 ros2 topic list",),
    ),
    "xargs": Page(
        "xargs [-n COUNT] [-I TEXT] COMMAND",
        "turn the incoming words into arguments of a command",
        "把输入的单词变成一个命令的参数",
        ("find src -name '*.py' | xargs grep import",),
    ),
    "ln": Page(
        "ln -s TARGET [NAME]", "make a link: another name for a file or folder", "建立链接：给文件或文件夹另一个名字"
    ),
    "wget": Page(
        "wget [-O FILE] ADDRESS",
        "save a file from the web, if this machine is online",
        "把网上的一个文件保存下来（需要能上网）",
    ),
    "jobs": Page("jobs", "list this terminal's background jobs", "这个终端的后台任务"),
    "kill": Page("kill [-SIGNAL] %JOB|PID", "end a program", "结束一个程序", ("kill %1",)),
    "sleep": Page("sleep SECONDS", "wait", "等待几秒"),
    "timeout": Page("timeout SECONDS COMMAND", "end a command after some time", "让命令运行一段时间后结束"),
    "which": Page("which COMMAND", "show where a command is", "命令在哪里"),
    "nano": Page(
        "nano FILE",
        "edit a file: Ctrl-S or Ctrl-O saves, Ctrl-X quits",
        "编辑文件：Ctrl-S 或 Ctrl-O 保存，Ctrl-X 退出",
    ),
    "python3": Page("python3 FILE", "run a Python program", "运行 Python 程序", ("python3 talker.py",)),
    "sudo": Page("sudo COMMAND", "run as administrator; not needed here", "用管理员身份执行；这里用不着"),
    "apt": Page(
        "apt install NAME", "install packages; everything is already installed here", "安装软件包；这里需要的都已经有了"
    ),
    "rosdep": Page(
        "rosdep install --from-paths src -y",
        "install what a workspace's packages depend on",
        "安装工作空间里的包所依赖的东西",
    ),
    "colcon": Page(
        "colcon build [--symlink-install] [--packages-select NAME]",
        "build the packages of a workspace. Run it in the folder above src, then source install/setup.bash",
        "编译工作空间里的包。要在 src 的上一级文件夹里运行，然后 source install/setup.bash",
        ("cd ~/ros2_ws", "colcon build --symlink-install", "source install/setup.bash"),
    ),
    "ros2": Page(
        "ros2 COMMAND VERB",
        "the ROS 2 command line; ros2 --help lists all commands, ros2 topic --help those about topics",
        "ROS 2 的命令行；ros2 --help 列出所有命令，ros2 topic --help 列出和话题有关的",
        ("ros2 run turtlesim turtlesim_node", "ros2 topic echo /turtle1/pose"),
    ),
    "why": Page(
        "why [NUMBER]",
        "explain this terminal's last message: its meaning, its cause here, what to type next; why 2: the one before",
        "解释这个终端最后的那句报错：什么意思、为什么、接着输入什么；why 2 解释再前面一句",
        ("why", "colcon build 2>&1 | why"),
    ),
    "explain": Page(
        "explain [TEXT|TOPIC]",
        "explain a message; without a text, list all topics",
        "解释一句话；不写就列出能解释哪些",
        ("explain \"Package 'car' not found\"", "explain build"),
    ),
    "rqt_graph": Page("rqt_graph", "draw which node talks to which", "画出节点之间的关系"),
    "rviz2": Page("rviz2 [-d FILE]", "show a robot and its frames in 3-D", "在三维里看机器人和坐标系"),
    "check_urdf": Page(
        "check_urdf FILE", "check a robot description", "检查机器人描述文件", ("check_urdf day6_bot.urdf",)
    ),
}


def page(name: str, language: str) -> str | None:
    """Return the page of a command in a language; None if there is none."""
    found = _PAGES.get(name)
    if found is None:
        return None
    chinese = language == "zh"
    head, use, examples = ("名称", "用法", "例子") if chinese else ("NAME", "SYNOPSIS", "EXAMPLES")
    lines = [head, f"       {name} - {found.chinese if chinese else found.english}", "", use, f"       {found.usage}"]
    if found.examples:
        lines += ["", examples, *(f"       {example}" for example in found.examples)]
    return "\n".join([*lines, ""])
