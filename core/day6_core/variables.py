"""Every environment variable that day6-tui reads: what it does and what holds without it, in both languages.

`day6-tui doctor` and the page of the documentation are made from this table; a test finds what the sources read.
"""

from __future__ import annotations

from typing import NamedTuple

from day6_core.language import Pair

NONE: Pair = ("", "")

GROUPS: dict[str, Pair] = {
    "choice": ("Choices of day6-tui", "day6-tui 的选项"),
    "folders": ("Folders", "文件夹"),
    "ros": ("ROS 2, launch and colcon", "ROS 2、launch 和 colcon"),
    "terminal": ("Terminal and locale", "终端和区域设置"),
    "system": ("The system and Python", "系统和 Python"),
    "hub": ("JupyterHub (`hub/jupyterhub_config.py`)", "JupyterHub（`hub/jupyterhub_config.py`）"),
    "internal": ("Set by day6-tui itself for the programs it starts", "day6-tui 自己为它启动的程序设置"),
}


class Variable(NamedTuple):
    """One variable; texts are plain, with code between `."""

    name: str
    group: str
    """A key of GROUPS."""
    text: Pair
    """What it does."""
    default: Pair = NONE
    """What holds without it."""
    secret: bool = False
    """Its value is never shown."""

    @property
    def internal(self) -> bool:
        """Whether it is not for users."""
        return self.group == "internal"


def shown_value(name: str, value: str) -> str:
    """Return the value for a report that others read: that of a secret is hidden, also where nobody knows the variable."""
    row = next((each for each in VARIABLES if each.name == name), None)
    hidden = any(word in name for word in ("SECRET", "PASSWORD", "TOKEN", "WORD", "KEY")) if row is None else row.secret
    return "***" if hidden and value else value


VARIABLES = (
    Variable(
        "DAY6_LANG",
        "choice",
        (
            "Language of day6-tui: `zh` or `en`. `--lang` goes before it.",
            "day6-tui 的语言：`zh` 或 `en`。`--lang` 优先。",
        ),
        ("that of the locale", "按区域设置"),
    ),
    Variable(
        "DAY6_GLYPHS",
        "choice",
        (
            "What `day6-tui rviz2` and other single windows are drawn with: `pixels`, `half`, `braille`, `cell` or `ascii`.",
            "`day6-tui rviz2` 等单个窗口用什么绘制：`pixels`、`half`、`braille`、`cell` 或 `ascii`。",
        ),
        ("by terminal", "按终端选择"),
    ),
    Variable(
        "DAY6_HINTS",
        "choice",
        (
            "`off` (or `0`, `no`, `false`) prints no hints below error messages.",
            "设为 `off`（或 `0`、`no`、`false`）时，报错下面不显示提示。",
        ),
        ("hints are printed", "显示提示"),
    ),
    Variable(
        "DAY6_MEMORY_LIMIT",
        "choice",
        (
            "Megabytes that each program of a user may have; `0` sets no limit.",
            "用户的每个程序最多可用多少 MB 内存；`0` 表示不限制。",
        ),
        ("60 % of the machine's memory, at least 1024", "本机内存的 60 %，至少 1024"),
    ),
    Variable(
        "DAY6_LINK",
        "choice",
        (
            "How programs of this machine meet: `off` keeps each one alone, `tcp` uses TCP on 127.0.0.1, `local` avoids Zenoh.",
            "本机的程序怎样互相连接：`off` 表示互不连接，`tcp` 表示用 127.0.0.1 上的 TCP，`local` 表示不用 Zenoh。",
        ),
        (
            "Zenoh, where it is installed; Unix sockets, TCP on Windows",
            "装了 Zenoh 就用 Zenoh；Unix 套接字，Windows 上用 TCP",
        ),
    ),
    Variable(
        "DAY6_LOG",
        "choice",
        (
            "A file for day6-tui's own log, for finding faults in day6-tui.",
            "day6-tui 自己的日志写入这个文件，用来查 day6-tui 的问题。",
        ),
        ("no log", "不写日志"),
    ),
    Variable(
        "DAY6_WATCH",
        "choice",
        (
            "For developers: a file for the stack of whatever blocks the thread on which all programs run.",
            "供开发者使用：所有程序共用的线程一旦被阻塞，就把调用栈写入这个文件。",
        ),
        ("nothing is watched", "不监视"),
    ),
    Variable(
        "TEXTUAL_FPS",
        "choice",
        ("Most frames a second, as `--fps`; read by Textual.", "每秒最多刷新几帧，同 `--fps`；由 Textual 读取。"),
        ("30", "30"),
    ),
    Variable(
        "DAY6_RUNTIME_DIR",
        "folders",
        (
            "The folder of the sockets by which the programs of one user meet. It must be the user's own.",
            "同一用户的程序用来互相连接的套接字所在的文件夹，必须属于该用户。",
        ),
        ("`$XDG_RUNTIME_DIR/day6`, else `/tmp/day6-<uid>`", "`$XDG_RUNTIME_DIR/day6`，否则 `/tmp/day6-<uid>`"),
    ),
    Variable(
        "XDG_RUNTIME_DIR",
        "folders",
        ("The system's folder for sockets of a user.", "系统为用户的套接字提供的文件夹。"),
        NONE,
    ),
    Variable(
        "XDG_DATA_HOME",
        "folders",
        (
            "The folder that holds `day6-tui`, the folder of settings, desktops and classes (Linux).",
            "其中的 `day6-tui` 文件夹存放设置、桌面和班级的数据（Linux）。",
        ),
        ("`~/.local/share`", "`~/.local/share`"),
    ),
    Variable(
        "LOCALAPPDATA",
        "folders",
        (
            "The same on Windows, where the sockets' folder is in it, too.",
            "Windows 上的同类文件夹；套接字的文件夹也在其中。",
        ),
        (r"`%USERPROFILE%\AppData\Local`", r"`%USERPROFILE%\AppData\Local`"),
    ),
    Variable(
        "HOME",
        "folders",
        (
            "Your home folder. In the terminals of the desktop it is the desktop's own folder.",
            "你的主目录。在桌面的终端里，它是桌面自己的文件夹。",
        ),
        NONE,
    ),
    Variable(
        "TMPDIR",
        "folders",
        ("The folder for temporary files.", "存放临时文件的文件夹。"),
        ("`/tmp`", "`/tmp`"),
    ),
    Variable(
        "ROS_HOME",
        "folders",
        ("The folder that holds `log`, as in ROS.", "其中的 `log` 存放日志，与 ROS 相同。"),
        ("`~/.ros`", "`~/.ros`"),
    ),
    Variable(
        "ROS_LOG_DIR",
        "folders",
        (
            "The folder for the log files of nodes and launch, as in ROS.",
            "节点和 launch 的日志文件所在的文件夹，与 ROS 相同。",
        ),
        ("`$ROS_HOME/log`", "`$ROS_HOME/log`"),
    ),
    Variable(
        "ROS_DOMAIN_ID",
        "ros",
        (
            "The domain: programs see each other only where it is the same.",
            "域：只有域相同的程序才能看到彼此。",
        ),
        ("0", "0"),
    ),
    Variable(
        "ROS_DISTRO",
        "ros",
        (
            "The distribution in use: `humble`, `jazzy`, `kilted`, `lyrical` or `rolling`. `--distro` goes before it.",
            "day6-tui 代表哪个 ROS 发行版：`humble`、`jazzy`、`kilted`、`lyrical` 或 `rolling`。`--distro` 优先。",
        ),
        (
            "what `~/.bashrc` sources, else as chosen last, else `jazzy`",
            "`~/.bashrc` 里 source 的，否则上次选择的，否则 `jazzy`",
        ),
    ),
    Variable(
        "ROS_VERSION",
        "ros",
        ("Reported by `ros2 doctor`, as in ROS.", "`ros2 doctor` 会报告它，与 ROS 相同。"),
        ("2", "2"),
    ),
    Variable(
        "ROS_AUTOMATIC_DISCOVERY_RANGE",
        "ros",
        ("`OFF` lets a program find no other one.", "设为 `OFF` 时，程序不会发现任何其他程序。"),
        ("programs of this machine are found", "发现本机的程序"),
    ),
    Variable(
        "ROS_PYTHON_CHECK_FIELDS",
        "ros",
        (
            "`0`: values for the fields of messages aren't checked. `1`: also numeric arrays take only what fits exactly.",
            "`0`：给消息的字段赋值不检查；`1`：数字的数组也只收类型完全一样的值。",
        ),
        ("single values are checked", "检查单个的值"),
    ),
    Variable(
        "RCUTILS_CONSOLE_OUTPUT_FORMAT",
        "ros",
        ("The form of log lines, as in ROS.", "日志行的格式，与 ROS 相同。"),
        ("`[{severity}] [{time}] [{name}]: {message}`", "`[{severity}] [{time}] [{name}]: {message}`"),
    ),
    Variable(
        "RCUTILS_COLORIZED_OUTPUT",
        "ros",
        ("`1` colours log lines always, `0` never.", "`1` 总是给日志行上色，`0` 从不上色。"),
        ("where a terminal shows them", "输出到终端时上色"),
    ),
    Variable(
        "RCUTILS_LOGGING_USE_STDOUT",
        "ros",
        ("`1` writes log lines to standard output.", "设为 `1` 时，日志行写到标准输出。"),
        ("standard error; `1` in a notebook", "标准错误；在 notebook 中是 `1`"),
    ),
    Variable(
        "RMW_IMPLEMENTATION",
        "ros",
        (
            "Only reported by `get_rmw_implementation_identifier()`; it chooses nothing.",
            "只由 `get_rmw_implementation_identifier()` 报告，不起选择作用。",
        ),
        ("`rmw_fastrtps_cpp`", "`rmw_fastrtps_cpp`"),
    ),
    Variable(
        "RMW_IMPLEMENTATIONS",
        "ros",
        (
            "Limits what `get_available_rmw_implementations()` returns, as in ROS.",
            "限制 `get_available_rmw_implementations()` 返回的内容，与 ROS 相同。",
        ),
        NONE,
    ),
    Variable(
        "AMENT_PREFIX_PATH",
        "ros",
        (
            "The installed packages of sourced workspaces, as in ROS.",
            "已经 source 的工作空间里安装的功能包，与 ROS 相同。",
        ),
        NONE,
    ),
    Variable(
        "COLCON_PREFIX_PATH",
        "ros",
        ("The `install` folders of sourced workspaces.", "已经 source 的工作空间的 `install` 文件夹。"),
        NONE,
    ),
    Variable(
        "CMAKE_PREFIX_PATH",
        "ros",
        ("The inspector reports folders in it that are gone.", "检查器会指出其中已经不存在的文件夹。"),
        NONE,
    ),
    Variable(
        "COLCON_DEFAULT_EXECUTOR",
        "ros",
        (
            "As `colcon build --executor`: `sequential` builds one package after the other.",
            "同 `colcon build --executor`：`sequential` 表示逐个构建。",
        ),
        ("`parallel`", "`parallel`"),
    ),
    Variable("COLCON_LOG_PATH", "ros", ("As `colcon --log-base`.", "同 `colcon --log-base`。"), ("`log`", "`log`")),
    Variable(
        "COLCON_LOG_LEVEL",
        "ros",
        (
            "As `colcon --log-level`: `error` hides colcon's warnings.",
            "同 `colcon --log-level`：`error` 不显示 colcon 的警告。",
        ),
        ("`warning`", "`warning`"),
    ),
    Variable(
        "COLCON_HOME",
        "ros",
        ("The folder with colcon's `defaults.yaml`.", "colcon 的 `defaults.yaml` 所在的文件夹。"),
        ("`~/.colcon`", "`~/.colcon`"),
    ),
    Variable(
        "COLCON_DEFAULTS_FILE",
        "ros",
        ("The file with default values of colcon's options.", "写有 colcon 选项默认值的文件。"),
        ("`defaults.yaml` in `COLCON_HOME`", "`COLCON_HOME` 里的 `defaults.yaml`"),
    ),
    Variable(
        "OVERRIDE_LAUNCH_PROCESS_OUTPUT",
        "ros",
        ("Where launch writes what processes print, as in ROS.", "launch 把进程的输出写到哪里，与 ROS 相同。"),
        ("what the launch file says", "按 launch 文件"),
    ),
    Variable(
        "OVERRIDE_LAUNCH_SCREEN_FORMAT",
        "ros",
        ("The form of launch's lines on the screen, as in ROS.", "launch 在屏幕上的行的格式，与 ROS 相同。"),
        ("`default`", "`default`"),
    ),
    Variable(
        "OVERRIDE_LAUNCH_LOG_FORMAT",
        "ros",
        ("The form of launch's lines in log files, as in ROS.", "launch 在日志文件里的行的格式，与 ROS 相同。"),
        ("`default`", "`default`"),
    ),
    Variable(
        "DISABLE_ROS_ISOLATION",
        "ros",
        (
            "If set, `colcon test` lets the tests of packages share a domain.",
            "设置后，`colcon test` 让各功能包的测试共用一个域。",
        ),
        ("each package has its own", "每个功能包一个域"),
    ),
    Variable(
        "TURTLEBOT3_MODEL",
        "ros",
        (
            "The robot of `turtlebot3_teleop`: `burger`, `waffle` or `waffle_pi`.",
            "`turtlebot3_teleop` 的机器人：`burger`、`waffle` 或 `waffle_pi`。",
        ),
        ("`burger`", "`burger`"),
    ),
    Variable(
        "TERM",
        "terminal",
        ("The kind of terminal: characters and number of colours.", "终端的类型：决定能显示的字符和颜色数。"),
        NONE,
    ),
    Variable(
        "COLORTERM",
        "terminal",
        ("`truecolor` or `24bit`: the terminal has all colours.", "`truecolor` 或 `24bit`：终端支持全部颜色。"),
        NONE,
    ),
    Variable(
        "NO_COLOR",
        "terminal",
        ("If not empty, nothing is coloured.", "不为空时，一律不上色。"),
        NONE,
    ),
    Variable(
        "TERM_PROGRAM",
        "terminal",
        (
            "Names the terminal; iTerm2 is recognised by it, and where Option isn't Alt, so that no key with Alt is named.",
            "终端程序的名字，用来识别 iTerm2，以及 Option 不能当 Alt 用的终端：那里的提示不会写带 Alt 的键。",
        ),
        NONE,
    ),
    Variable(
        "TMUX",
        "terminal",
        ("Set inside tmux, where no pixels are drawn.", "在 tmux 里由 tmux 设置；此时不画像素。"),
        NONE,
    ),
    Variable(
        "STY",
        "terminal",
        ("Set inside screen, where no pixels are drawn.", "在 screen 里由 screen 设置；此时不画像素。"),
        NONE,
    ),
    Variable(
        "SSH_CONNECTION",
        "terminal",
        ("Set by ssh; only reported by `day6-tui doctor`.", "由 ssh 设置；只由 `day6-tui doctor` 报告。"),
        NONE,
    ),
    Variable(
        "COLUMNS",
        "terminal",
        ("Width of the text of `--help`.", "`--help` 文字的宽度。"),
        ("that of the terminal", "终端的宽度"),
    ),
    Variable(
        "LINES",
        "terminal",
        (
            "Kept from programs in a terminal of the desktop, whose size changes.",
            "不传给桌面终端里的程序，因为终端大小会变。",
        ),
        NONE,
    ),
    Variable(
        "LC_ALL",
        "terminal",
        ("The locale: language and encoding, before all others.", "区域设置：语言和编码，优先于其他变量。"),
        NONE,
    ),
    Variable("LC_CTYPE", "terminal", ("The encoding of the terminal.", "终端的编码。"), NONE),
    Variable("LC_MESSAGES", "terminal", ("The language.", "语言。"), NONE),
    Variable("LANGUAGE", "terminal", ("The language.", "语言。"), NONE),
    Variable(
        "LANG",
        "terminal",
        ("The locale: language and encoding.", "区域设置：语言和编码。"),
        NONE,
    ),
    Variable(
        "PATH",
        "system",
        (
            "Where programs are found. Those of day6-tui come first in the programs it starts.",
            "在哪里找程序。在 day6-tui 启动的程序里，day6-tui 的命令排在最前面。",
        ),
        NONE,
    ),
    Variable("PATHEXT", "system", ("Ends of names of programs (Windows).", "程序文件名的后缀（Windows）。"), NONE),
    Variable(
        "PYTHONPATH",
        "system",
        (
            "Folders of Python packages. Those of a real ROS are left out, so that its `rclpy` does not hide ours.",
            "Python 包的文件夹。真正的 ROS 的文件夹会去掉，以免它的 `rclpy` 盖住这里的。",
        ),
        NONE,
    ),
    Variable(
        "VIRTUAL_ENV",
        "system",
        (
            "A venv that you have activated in a terminal of the desktop: its Python runs your programs.",
            "你在桌面终端里激活的 venv：用它的 Python 运行你的程序。",
        ),
        NONE,
    ),
    Variable(
        "PYTHONHOME",
        "system",
        ("Python's own; `day6-tui doctor` warns of it.", "Python 自己的变量；设置了它时 `day6-tui doctor` 会提醒。"),
    ),
    Variable(
        "PYTHONHASHSEED",
        "system",
        (
            "Set to `0` in virtual time (`--fast`), unless you set it.",
            "在虚拟时间里（`--fast`）设为 `0`，除非你已设置。",
        ),
    ),
    Variable(
        "PYTHONUNBUFFERED",
        "system",
        ("Set to `1` for programs in a pipe, unless you set it.", "程序接在管道里时设为 `1`，除非你已设置。"),
        NONE,
    ),
    Variable(
        "PYTHONUTF8",
        "system",
        (
            "Set to `1` for the interpreter that runs a `setup.py`.",
            "运行 `setup.py` 的解释器里设为 `1`。",
        ),
    ),
    Variable(
        "PYTHONIOENCODING",
        "system",
        (
            "Set to `utf-8` for programs in a pipe on Windows, unless you set it.",
            "Windows 上程序接在管道里时设为 `utf-8`，除非你已设置。",
        ),
        NONE,
    ),
    Variable(
        "PYTHONDONTWRITEBYTECODE",
        "system",
        ("Ignored while `colcon build` installs a Python package.", "`colcon build` 安装 Python 包时忽略它。"),
        NONE,
    ),
    Variable(
        "SETUPTOOLS_USE_DISTUTILS",
        "system",
        ("Set to `local` while `setup.py` runs, unless you set it.", "运行 `setup.py` 时设为 `local`，除非你已设置。"),
        NONE,
    ),
    Variable(
        "SHELL",
        "system",
        ("The shell of `day6-tui shell`.", "`day6-tui shell` 使用的 shell。"),
        ("`/bin/sh`", "`/bin/sh`"),
    ),
    Variable(
        "COMSPEC",
        "system",
        ("The shell of `day6-tui shell` on Windows.", "Windows 上 `day6-tui shell` 使用的 shell。"),
        ("`cmd.exe`", "`cmd.exe`"),
    ),
    Variable(
        "ZDOTDIR",
        "system",
        ("Where zsh's own files are, for `day6-tui shell`.", "zsh 自己的文件在哪里，供 `day6-tui shell` 使用。"),
        ("`~`", "`~`"),
    ),
    Variable(
        "DISPLAY",
        "system",
        (
            "Without it, a launch file's `xterm -e …` is left out and the program runs in the same terminal.",
            "没有设置时，launch 文件里的 `xterm -e …` 会省略，程序在同一个终端里运行。",
        ),
        NONE,
    ),
    Variable(
        "JUPYTERHUB_USER",
        "system",
        ("Set by JupyterHub: the name of the pupil.", "由 JupyterHub 设置：学生的名字。"),
        ("the user's name", "用户名"),
    ),
    Variable(
        "PYTEST_XDIST_WORKER",
        "system",
        (
            "Set by pytest-xdist in its workers, of which each has a graph of its own.",
            "由 pytest-xdist 在它的工作进程里设置；每个工作进程有自己的计算图。",
        ),
    ),
    Variable(
        "DAY6_HUB_WORD",
        "hub",
        ("The word of the class: at least eight characters of ASCII.", "班级口令：至少八个 ASCII 字符。"),
        NONE,
        secret=True,
    ),
    Variable(
        "DAY6_HUB_TEACHER_WORD",
        "hub",
        (
            "The teacher's word (at least 32 characters of ASCII), with which the name `teacher` logs in.",
            "老师的口令（至少 32 个 ASCII 字符），用名字 `teacher` 登录时使用。",
        ),
        NONE,
        secret=True,
    ),
    Variable(
        "DAY6_HUB_AS_ROOT",
        "hub",
        (
            "`1` starts the hub as root all the same; every pupil is root then.",
            "设为 `1` 时，允许用 root 启动 hub；这时每个学生都是 root。",
        ),
        ("root is refused", "拒绝 root"),
    ),
    Variable(
        "DAY6_HUB_ACCOUNTS",
        "hub",
        (
            "`1`: pupils log in with Unix accounts in place of the word.",
            "设为 `1` 时，学生用 Unix 账户登录，不用口令。",
        ),
        ("the word is used", "用口令"),
    ),
    Variable(
        "DAY6_HUB_GROUP",
        "hub",
        ("The group whose accounts may log in.", "哪个组的账户可以登录。"),
        ("`day6`", "`day6`"),
    ),
    Variable(
        "DAY6_HUB_TEACHERS",
        "hub",
        ("The group whose accounts reach `/hub/admin`.", "哪个组的账户可以打开 `/hub/admin`。"),
        ("`day6-teachers`", "`day6-teachers`"),
    ),
    Variable(
        "DAY6_HUB_DATA",
        "hub",
        ("The folder for homes and what the hub remembers.", "存放学生主目录和 hub 数据的文件夹。"),
        ("the current folder", "当前文件夹"),
    ),
    Variable(
        "DAY6_HUB_URL",
        "hub",
        ("Where the hub listens.", "hub 在哪个地址监听。"),
        ("`http://127.0.0.1:8000`", "`http://127.0.0.1:8000`"),
    ),
    Variable(
        "DAY6_DISTRO",
        "internal",
        ("The distribution of the `day6-tui` that started this program.", "启动本程序的 `day6-tui` 的 ROS 发行版。"),
    ),
    Variable(
        "DAY6_INSIDE",
        "internal",
        ("The home folder of the kept desktop that this program runs in.", "本程序所在的常驻桌面的主目录。"),
    ),
    Variable(
        "DAY6_JOB",
        "internal",
        ("Marks what a program has started, so that it can be ended with it.", "标记程序启动的进程，以便一同结束。"),
    ),
    Variable(
        "DAY6_KEEPER",
        "internal",
        ("The line of a kept desktop to its keeper.", "常驻桌面与它的看守进程之间的连接。"),
    ),
    Variable(
        "DAY6_LAUNCH_HOST",
        "internal",
        ("How the process of a launch file reaches `ros2 launch`.", "launch 文件的进程怎样连接 `ros2 launch`。"),
    ),
    Variable(
        "DAY6_PYTHON",
        "internal",
        ("The interpreter of our executables on Windows.", "Windows 上这些可执行文件使用的 Python 解释器。"),
    ),
    Variable(
        "DAY6_TIME",
        "internal",
        (
            "The folder of the world whose virtual time a program follows (`--fast`).",
            "程序所在的虚拟时间世界的文件夹（`--fast`）。",
        ),
    ),
    Variable(
        "DAY6_ROOM",
        "internal",
        (
            "Room in memory, where the system is shown the words and variables of graded programs.",
            "内存里的一块地方，系统从那里看到被评分程序的命令行和变量。",
        ),
    ),
    Variable(
        "DAY6_REWIND",
        "internal",
        (
            "The folder with what a desktop in virtual time plays again (`--virtual-time`).",
            "虚拟时间里的桌面要重放的内容所在的文件夹（`--virtual-time`）。",
        ),
    ),
    Variable(
        "DAY6_SITE_PACKAGES",
        "internal",
        (
            "Folders of the packages that programs have besides those that `pip` installs in their home.",
            "程序除了用 `pip` 装在自己主目录里的包以外，还能用的包所在的文件夹。",
        ),
    ),
    Variable(
        "DAY6_TEST_RUN",
        "internal",
        (
            "Tells the workers of pytest-xdist that the graph they inherit is that of the whole run.",
            "告诉 pytest-xdist 的工作进程：它们继承到的计算图属于整次测试运行。",
        ),
    ),
)
