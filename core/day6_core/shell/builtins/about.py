"""help, clear, which, type, whoami, hostname, uname, env, printenv, true, false, test, basename, dirname, seq."""

from __future__ import annotations

from day6_core.session.session import Session
from day6_core.shell.builtins.options import complain, complain_as_shell
from day6_core.shell.language import file_tests
from day6_core.shell.language.interpreter import shell_of

_HELP = {
    "en": """\
Commands of this terminal (they work as on Ubuntu):

  ros2 ...            nodes, topics, services, parameters, actions; ros2 --help lists all
  ros2 run PACKAGE EXECUTABLE      e.g. ros2 run turtlesim turtlesim_node
  rqt_graph           who talks to whom, as a picture
  rviz2               robots, frames and sensor data in 3-D
  python3 FILE        run your own program
  why                 what the last error means, and what to type next

  cd ls cat pwd mkdir touch cp mv rm tree      folders and files
  echo grep head tail wc sort                  text; A | B sends the output of A to B
  jobs fg bg kill wait, COMMAND &              programs in the background
  sleep timeout date history clear exit        and more: {others}

  Ctrl-C ends the running program, Ctrl-D the terminal, Tab completes, Up brings back the last line.""",
    "zh": """\
这个终端的命令（用法和 Ubuntu 上一样）：

  ros2 ...            节点、话题、服务、参数、动作；ros2 --help 列出全部
  ros2 run PACKAGE EXECUTABLE      运行包里的程序，例如 ros2 run turtlesim turtlesim_node
  rqt_graph           画出谁在和谁通信
  rviz2               机器人、坐标系和传感器数据的三维画面
  python3 FILE        运行你自己的程序
  why                 刚才的报错是什么意思，接着输入什么

  cd ls cat pwd mkdir touch cp mv rm tree      文件夹和文件
  echo grep head tail wc sort                  文字；A | B 把 A 的输出交给 B
  jobs fg bg kill wait , COMMAND &             在后台运行的程序
  sleep timeout date history clear exit        还有 {others}

  Ctrl-C 结束正在运行的程序，Ctrl-D 关闭终端，Tab 补全，↑ 找回上一条命令。""",
}


_KEYWORDS = frozenset({"if", "then", "else", "elif", "fi", "for", "in", "while", "until", "do", "done", "case", "esac",
                       "function", "{", "}", "[[", "]]", "!", "time"})  # fmt: skip


async def help_(session: Session) -> int:
    from day6_core.language import language_of
    from day6_core.shell.commands import command_names

    text = _HELP[language_of(session.env)]
    mentioned = set(text.replace(",", " ").replace(";", " ").split())
    others = [name for name in command_names() if name not in mentioned and name.isalpha()]
    session.print(text.replace("{others}", " ".join(others)))
    return 0


async def clear(session: Session) -> int:
    if session.stdout.isatty():
        session.stdout.control("\x1b[H\x1b[2J\x1b[3J")
    return 0


async def which(session: Session) -> int:
    from day6_core.shell.commands import where

    status = 0
    for name in session.argv[1:]:
        if name.startswith("-"):
            continue
        place = where(name, shell_of(session))
        if place:
            session.print(place)
        else:
            status = 1
    return status


async def type_(session: Session) -> int:
    from day6_core.shell.commands import SHELL_BUILTINS, where

    status = 0
    for name in session.argv[1:]:
        if name in shell_of(session).aliases:
            session.print(f"{name} is aliased to `{shell_of(session).aliases[name]}'")
        elif name in _KEYWORDS:
            session.print(f"{name} is a shell keyword")
        elif name in shell_of(session).functions:
            session.print(f"{name} is a function\n{shell_of(session).functions[name].source}")
        elif name in SHELL_BUILTINS:
            session.print(f"{name} is a shell builtin")
        elif place := where(name, shell_of(session)):
            session.print(f"{name} is {place}")
        else:
            session.print_error(f"{shell_of(session).name}: type: {name}: not found")
            status = 1
    return status


async def command(session: Session) -> int:
    """`command -v NAME` and `command NAME …`."""
    from day6_core.shell.commands import SHELL_BUILTINS, find_command, where

    words = session.argv[1:]
    if not words:
        return 0
    if words[0] in ("-v", "-V"):
        own = SHELL_BUILTINS | shell_of(session).functions.keys()
        found = [where(name, shell_of(session)) or (name if name in own else "") for name in words[1:]]
        for place in found:
            if place:
                session.print(place)
        return 0 if any(found) else 1
    return await session.execute(find_command(words[0], shell_of(session)), words)


async def whoami(session: Session) -> int:
    session.print(shell_of(session).desk.user)
    return 0


async def id_(session: Session) -> int:
    """`id`; `id -u`, `-g` and `-G` are numbers, with `-n` names."""
    name = shell_of(session).desk.user
    letters = "".join(word[1:] for word in session.argv[1:] if word.startswith("-"))
    if set(letters) & set("ugG"):
        session.print(name if "n" in letters else "1000")
    else:
        session.print(f"uid=1000({name}) gid=1000({name}) groups=1000({name})")
    return 0


async def hostname(session: Session) -> int:
    from day6_core.shell.desk import HOST

    session.print(HOST)
    return 0


async def uname(session: Session) -> int:
    from day6_core.shell.desk import HOST

    wide = any("a" in word for word in session.argv[1:])
    session.print(f"Linux {HOST} day6-tui" if wide else "Linux")
    return 0


async def printenv(session: Session) -> int:
    names = session.argv[1:]
    if not names:
        for name, value in session.env.items():
            session.print(f"{name}={value}")
        return 0
    for name in names:
        if name in session.env:
            session.print(session.env[name])
    return 0 if all(name in session.env for name in names) else 1


async def env(session: Session) -> int:
    """`env` prints; `env A=1 COMMAND …` runs a command with more variables."""
    from day6_core.shell.commands import find_command

    words = session.argv[1:]
    if words and words[0] in ("-i", "-"):
        session.env = {}
        words = words[1:]
    while words and "=" in words[0]:
        name, _, value = words.pop(0).partition("=")
        session.env[name] = value
    if not words:
        for name, value in session.env.items():
            session.print(f"{name}={value}")
        return 0
    return await session.execute(find_command(words[0], shell_of(session)), words)


async def true(session: Session) -> int:
    return 0


async def false(session: Session) -> int:
    return 1


async def test(session: Session) -> int:
    words = session.argv[1:]
    if session.name == "[" and (not words or words.pop() != "]"):
        session.print_error(f"{shell_of(session).name}: [: missing `]'")
        return 2
    try:
        return 0 if _test(session, words) else 1
    except ValueError as error:
        complain_as_shell(session, error)
        return 2


def _test(session: Session, words: list[str]) -> bool:
    for word, combine in (("-o", any), ("-a", all)):
        if word in words[1:-1]:
            at = words.index(word, 1)
            return combine((_test(session, words[:at]), _test(session, words[at + 1 :])))
    if words and words[0] == "!":
        return not _test(session, words[1:])
    if len(words) <= 1:
        return bool(words and words[0])
    if len(words) == 2:
        return file_tests.unary(words[0], words[1], session.cwd)
    if len(words) > 3:
        raise ValueError("too many arguments")
    left, comparison, right = words
    if comparison in file_tests.INTEGER:
        return file_tests.integers(left, comparison, right)
    if comparison in ("=", "==", "!="):
        return (left == right) != (comparison == "!=")
    if comparison in ("<", ">"):
        return left < right if comparison == "<" else left > right
    if comparison in file_tests.FILES:
        return file_tests.files(left, comparison, right, session.cwd)
    raise ValueError(f"{comparison}: binary operator expected")


async def basename(session: Session) -> int:
    if len(session.argv) < 2:
        complain(session, f"missing operand\nTry '{session.name} --help' for more information.")
        return 1
    name = session.argv[1].rstrip("/").rpartition("/")[2] or "/"
    suffix = session.argv[2] if len(session.argv) > 2 else ""
    session.print(name.removesuffix(suffix) if name != suffix else name)
    return 0


async def dirname(session: Session) -> int:
    if len(session.argv) < 2:
        complain(session, f"missing operand\nTry '{session.name} --help' for more information.")
        return 1
    for word in session.argv[1:]:
        head, slash, _ = (word.rstrip("/") or word[:1] * 2).rpartition("/")
        session.print(head.rstrip("/") or (slash or "."))
    return 0


async def seq(session: Session) -> int:
    try_help = "Try 'seq --help' for more information."
    try:
        numbers = [float(word) if "." in word else int(word) for word in session.argv[1:]]
    except ValueError:
        complain(session, f"invalid floating point argument: ‘{session.argv[-1]}’\n{try_help}")
        return 1
    if not 1 <= len(numbers) <= 3:
        complain(
            session, ("missing operand" if not numbers else f"extra operand ‘{session.argv[4]}’") + f"\n{try_help}"
        )
        return 1
    first = numbers[0] if len(numbers) > 1 else 1
    step = numbers[1] if len(numbers) == 3 else 1
    if step == 0:
        complain(session, f"invalid Zero increment value: ‘{session.argv[2]}’\n{try_help}")
        return 1
    digits = max(len(word.partition(".")[2]) for word in (session.argv[1], session.argv[-2]))
    value, count = first, 0
    while (value <= numbers[-1]) if step > 0 else (value >= numbers[-1]):
        session.print(f"{value:.{digits}f}")
        count += 1
        value = first + count * step
        await session.stdout.drain()
    return 0
