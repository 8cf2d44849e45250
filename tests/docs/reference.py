"""The pages of the documentation that are made from the program: `python -m tests.docs.reference` writes them.

Command line from the parsers, keys from the table of actions and the manual, environment variables and places from their tables,
how lessons are written from the text that `day6-tui lessons help` prints, what was run where from tests/platforms/runs.json.
"""

from __future__ import annotations

import argparse
import re
from collections.abc import Callable, Iterable, Iterator
from itertools import groupby

from day6_core.command_line.parser import CommandParser
from day6_core.language import said
from day6_core.lessons.command import WRITING
from day6_core.places import PLACES
from day6_core.variables import GROUPS, VARIABLES
from day6_core.workspace.option import Option, Treated
from day6_core.workspace.options import BEFORE_VERB, OPTIONS, options_of
from day6_tui.actions import ACTIONS
from day6_tui.commands.desktop import build_parser
from day6_tui.commands.table import commands
from day6_tui.locale import Texts
from day6_tui.overlays.manual import pages as manual_pages
from tests.docs.pages import DOCS, LANGUAGES
from tests.docs.writers import LATE, Late
from tests.platforms.features import FEATURES, REASONS
from tests.platforms.play import acts
from tests.platforms.rows import UNTRIED, recorded
from tests.support.source_files import ROOT

END = "<!-- end of what is generated -->\n"
"""Where a table ends that is generated; the rest of its page is written by hand."""
MADE = "<!-- Made by `python -m tests.docs.reference`; what it says is changed where it is declared. -->\n"

# What stands on the pages besides the program's own texts.
WORDS = {
    "command_line": ("The command line", "命令行"),
    "command_line.intro": (
        "`day6-tui COMMAND --help` says the same. Every command also has `-h` (`--help`) and `--lang zh` or `--lang en`.",
        "`day6-tui COMMAND --help` 显示同样的内容。每个命令还有 `-h`（`--help`）和 `--lang zh`、`--lang en`。",
    ),
    "desktop": ("The desktop", "桌面"),
    "shared": ("Of the desktop's options it has ", "和桌面相同的选项："),
    "comma": (", ", "、"),
    "stop": (".", "。"),
    "option": ("argument or option", "参数或选项"),
    "command": ("command", "命令"),
    "does": ("does", "作用"),
    "means": ("means", "含义"),
    "keys": ("Keys", "按键"),
    "keys.intro": (
        "F1 shows the same in the desktop, beginning with the focused pane.",
        "在桌面里按 F1 看到的是同样的内容，从当前窗格开始。",
    ),
    "key": ("key", "按键"),
    "palette": ("Commands of the palette (F7)", "命令面板（F7）里的命令"),
    "environment": ("Environment variables", "环境变量"),
    "environment.intro": (
        "What an option of the command line says wins over the variable.",
        "命令行选项优先于环境变量。",
    ),
    "variable": ("variable", "变量"),
    "without": ("without it", "不设置时"),
    "what": ("what", "内容"),
    "colcon": ("The options of colcon", "colcon 的选项"),
    "colcon.intro": (
        "`colcon` is part of day6-tui. Its options and help are those of colcon-core 0.21 with the extensions that ROS 2 "  # noqa: ISC004
        "installs. No option is ignored in silence. Defaults from `~/.colcon/defaults.yaml` and from the workspace's "
        "`colcon_defaults.yaml` count.",
        "day6-tui 自带 `colcon`，选项和帮助与 colcon-core 0.21 加上 ROS 2 一起装的扩展相同。没有哪个选项会被悄悄忽略。"  # noqa: ISC004
        "`~/.colcon/defaults.yaml` 和工作空间里 `colcon_defaults.yaml` 写的默认值也有效。",
    ),
    "colcon.of": ("of", "属于"),
    "colcon.why": ("why", "原因"),
    "colcon.refused": ("Refused, with the reason", "不接受，并说明原因"),
    "colcon.said": ("Accepted; colcon says that it has no effect here", "接受，但会说明它在这里不起作用"),
    "colcon.obeyed": ("The same as in colcon", "和 colcon 一样"),
    "removed": ("removed by `day6-tui uninstall`", "用 `day6-tui uninstall` 删除"),
    "whose.ours": ("`--data`", "`--data`"),
    "run": ("run", "运行"),
    "run.on": ("on", "系统"),
    "run.python": ("Python", "Python"),
    "run.lacks": ("without", "缺少"),
    "run.date": ("date", "日期"),
    "run.commit": ("commit", "提交"),
    "feature": ("feature", "功能"),
    "feature.key": ("name", "名称"),
    "feature.typed": ("what is typed", "输入的命令"),
    "cell.yes": ("yes", "可以"),
    "cell.fails": ("fails", "失败"),
    "cell.never": ("never run", "从未运行"),
    "late.what": ("what", "内容"),
    "late.longest": ("at the latest on the disk after", "最迟多久写到磁盘上"),
    "whose.user": ("`--files`: it is your work", "`--files`：这是你自己的文件"),
    "whose.ros": ("never: a real ROS 2 uses it, too", "不删除：真正的 ROS 2 也用它"),
}


def word(key: str, language: str) -> str:
    """Return a text of ours in a language."""
    return said(WORDS[key], language)


def table(head: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    """Return a table of Markdown, whose cells are Markdown already."""
    lines = [[*head], *([*row] for row in rows)]
    lines.insert(1, ["---"] * len(lines[0]))
    return "".join(f"| {' | '.join(cell.replace('|', chr(92) + '|') for cell in line)} |\n" for line in lines)


def prose(text: str) -> str:
    """Return a text of the program, with code between `, as Markdown in one line."""
    parts = " ".join(text.split("\n")).split("`")
    parts[::2] = (re.sub(r"([\\*<]|\b_|_\b)", r"\\\1", part) for part in parts[::2])
    return re.sub(r"^([-+#>] )", r"\\\1", "`".join(parts))


def code(text: str) -> str:
    """Return a text as code, also one that has a ` in it."""
    return f"`` {text} ``" if "`" in text else f"`{text}`"


# -- the pages ---------------------------------------------------------------------------------------------------------


def command_line(language: str) -> Iterator[str]:
    """Every command by its group, with its arguments and options."""
    yield f"# {word('command_line', language)}\n"
    yield MADE
    yield f"{word('command_line.intro', language)}\n"
    every = list(commands())
    texts = next(parser.texts for each in every if (parser := each.parser(language)) is not None)
    for group, members in groupby(every, lambda each: each.group):
        title = texts(f"cli.group.{group}") if group else word("desktop", language)
        yield f"## {title[0].upper()}{title[1:]}\n"
        plain = []
        for each in members:
            if (parser := each.parser(language)) is None:
                plain.append((code(each.name), prose(each.summary(language))))
            else:
                yield from _command(parser, language, 3)
        if plain:
            yield table((word("command", language), word("does", language)), plain)


def _command(parser: CommandParser, language: str, level: int) -> Iterator[str]:
    yield f"{'#' * level} {parser.prog}\n"
    for paragraph in (parser.description or "").split("\n"):
        yield f"{prose(paragraph)}\n"
    of_desktop = {_written(each) for each in build_parser(language).actions} if parser.prog != "day6-tui" else set()
    said_above = ("help", "lang", "verb")
    own = [each for each in parser.actions if each.help != argparse.SUPPRESS and each.dest not in said_above]
    shared = [each for each in own if _written(each) in of_desktop]
    shared = shared if len(shared) > len(of_desktop) / 2 else []
    rows = [(code(_written(each)), prose(_help(each))) for each in own if each not in shared]
    if rows:
        yield table((word("option", language), word("means", language)), rows)
    if shared:
        names = (code(each.option_strings[-1]) for each in shared)
        yield f"{word('shared', language)}{word('comma', language).join(names)}{word('stop', language)}\n"
    for verb in parser.verbs.values():
        yield from _command(verb, language, level + 1)


def _written(action: argparse.Action) -> str:
    """Return an argument or option as one types it: `--step NAME`, `FILE …`, `[FILE]`."""
    value = f"{{{','.join(map(str, action.choices))}}}" if action.choices and not action.metavar else action.metavar
    shown = str(value or action.dest.upper())
    shown = {"+": f"{shown} …", "*": f"[{shown} …]", "?": f"[{shown}]"}.get(str(action.nargs), shown)
    if not action.option_strings:
        return shown
    return " ".join([", ".join(action.option_strings), *([] if action.nargs == 0 else [shown])])


def _help(action: argparse.Action) -> str:
    return (action.help or "") % vars(action)


def keys(language: str) -> Iterator[str]:
    """The keys of the desktop, the commands of the palette, and each page of the manual."""
    texts = Texts(language)
    yield f"# {word('keys', language)}\n"
    yield MADE
    yield f"{word('keys.intro', language)}\n"
    yield f"## {texts('help.everywhere')}\n"
    rows = [(code(each.label), _action(texts, each.id)) for each in ACTIONS if each.label]
    panes = (line.partition("\t") for line in texts("help.panes").split("\n"))
    yield table(
        (word("key", language), word("does", language)), [*rows, *((code(key), prose(what)) for key, _, what in panes)]
    )
    yield f"## {word('palette', language)}\n"
    named = [
        (prose(texts(f"action.{each.id}")), prose(texts(f"help.action.{each.id}")))
        for each in ACTIONS
        if each.palette and not each.label
    ]
    yield table((word("command", language), word("does", language)), named)
    for page in manual_pages():
        yield f"## {prose(texts(f'manual.{page}'))}\n"
        yield from _manual_page(texts(f"help.{page}"), language)


def _action(texts: Texts, action: str) -> str:
    return prose(texts("list.head", name=texts(f"action.{action}")) + texts(f"help.action.{action}"))


def _manual_page(text: str, language: str) -> Iterator[str]:
    """A page of the manual; its lines with a tab are keys with what they do."""
    for has_keys, lines in groupby((line for line in text.split("\n") if line), lambda line: "\t" in line):
        if has_keys:
            rows = (line.partition("\t") for line in lines)
            yield table(
                (word("key", language), word("does", language)), [(code(key), prose(what)) for key, _, what in rows]
            )
        else:
            yield from (f"{prose(line)}\n" for line in lines)


def environment(language: str) -> Iterator[str]:
    """The environment variables, by group."""
    yield f"# {word('environment', language)}\n"
    yield MADE
    yield f"{word('environment.intro', language)}\n"
    for group, title in GROUPS.items():
        rows = [
            (code(each.name), prose(said(each.text, language)), prose(said(each.default, language)))
            for each in VARIABLES
            if each.group == group
        ]
        yield f"## {prose(said(title, language))}\n"
        yield table((word("variable", language), word("does", language), word("without", language)), rows)


def colcon(language: str) -> Iterator[str]:
    """The options of colcon's verbs: what each does here."""
    yield f"# {word('colcon', language)}\n"
    yield MADE
    yield f"{word('colcon.intro', language)}\n"
    rows: dict[str, tuple[Option, list[str]]] = {}
    for verb in ("", *OPTIONS):
        for option in options_of(verb) if verb else BEFORE_VERB.options:
            rows.setdefault(option.name, (option, []))[1].append(f"colcon {verb}".strip())
    for treated in (Treated.REFUSED, Treated.SAID):
        yield f"## {word(f'colcon.{treated.name.lower()}', language)}\n"
        unlike = [(option, verbs) for option, verbs in rows.values() if option.treated is treated]
        head = (word("option", language), word("colcon.of", language), word("colcon.why", language))
        comma = word("comma", language)
        yield table(head, ((code(o.name), comma.join(map(code, of)), prose(said(o.why, language))) for o, of in unlike))
    yield f"## {word('colcon.obeyed', language)}\n"
    for verb in OPTIONS:
        names = (code(each.name) for each in options_of(verb) if each.treated is Treated.OBEYED and each.name[0] == "-")
        yield f"- {code(f'colcon {verb}')}: {word('comma', language).join(names)}"
    yield ""


def places(language: str) -> str:
    """Everything that is written outside of the package, by system."""
    systems = {"linux": "Linux", "darwin": "macOS", "win32": "Windows"}
    rows = [
        (
            prose(said(each.text, language)),
            *(code(shown) if (shown := each.shown(system)) else "" for system in systems),
            word(f"whose.{each.whose}", language),
        )
        for each in PLACES
    ]
    return table((word("what", language), *systems.values(), word("removed", language)), rows)


def late(language: str) -> str:
    """The table of what is not written at once."""

    def longest(each: Late) -> str:
        return f"{each.seconds:g} s" if each.constant else said(each.until, language)

    head = (word("late.what", language), word("late.longest", language))
    return table(head, ((said(each.what, language), longest(each)) for each in LATE))


def runs(language: str) -> str:
    """The machines on which features were tried, each feature on each of them, and what is typed for it."""
    rows = recorded()
    head = (word(f"run{key}", language) for key in ("", ".on", ".python", ".lacks", ".date", ".commit"))
    of_runs = ((r.name, r.release, r.python, code(r.lacks) if r.lacks else "", r.date, code(r.commit)) for r in rows)
    never = [system for system in UNTRIED if not any(row.system.startswith(system) for row in rows)]
    names = (word("feature", language), *(row.name for row in rows), *never)
    cells = (
        (
            f"{said(feature.name, language)} ({code(feature.key)})",
            *(_cell(row.cells.get(feature.key, "never"), language) for row in rows),
            *(word("cell.never", language) for _ in never),
        )
        for feature in FEATURES
    )
    typed = (
        (code(feature.key), "; ".join(code(act.typed) for act in acts(feature) if act.typed and act.where != "browser"))
        for feature in FEATURES
    )
    third = (word("feature.key", language), word("feature.typed", language))
    return "\n".join((table(head, of_runs), table(names, cells), table(third, typed)))


def _cell(result: str, language: str) -> str:
    """What came of a feature; of one that isn't there, why."""
    for pattern, reason in REASONS if result.startswith("no: ") else ():
        if found := re.search(pattern, result):
            return prose(said(reason, language).format(*found.groups()))
    return word(f"cell.{result.partition(':')[0]}", language)


def with_tables(name: str, **tables: Callable[[str], str]) -> Callable[[str], str]:
    """Return a page that is there, with its tables as they should be."""

    def page(language: str) -> str:
        text = (DOCS / language / name).read_text(encoding="utf-8")
        for title, made in tables.items():
            begin = f"<!-- generated: {title} -->\n"
            before, found, rest = text.partition(begin)
            _, end, after = rest.partition(END)
            assert found and end, f"docs/{language}/{name} lacks {begin.strip()} … {END.strip()}"
            text = f"{before}{begin}\n{made(language)}\n{END}{after}"
        return text

    return page


PAGES: dict[str, Callable[[str], str]] = {
    "reference/command-line.md": lambda language: "\n".join(command_line(language)),
    "reference/keys.md": lambda language: "\n".join(keys(language)),
    "reference/environment.md": lambda language: "\n".join(environment(language)),
    "reference/files.md": with_tables("reference/files.md", files=places, late=late),
    "trust/platforms.md": with_tables("trust/platforms.md", runs=runs),
    "reference/colcon.md": lambda language: "\n".join(colcon(language)),
    "teachers/writing-lessons.md": lambda language: (WRITING / f"{language}.md").read_text(encoding="utf-8"),
}


def main() -> None:
    """Write the pages that are not as they should be, and name them."""
    for language in LANGUAGES:
        for name, made in PAGES.items():
            path, text = DOCS / language / name, made(language)
            if not path.exists() or path.read_text(encoding="utf-8") != text:
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8", newline="\n")
                print(path.relative_to(ROOT))


if __name__ == "__main__":
    main()
