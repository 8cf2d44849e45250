"""The rules: from a fault and the machine around it to a hint."""

from __future__ import annotations

import keyword
import re
import sys
import unicodedata
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from day6_core.advice import known
from day6_core.advice.callbacks import cause_in_source
from day6_core.advice.fault import Fault, fault_in
from day6_core.advice.foreign_modules import AMBIGUOUS, COMMON, OF_MATH, OF_ROS_1, PIP, SAMPLES, family_of
from day6_core.advice.matching import card_for
from day6_core.advice.own_names import cause_of_name, never_begun
from day6_core.advice.syntax_slips import line_of, slip_in_line
from day6_core.advice.texts import TEXTS
from day6_core.advice.typed import chinese_sign, lacking_in_shell, near_choice, slip_of_command
from day6_core.advice.wording import at_home, filled_in, without_line
from day6_core.facts.folders import text_of
from day6_core.facts.names import CLOSE, nearest
from day6_core.facts.workspaces import packages_lacking_comma, refused_manifests, why_unknown, workspaces_around
from day6_core.language import language_of, said
from day6_core.ros import differences
from day6_core.ros.distribution import current
from day6_urdf.chinese import PUNCTUATION
from day6_urdf.explain import Hint, chinese_numbers, hints_wanted

_FOR_EXAMPLES = ("example_interfaces/", "test_msgs/")
"""Packages whose types are seldom meant."""


@dataclass(frozen=True)
class Surroundings:
    """Where the program ran: its variables, its folder, and whether a launch file or colcon started it."""

    variables: Mapping[str, str]
    cwd: Path
    launch: bool = False

    @property
    def home(self) -> str:
        """The home folder, as the program knew it."""
        return self.variables.get("HOME", "")


def hint_below(output: str, around: Surroundings) -> str:
    """Return the line to print below a program's output, '' if there is nothing certain to say."""
    if not hints_wanted(around.variables):
        return ""
    language = language_of(around.variables)
    fault = fault_in(output)
    text = _explain(fault, around, language) if fault is not None else _of_a_tool(output, language)
    return _hint(text, around)


def hint_about_command(
    argv: list[str],
    around: Surroundings,
    commands: Iterable[str] = (),
    *,
    line: str = "",
    letters: str = "",
    output: str = "",
) -> str:
    """Return the same for a command that failed: what is wrong for certain with its words, its prompt, its blanks.

    `commands`: if it does not exist, those that do; `line` is how it was typed, `letters` are the answers that a question of
    the lesson waits for, `output` is what it printed.
    """
    if not hints_wanted(around.variables):
        return ""
    language = language_of(around.variables)
    line = line or " ".join(argv)
    text = next((text for word in argv[1:] if (text := _home(word, "home", around, language))), "")
    if not text and argv[:2] in (["ros2", "run"], ["ros2", "launch"]):
        package = next((word for word in argv[2:] if not word.startswith("-")), "")
        text = _of_the_workspace(package, around, language)
    if not text and (slip := chinese_sign(argv, line)) is not None:
        text = _say(slip.key, language, **slip.values)
    folder = "/" in argv[0] and (around.cwd / argv[0].partition("/")[0]).exists()
    if not text and not folder and (known_ones := list(commands)):
        slip = slip_of_command(argv[0], line, known_ones, letters)
        text = _say(slip.key, language, **slip.values) if slip is not None else ""
    if not text and (choice := _CHOICE.search(output)) is not None:
        near = near_choice(choice[1], re.findall(r"[\w.-]+", choice[2]))
        text = _say("choice.near", language, name=choice[1], near=near) if near else ""
    return _hint(text or chinese_numbers(output, language), around)


_CHOICE = re.compile(r"invalid choice: '([^'\n]*)' \(choose from ([^\n]*)\)")


def hint_about_silence(program: Path, around: Surroundings) -> str:
    """Return the same for a Python program that ended at once, and printed nothing."""
    if not hints_wanted(around.variables) or (cause := never_begun(around.cwd / program)) is None:
        return ""
    language = language_of(around.variables)
    return Hint(0, 0, _say(cause[0], language, **cause[1])).sentence("", language)


def hint_about_quote(quote: str, around: Surroundings) -> str:
    """Return the same for lines that are typed while a quotation mark is open."""
    if not hints_wanted(around.variables):
        return ""
    language = language_of(around.variables)
    return _hint(_say("quote.open", language, quote=quote), around)


def hint_about_syntax(line: str, around: Surroundings) -> str:
    """Return the same for a line that the shell could not read: it uses something of bash that this one does not have."""
    slip = lacking_in_shell(line) if hints_wanted(around.variables) else None
    return _hint(_say(slip.key, language_of(around.variables), **slip.values), around) if slip is not None else ""


def hint_about_folder(packages: int, around: Surroundings) -> str:
    """Return the same for a build in the wrong folder: in `src`, or where no packages are."""
    home = Path(around.variables.get("HOME", "/"))
    if not hints_wanted(around.variables):
        return ""
    language, text = language_of(around.variables), ""
    if packages and around.cwd.name == "src":
        text = _say("folder.src", language, workspace=around.cwd.parent)
    elif (left_out := next(refused_manifests(around.cwd), None)) is not None:
        manifest, reason = left_out
        values = {"file": manifest, "what": reason.what, "line": reason.line}
        text = _say(f"manifest.{reason.because}", language, **values)
    elif not packages and around.cwd != home / "ros2_ws" and any((home / "ros2_ws" / "src").glob("*/package.xml")):
        text = _say("folder.nothing", language)
    return _hint(text, around)


def _hint(text: str, around: Surroundings) -> str:
    """A text as the line of a hint, '' if it is empty."""
    return Hint(0, 0, at_home(text, around.home)).sentence("", language_of(around.variables)) if text else ""


def _say(key: str, language: str, **values: object) -> str:
    text = said(TEXTS[key], language)
    return (text if values.get("line", True) else without_line(text)).format(**values)


def _explain(fault: Fault, around: Surroundings, language: str) -> str:
    rule = _RULES.get(fault.kind)
    return (rule(fault, around, language) if rule is not None else "") or _by_card(
        f"{fault.kind}: {fault.message}" if fault.message else fault.kind, fault, language
    )


def _of_a_tool(output: str, language: str) -> str:
    """What setuptools says without an exception."""
    lines = (line for line in output.splitlines() if line.startswith("error"))
    return next((text for line in lines if (text := _by_card(line, None, language))), "")


def _by_card(line: str, fault: Fault | None, language: str) -> str:
    """The first line of its card, if that is certain enough for a hint."""
    match = card_for(line, fault)
    if match is None or not match.card.hint:
        return ""
    return filled_in(match.card.words[language].first, match.values, match.fault)


@lru_cache(maxsize=16)
def in_short(message: str, line: int, language: str) -> str:
    """Return what a message of a checker (`SyntaxError: …`) about a line of a text means, in one sentence; '' without a card."""
    kind, _, rest = message.partition(": ")
    fault = Fault(kind, rest, "", line)
    if kind == "SyntaxError" and (text := _syntax(fault, Surroundings({}, Path()), language)):
        return text
    if text := chinese_numbers(message, language):
        return f"第 {line} 行：{text}" if language == "zh" else f"line {line}: {text}"
    match = card_for(message, fault if kind.isidentifier() else None)
    return filled_in(match.card.words[language].first, match.values, fault) if match is not None else ""


def dimmed(line: str) -> str:
    """Return a line for a terminal in grey: it is not the program's own."""
    return f"\x1b[90m{line}\x1b[0m"


# -- files ---------------------------------------------------------------------------------------------------------------


def _no_file(fault: Fault, around: Surroundings, language: str) -> str:
    found = re.search(r"No such file or directory: '((?:/home|~|\$HOME)/[^']*)'", fault.message)
    if found is None or "subprocess" in fault.through:
        return ""
    if found[1].startswith(("~", "$")):
        return _say("home.short", language, wrong=found[1][: found[1].find("/")], rest=found[1][found[1].find("/") :])
    return _home(found[1], "home.launch" if around.launch else "home.python", around, language)


def _home(word: str, key: str, around: Surroundings, language: str) -> str:
    """A path below /home/SOMEBODY that is not here, while the same path below the real home, or its beginning, is."""
    found = re.match(r"/home/[^/]+((?:/[^/]+)*)/?$", word)
    home = Path(around.variables.get("HOME", "/"))
    if found is None or Path(word).exists():
        return ""
    rest = found[1]
    if rest and not (home / rest.split("/")[1]).exists():
        return ""
    return _say(key, language, wrong=word.removesuffix(rest) or word, right=f"~{rest}", rest=rest)


# -- modules and names -----------------------------------------------------------------------------------------------------


_INTERFACES = {"msg", "srv", "action"}
"""Modules of a package that has interfaces."""


def _no_module(fault: Fault, around: Surroundings, language: str) -> str:
    found = re.match(r"No module named '([\w.]+)'", fault.message)
    if found is None:
        return ""
    if text := _own_file(fault, around, language):
        return text
    whole = found[1]
    outer, _, last = whole.rpartition(".")
    if outer and (line := _import_of(last, around)):
        return _say("import.elsewhere", language, name=last, module=outer, line=line)
    parts = known.parts_of(outer, around.variables) if outer else []
    if last in _INTERFACES and not _INTERFACES & {*parts}:
        near = nearest(outer, [each for each in known.modules(around.variables) if each != outer], CLOSE)
        return _say("module.near", language, name=whole, near=f"{near}.{last}") if near else ""
    if outer:
        others = sorted(_INTERFACES & {*parts}) if last in _INTERFACES else []
        near = others[0] if len(others) == 1 else nearest(last, parts)
        return _say("module.near", language, name=whole, near=f"{outer}.{near}") if near else ""
    if text := _of_the_workspace(whole, around, language):
        return text
    turtlesim = differences.value("turtlesim.interfaces")
    if whole in differences.VALUES["turtlesim.interfaces"][0].values() and whole != turtlesim:
        return _say("module.moved", language, name=whole, distro=current(), now=turtlesim)
    if whole in OF_ROS_1:
        return _say("module.ros1", language, name=whole, now=OF_ROS_1[whole])
    if whole in PIP:
        return _say("module.pip", language, name=whole, package=PIP[whole])
    if family := family_of(whole):
        return _say(f"foreign.{family}", language, name=whole, apt=apt_name(whole))
    near = nearest(whole, known.modules(around.variables), CLOSE)
    return _say("module.near", language, name=whole, near=near) if near else ""


def apt_name(package: str) -> str:
    """What apt calls a package of ROS on a real machine."""
    return f"ros-{current()}-{package.replace('_', '-')}"


_SHADOWED = (
    re.compile(r"cannot import name '\w+' from (?:partially initialized module )?'(\w+)'"),
    re.compile(r"(?:partially initialized )?module '(\w+)' has no attribute"),
    re.compile(r"No module named '(\w+)\.[\w.]+'; '\w+' is not a package"),
)
"""What is said of a module that isn't the one that was meant."""


def own_module(message: str, around: Surroundings, file: str = "") -> str:
    """Return the module of Python, pip or ROS in whose place a file in the program's folder was found, '' if there is none."""
    said = next((found for each in _SHADOWED if (found := each.search(message))), None)
    folders = (around.cwd, (around.cwd / file).parent)
    if said is None or not any((folder / f"{said[1]}.py").is_file() for folder in folders):
        return ""
    others = said[1] in sys.stdlib_module_names or said[1] in PIP or said[1] in known.modules(around.variables)
    return said[1] if others else ""


def _own_file(fault: Fault, around: Surroundings, language: str) -> str:
    name = own_module(fault.message, around, fault.file)
    key = "module.own_python" if name in sys.stdlib_module_names else "module.own_file"
    return _say(key, language, file=f"{name}.py", name=name) if name else ""


def _of_the_workspace(package: str, around: Surroundings, language: str) -> str:
    """Whether a package was built and not sourced, or not even built."""
    if not package.isidentifier():
        return ""
    unknown = why_unknown(package, around.variables, around.cwd)
    if unknown is None:
        return ""
    setup = unknown.workspace / "install" / "setup.bash"
    said = {"folder": unknown.folder, "workspace": unknown.workspace, "setup": setup}
    return _say(unknown.because, language, name=package, **said)


def _no_import(fault: Fault, around: Surroundings, language: str) -> str:
    if text := _own_file(fault, around, language):
        return text
    found = re.match(r"cannot import name '(\w+)' from '([\w.]+)'", fault.message)
    if found is None:
        return ""
    launch = around.launch or found[2].startswith("launch")
    if (line := _import_of(found[1], around, launch)) and f"from {found[2]} " not in line:
        return _say("import.elsewhere", language, name=found[1], module=found[2], line=line)
    near = nearest(found[1], known.names_of(found[2], around.variables), CLOSE)
    return _say("import.near", language, name=found[1], module=found[2], near=near) if near else ""


def _no_name(fault: Fault, around: Surroundings, language: str) -> str:
    found = re.match(r"name '(\w+)' is not defined(?:. Did you mean: '(\w+)')?", fault.message)
    if found is None:
        return ""
    name, near = found[1], found[2]
    if re.search(rf"//\s*{name}\b", fault.source):
        return _say("syntax.comment", language, line=fault.line)
    if name == "π":
        return _say("name.math", language, name="pi")
    if not name.isascii():
        return _say("syntax.text", language, line=fault.line, found=name)
    if name in OF_MATH:
        return _say("name.math", language, name=name)
    line = _import_of(name, around, around.launch or fault.file.endswith("launch.py"))
    used = re.search(rf"\b{name}\.", line_of(fault, around.cwd)) is not None
    if not line and (name in COMMON or (name == "rclpy" and used)):
        line = f"import {name}"
    if line:
        return _say("name.import", language, name=name, line=line)
    if text := _of_source(fault, around, language):
        return text
    return _say("name.near", language, name=name, near=near) if near else ""


def _import_of(name: str, around: Surroundings, launch: bool = False) -> str:
    """The line that imports a name of ROS, '' if there is none, or more than one could be meant."""
    if launch and name == "Node":
        return "from launch_ros.actions import Node"
    if name in SAMPLES or name in AMBIGUOUS:
        return SAMPLES.get(name, "")
    homes = [home for home in known.types_called(name, around.variables) if not home.startswith(_FOR_EXAMPLES)]
    if len({home.partition("/")[0] for home in homes}) != 1:
        return ""
    return f"from {homes[0].replace('/', '.').rpartition('.')[0]} import {name}"


def _no_attribute(fault: Fault, around: Surroundings, language: str) -> str:
    if text := _own_file(fault, around, language):
        return text
    found = re.match(r"'(\w+)' object has no attribute '(\w+)'", fault.message)
    if found is None:
        return ""
    kind, name = found[1], found[2]
    own_class = re.search(rf"^ *class {kind}\b", text_of(around.cwd / fault.file), re.MULTILINE) if fault.file else None
    if own_class is not None:
        is_node = name.startswith("_") and "rclpy" in fault.through
        return _say("no_super", language, kind=kind) if is_node else _of_source(fault, around, language)
    if text := _of_source(fault, around, language):
        return text
    return _no_field(kind, name, around, language)


def _no_field(kind: str, name: str, around: Surroundings, language: str) -> str:
    layouts = known.fields_of(kind, around.variables)
    if not layouts or any(fields != layouts[0][1] for _, fields in layouts):
        return ""
    fields = layouts[0][1]
    close = nearest(name, fields, CLOSE)
    near = _say("field.near", language, near=close).rstrip("?？") if close else ""
    return _say("field", language, type=kind, name=name, near=near, fields=", ".join(fields))


def _no_argument(fault: Fault, around: Surroundings, language: str) -> str:
    """A field that a message was made with and does not have."""
    found = re.match(r"Invalid arguments passed to constructor: (\w+)$", fault.message)
    made = re.search(rf"\b([A-Z]\w*)\([^()]*\b{found[1]}=", fault.source) if found is not None else None
    return _no_field(made[1], found[1], around, language) if found is not None and made is not None else ""


def _no_setup(fault: Fault, around: Surroundings, language: str) -> str:
    """setuptools gave up: what it says does not name the comma that is missing between two entry points."""
    if not fault.message.startswith("'distutils.core.setup()' was never called"):
        return ""
    lacking = next(packages_lacking_comma(workspaces_around(around.variables, around.cwd)), None)
    return _say("setup.comma", language, setup=lacking[0] / "setup.py", line=lacking[1]) if lacking is not None else ""


# -- syntax ----------------------------------------------------------------------------------------------------------------


_FIRST_WORDS = [word for word in keyword.kwlist if len(word) > 3 and word.islower()]
"""Words of Python with which a line may begin, long enough that a slip is certain."""


def _syntax(fault: Fault, around: Surroundings, language: str) -> str:
    if (slip := slip_in_line(fault, around.cwd)) is not None:
        return _say(slip.key, language, line=slip.line, found=slip.found)
    first = re.match(r"([A-Za-z]+) +\S", fault.source)
    if first is not None and fault.message.startswith("invalid syntax") and not keyword.iskeyword(first[1]):
        small = first[1].lower()
        near = small if keyword.iskeyword(small) else near_choice(first[1], _FIRST_WORDS)
        return _say("keyword.near", language, line=fault.line, name=first[1], near=near) if near else ""
    found = re.match(r"invalid (?:non-printable )?character (?:'(.)' )?\(?U\+([0-9A-F]+)\)?", fault.message)
    if found is None:
        return ""
    wrong = chr(int(found[2], 16))
    right = PUNCTUATION.get(wrong) or unicodedata.normalize("NFKC", wrong)
    if right.isspace():
        return _say("odd_blank", language, line=fault.line)
    if right == wrong or not right.isascii():
        return ""
    return _say("chinese", language, line=fault.line, wrong=wrong, right=right)


def _of_source(fault: Fault, around: Surroundings, language: str) -> str:
    """What stands in the pupil's file where the message alone fits several causes."""
    cause = cause_in_source(fault, around.cwd) or cause_of_name(fault, around.cwd)
    return _say(cause[0], language, **cause[1]) if cause is not None else ""


def _runtime(fault: Fault, around: Surroundings, language: str) -> str:
    return _no_setup(fault, around, language) or _of_source(fault, around, language)


def cause_of(fault: Fault, around: Surroundings, language: str) -> str:
    """Return what a rule finds to be the cause of an exception here, '' if nothing is certain."""
    rule = _RULES.get(fault.kind)
    return rule(fault, around, language) if rule is not None else ""


_RULES: dict[str, Callable[[Fault, Surroundings, str], str]] = {
    "FileNotFoundError": _no_file,
    "ModuleNotFoundError": _no_module,
    "ImportError": _no_import,
    "NameError": _no_name,
    "AttributeError": _no_attribute,
    "SyntaxError": _syntax,
    "RuntimeError": _runtime,
    "TypeError": _of_source,
    "ValueError": _of_source,
    "AssertionError": _no_argument,
    "UnboundLocalError": _of_source,
    "ParameterNotDeclaredException": _of_source,
}
