"""help, clear, which, type, whoami, hostname, uname, env, printenv, true, false, test, basename, dirname, seq."""

from __future__ import annotations

import os

from day6_core.session.session import Session
from day6_core.shell.builtins.options import complain, complain_as_shell
from day6_core.shell.language import file_tests
from day6_core.shell.language.conditional import shell_test
from day6_core.shell.language.interpreter import Shell, shell_of
from day6_core.shell.language.quoting import single_quoted
from day6_core.shell.language.words import SyntaxProblem

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


KEYWORDS = frozenset({"if", "then", "else", "elif", "fi", "for", "in", "while", "until", "do", "done", "case", "esac",
                       "function", "{", "}", "[[", "]]", "!", "time", "select", "coproc"})  # fmt: skip


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


def _kinds(name: str, shell: Shell) -> list[tuple[str, str]]:
    """What a name may mean, the first one first: the word of `type -t`, and the sentence or path."""
    from day6_core.shell.commands import SHELL_BUILTINS, where

    found: list[tuple[str, str]] = []
    if name in shell.aliases and "expand_aliases" in shell.settings:
        found.append(("alias", f"is aliased to `{shell.aliases[name]}'"))
    if name in KEYWORDS:
        found.append(("keyword", "is a shell keyword"))
    if name in shell.functions:
        found.append(("function", f"is a function\n{shell.functions[name].source}"))
    if name in SHELL_BUILTINS:
        found.append(("builtin", "is a shell builtin"))
    if "/" in name:
        path = shell.cwd / name
        if path.is_file() and os.access(path, os.X_OK):
            found.append(("file", name))
    elif place := where(name, shell):
        found.append(("file", place))
    return found


def _flags_and_names(session: Session) -> tuple[str, list[str]]:
    """The letters of the options in front, and the words behind them."""
    words = session.argv[1:]
    flags = ""
    while words and words[0].startswith("-") and len(words[0]) > 1:
        flags += words.pop(0)[1:]
    return flags, words


async def type_(session: Session) -> int:
    """`type [-atpPf] NAME …`."""
    shell = shell_of(session)
    flags, words = _flags_and_names(session)
    status = 0
    for name in words:
        kinds = [each for each in _kinds(name, shell) if not ("f" in flags and each[0] == "function")]
        if "P" in flags:
            kinds = [each for each in kinds if each[0] == "file"]
        if not kinds:
            status = 1
            if not set(flags) & set("tpP"):
                session.print_error(f"{shell.name}: type: {name}: not found")
        for kind, text in kinds if "a" in flags else kinds[:1]:
            if "t" in flags:
                session.print(kind)
            elif set(flags) & set("pP"):
                if kind == "file":
                    session.print(text)
            else:
                session.print(f"{name} is {text}" if kind == "file" else f"{name} {text}")
    return status


async def command(session: Session) -> int:
    """`command -v NAME`, `command -V NAME` and `command NAME …`."""
    from day6_core.shell.commands import find_command

    shell = shell_of(session)
    flags, words = _flags_and_names(session)
    if not words:
        return 0
    if not set(flags) & set("vV"):
        return await session.execute(find_command(words[0], shell, functions=False), words)
    status = 1
    for name in words:
        kinds = _kinds(name, shell)
        if not kinds:
            if "V" in flags:
                session.print_error(f"{shell.name}: command: {name}: not found")
            continue
        status = 0
        kind, text = kinds[0]
        if "V" in flags:
            session.print(f"{name} is {text}" if kind == "file" else f"{name} {text}")
        elif kind == "alias":
            session.print(f"alias {name}={single_quoted(shell.aliases[name])}")
        else:
            session.print(text if kind == "file" else name)
    return status


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
        return 0 if await _Test(session, words).holds() else 1
    except (ValueError, SyntaxProblem) as error:
        complain_as_shell(session, error)
        return 2


class _Test:
    """`test`: up to four words by their number, as POSIX says, more by a little grammar."""

    def __init__(self, session: Session, words: list[str]) -> None:
        self.session = session
        self.words = words
        self.at = 0

    async def holds(self) -> bool:
        words = self.words
        if len(words) <= 4 and (answer := await self._short(words)) is not None:
            return answer
        answer = await self._either()
        if self.at < len(words):
            raise ValueError("too many arguments")
        return answer

    async def _short(self, words: list[str]) -> bool | None:
        if len(words) <= 1:
            return bool(words and words[0])
        if len(words) == 2:
            if words[0] == "!":
                return not words[1]
            if words[0] in file_tests.UNARY:
                return await self._unary(words[0], words[1])
            raise ValueError(f"{words[0]}: unary operator expected")
        if len(words) == 3:
            if words[1] in _BINARY or words[1] in ("-a", "-o"):
                return self._binary(*words)
            if words[0] == "!":
                return not await self._short(words[1:])
            if words[0] == "(" and words[2] == ")":
                return bool(words[1])
            raise ValueError(f"{words[1]}: binary operator expected")
        if words[0] == "!":
            return not await self._short(words[1:])
        return await self._short(words[1:3]) if words[0] == "(" and words[3] == ")" else None

    async def _either(self) -> bool:
        answer = await self._both()
        while self._takes("-o"):
            other = await self._both()
            answer = answer or other
        return answer

    async def _both(self) -> bool:
        answer = await self._one()
        while self._takes("-a"):
            other = await self._one()
            answer = answer and other
        return answer

    def _takes(self, word: str) -> bool:
        if self.at < len(self.words) and self.words[self.at] == word:
            self.at += 1
            return True
        return False

    async def _one(self) -> bool:
        rest = self.words[self.at :]
        if not rest:
            raise ValueError("argument expected")
        if len(rest) > 2 and rest[1] in _BINARY:
            self.at += 3
            return self._binary(*rest[:3])
        if rest[0] == "!":
            self.at += 1
            return not await self._one()
        if rest[0] == "(":
            self.at += 1
            answer = await self._either()
            if not self._takes(")"):
                raise ValueError("`)' expected")
            return answer
        if rest[0] in file_tests.UNARY and len(rest) > 1:
            self.at += 2
            return await self._unary(rest[0], rest[1])
        self.at += 1
        return bool(rest[0])

    async def _unary(self, question: str, text: str) -> bool:
        shell = shell_of(self.session)
        return await shell_test(question, text, shell, shell.all_streams(self.session), self.session.cwd)

    def _binary(self, left: str, comparison: str, right: str) -> bool:
        if comparison in ("-a", "-o"):
            return bool(left and right) if comparison == "-a" else bool(left or right)
        if comparison in file_tests.INTEGER:
            return file_tests.integers(left, comparison, right)
        if comparison in ("=", "==", "!="):
            return (left == right) != (comparison == "!=")
        if comparison in ("<", ">"):
            return left < right if comparison == "<" else left > right
        return file_tests.files(left, comparison, right, self.session.cwd)


_BINARY = frozenset({"=", "==", "!=", "<", ">", *file_tests.INTEGER, *file_tests.FILES})


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
