"""Explains urdfdom's messages to the author of the file: where to look and what to do, in English or Chinese.

urdfdom names lines of its own source and no place in the description. A hint names line and column of the faulty element, then
explains in plain words what it needs. Hints are shown in addition to the messages and replace none of them.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Mapping
from dataclasses import dataclass

from day6_urdf.chinese import english, numbers, sign_in, sign_outside_quotes
from day6_urdf.report import Diagnostic, Report


@dataclass(frozen=True, slots=True)
class Hint:
    """Line and column in the description, from 1 (0, 0: no particular place), and the explanation."""

    line: int
    column: int
    text: str

    def sentence(self, file: str, language: str = "en") -> str:
        """Return the hint as one line for a terminal."""
        if language == "zh":
            place = f"第 {self.line} 行第 {self.column} 列：" if self.line else ""
            return f"提示：{file} {place}{self.text}" if place else f"提示：{self.text}"
        place = f"{file}, line {self.line}, column {self.column}: " if self.line else ""
        return f"hint: {place}{self.text}"


# A pattern of urdfdom's message, whose groups are {0}, {1} … -> English, Chinese.
_EXPLANATIONS: tuple[tuple[str, str, str], ...] = (
    (
        r"XML_ERROR_MISMATCHED_ELEMENT.*name=(\S+)",
        "the tag <{0}> that starts here isn't closed: it needs </{0}> after its contents, or a / before its >",
        "这里开始的标签 <{0}> 没有关好：内容后面要有 </{0}>，或者在 > 前面写 /",
    ),
    (
        r"XML_ERROR_PARSING_ATTRIBUTE.*name=(\S+)",
        'an attribute in the tag <{0}> is not written as name="value": look for a missing quotation mark or a name used twice',
        '标签 <{0}> 里有个属性没写成 名字="值"：看看是不是少了引号，或者同一个名字写了两遍',
    ),
    (r"XML_ERROR_EMPTY_DOCUMENT", "the file is empty, or it cannot be read", "文件是空的，或者读不了"),
    (
        r"XML_ERROR_ELEMENT_DEPTH",
        "the tags are nested too deeply: probably one is never closed",
        "标签套得太深：多半有一个没有关上",
    ),
    (r"Error=XML_ERROR", "from here on, the file isn't valid XML", "从这里开始就不是正确的 XML 了"),
    (
        r"too large: (\S+ MB)",
        "a robot description is usually a few kilobytes of text; detailed shapes belong in mesh files",
        "机器人描述一般只有几 KB；细节很多的形状应该放进 mesh 文件",
    ),
    (
        r"Could not find the 'robot' element",
        'everything has to be inside <robot name="…"> … </robot>',
        '所有内容都要写在 <robot name="…"> … </robot> 里面',
    ),
    (r"No name given for the robot", 'the robot needs a name: <robot name="…">', '机器人要有名字：<robot name="…">'),
    (r"version", 'remove the attribute version, or write version="1.0"', '去掉 version 属性，或者写 version="1.0"'),
    (
        r"No link elements found",
        "the robot has no <link>: it needs at least one",
        "机器人里没有 <link>，至少要有一个",
    ),
    (
        r"No name given for the link",
        'every link needs a name: <link name="…">',
        '每个 link 都要有名字：<link name="…">',
    ),
    (
        r"(link|joint|material) '(.*)' is not unique",
        "the name {1} is used for two {0}s: give this one another name",
        "两个 {0} 都叫 {1}：给这一个换个名字",
    ),
    (
        r"Two root links found: \[(.*)\] and \[(.*)\]",
        (
            "neither {0} nor {1} is attached to another link. All links must form one tree: exactly one, the root, is "
            "not a child. Is a joint missing, or is its child wrong?"
        ),
        (
            "{0} 和 {1} 都没有挂在别的 link 上。所有 link 要连成一棵树：只有一个（根）不是别人的 child。"
            "是不是少了一个 joint，或者 child 写错了？"
        ),
    ),
    (
        r"No root link found",
        "every link is the child of some joint, so they form a loop; one link, the root, must not be a child",
        "每个 link 都是某个 joint 的 child，连成了一个圈；要有一个 link（根）不是任何人的 child",
    ),
    (
        r"(child|parent) link \[(.*)\] of joint \[(.*)\] not found",
        "joint {2} names {1} as its {0} link, but there is no link with that name{near}",
        "joint {2} 的 {0} 写的是 {1}，可是没有叫这个名字的 link{near}",
    ),
    (
        r"Joint \[(.*)\] is missing a parent and/or child",
        'joint {0} has to say what it connects: <parent link="…"/> and <child link="…"/>',
        'joint {0} 要说明它连接谁：<parent link="…"/> 和 <child link="…"/>',
    ),
    (
        r"[Jj]oint \[(.*)\] (is of type (REVOLUTE|PRISMATIC)|has no limits)",
        (
            'a {kind} joint moves between two limits: add <limit lower="…" upper="…" effort="…" velocity="…"/>, or make it '
            "continuous if it can turn without limit"
        ),
        (
            '{kind} 关节只能在两个极限之间动：加上 <limit lower="…" upper="…" effort="…" velocity="…"/>；'
            "如果可以一直转，就用 continuous"
        ),
    ),
    (
        r"joint limit: no (effort|velocity)",
        'a <limit> needs effort="…" and velocity="…"',
        '<limit> 里必须写 effort="…" 和 velocity="…"',
    ),
    (
        r"[Jj]oint \[(.*)\] has no type",
        'joint {0} needs a type: type="fixed", "continuous", "revolute" or "prismatic"',
        'joint {0} 要写类型：type="fixed"、"continuous"、"revolute" 或 "prismatic"',
    ),
    (
        r"Joint \[(.*)\] has no known type \[(.*)\]",
        "there is no type {1}. The types are fixed, continuous, revolute, prismatic, floating, planar{near}",
        "没有 {1} 这种类型。可以用 fixed、continuous、revolute、prismatic、floating、planar{near}",
    ),
    (
        r"unnamed joint",
        'every joint needs a name: <joint name="…" type="…">',
        '每个 joint 都要有名字：<joint name="…" type="…">',
    ),
    (
        r"Parser found (\d+) elements but (\d+) expected while parsing vector \[(.*)\]",
        '{1} numbers separated by spaces are needed here, but there are {0}: "{2}"',
        '这里要 {1} 个数，用空格隔开，现在有 {0} 个："{2}"',
    ),
    (
        r"Unable to parse component \[(.*,.*)\]",
        '"{0}": separate numbers with spaces, not with commas',
        '"{0}"：数和数之间用空格，不用逗号',
    ),
    (
        r"rgba values: Unable to parse component \[(.*)\]",
        'a colour is four numbers from 0 to 1 (red, green, blue, opacity), but "{0}" is not one',
        '颜色是四个 0 到 1 的数（红、绿、蓝、不透明度），"{0}" 不行',
    ),
    (r"Unable to parse component \[(.*)\]", '"{0}" is not a number', '"{0}" 不是数'),
    (r"inertia element (\w+) is not a valid double", "{0} isn't a number", "{0} 不是数"),
    (r"(\w+) \[(.*)\] is not a float", '{0}="{1}": that is not a number', '{0}="{1}"：这不是数'),
    (r"(\S+) value \((.*)\) is not a valid float", '{0}="{1}": that is not a number', '{0}="{1}"：这不是数'),
    (r"(\S+) \[(.*)\] is not a valid float", '{0}="{1}": that is not a number', '{0}="{1}"：这不是数'),
    (
        r"Unknown geometry type '(.*)'",
        "there is no shape <{0}>: the shapes are <box>, <cylinder>, <sphere> and <mesh>",
        "没有 <{0}> 这种形状：可以用 <box>、<cylinder>、<sphere>、<mesh>",
    ),
    (
        r"Mesh must contain a filename",
        'a mesh needs its file: <mesh filename="package://…"/>',
        'mesh 要写文件：<mesh filename="package://…"/>',
    ),
    (
        r"Cylinder shape must have both",
        'a cylinder needs length="…" and radius="…"',
        '圆柱要写 length="…" 和 radius="…"',
    ),
    (
        r"Capsule shape must have both",
        'a capsule needs length="…" (without its round ends) and radius="…"',
        '胶囊要写 length="…"（不算两头的半球）和 radius="…"',
    ),
    (
        r"Both rpy and quat_xyzw",
        "an <origin> takes either rpy or quat_xyzw, not both",
        "<origin> 里 rpy 和 quat_xyzw 只能写一个",
    ),
    (
        r"Ignoring (capsule|quat_xyzw|acceleration|deceleration|jerk) attribute",
        '{0} is read from URDF 1.1 or 1.2 on: write <robot name="…" version="1.2">',
        '{0} 是 URDF 1.1 或 1.2 才有的：写 <robot name="…" version="1.2">',
    ),
    (
        r"joint \[(.*)\]: limit has no (effort|velocity)",
        'the <limit> of joint {0} needs {1}="…"',
        '关节 {0} 的 <limit> 要写 {1}="…"',
    ),
    (r"Sphere shape must have a radius", 'a sphere needs radius="…"', '球要写 radius="…"'),
    (r"Box shape has no size", 'a box needs size="length width height"', '长方体要写 size="长 宽 高"'),
    (
        r"Geometry tag contains no child|Geometry tag",
        "<geometry> needs one shape: <box>, <cylinder>, <sphere> or <mesh>",
        "<geometry> 里要有一个形状：<box>、<cylinder>、<sphere> 或 <mesh>",
    ),
    (
        r"Inertial element must have (mass|inertia) element",
        '<inertial> needs <mass value="…"/> and <inertia ixx="…" … izz="…"/>',
        '<inertial> 里要有 <mass value="…"/> 和 <inertia ixx="…" … izz="…"/>',
    ),
    (
        r"material '(.*)' undefined",
        'the colour of {0} is not defined: define it once with <color rgba="…"/>',
        '没有说 {0} 是什么颜色：在一个地方用 <color rgba="…"/> 定义它',
    ),
    (
        r"Material \[(.*)\] (color has no rgba|not defined)",
        'the material {0} defines no colour: write <color rgba="0 0 1 1"/> into it',
        '材料 {0} 没有定义颜色：在里面写 <color rgba="0 0 1 1"/>',
    ),
    (r"joint mimic: no mimic joint", 'a <mimic> needs joint="…"', '<mimic> 要写 joint="…"'),
    (
        r"joint dynamics element specified with no",
        '<dynamics> needs damping="…" or friction="…"',
        '<dynamics> 要写 damping="…" 或 friction="…"',
    ),
    (
        r"joint safety: no k_velocity",
        '<safety_controller> needs k_velocity="…"',
        '<safety_controller> 要写 k_velocity="…"',
    ),
)

_JOINT_TYPES = ("fixed", "continuous", "revolute", "prismatic", "floating", "planar")
_LINK_NAME = re.compile(r"<link\s[^>]*name\s*=\s*[\"']([^\"']*)")


def hint_of(report: Report, text: str = "", language: str = "en") -> Hint | None:
    """Return the hint for the first error or warning, None if there is none or no explanation of it.

    `text` is the description, from which similar link names are suggested.
    """
    for diagnostic in sorted(report.diagnostics, key=lambda each: each.level != "Error"):
        explained = _chinese(diagnostic, text, language) or _explain(diagnostic, text, language)
        if explained:
            return Hint(diagnostic.line, diagnostic.column, explained)
    return None


def chinese_numbers(message: str, language: str) -> str:
    """Return what a message about a value means if Chinese punctuation or wide digits are what is wrong with it, '' else."""
    value = _VALUE.search(message)
    return _put_right(value[1], language) if value is not None else ""


def _put_right(value: str, language: str) -> str:
    right = numbers(value)
    if not right:
        return ""
    sign = sign_in(value)
    in_english, in_chinese = _CHINESE[english(sign) in ", "]
    return (in_chinese if language == "zh" else in_english).format(sign=sign, wrong=value, right=right)


_VALUE = re.compile(r"(?:component|value|\w+) [\[(]([^\])]*)[\])] (?:to a double|is not a )")
_CHINESE = {
    True: (
        'put spaces between numbers, not a Chinese "{sign}": write "{right}" instead of "{wrong}"',
        '数和数之间用空格，不用中文的「{sign}」：把 "{wrong}" 写成 "{right}"',
    ),
    False: (
        'a Chinese "{sign}" cannot be part of a number: write "{right}" instead of "{wrong}"',
        '数里面不能有中文的「{sign}」：把 "{wrong}" 写成 "{right}"',
    ),
}
"""Whether the sign separates numbers -> English, Chinese."""
_CHINESE_TAG = (
    'this tag has a Chinese "{sign}": quotation marks are ", and only spaces go between attributes',
    '这个标签里有中文的「{sign}」：引号要用英文的 "，属性之间只用空格',
)


def _chinese(diagnostic: Diagnostic, text: str, language: str) -> str:
    """What it means if a Chinese sign is the cause: in a value, or in the tag that could not be read."""
    if explained := chinese_numbers(diagnostic.text, language):
        return explained
    if not diagnostic.line:
        return ""
    begin = sum(map(len, text.splitlines(keepends=True)[: diagnostic.line - 1])) + max(diagnostic.column - 1, 0)
    if (named := re.search(r"XMLElement name=(\S+)", diagnostic.text)) is not None:
        begin = max(text.rfind(f"<{named[1]}", 0, begin + 1), 0)  # an open quotation mark ends far behind
    if (unsaid := _UNSAID.search(diagnostic.text)) is not None:
        value = re.search(rf"\b{unsaid[1]}\s*=\s*[\"']([^\"']*)", text[begin:])
        return _put_right(value[1], language) if value is not None else ""
    if not _OF_TAGS.search(diagnostic.text):
        return ""
    in_english, in_chinese = _CHINESE_TAG
    sign = sign_outside_quotes(text[begin:].partition(">")[0])
    return (in_chinese if language == "zh" else in_english).format(sign=sign) if sign else ""


_UNSAID = re.compile(r"inertia element (\w+) is not a valid double")
"""The one message that names an attribute and not its value."""
_OF_TAGS = re.compile(r"XML_ERROR|has no |needs a name|must have|name given")
"""Messages about a tag that may not have been read as it was meant."""


def _explain(diagnostic: Diagnostic, text: str, language: str) -> str:
    for pattern, in_english, in_chinese in _EXPLANATIONS:
        match = re.search(pattern, diagnostic.text)
        if match is not None:
            template = in_chinese if language == "zh" else in_english
            groups = match.groups()
            return template.format(
                *(group or "" for group in groups),
                near=_near(diagnostic.text, groups, text, language) if "{near}" in template else "",
                kind=(groups[2] or "").lower() if "{kind}" in template else "",
            )
    return ""


def _near(message: str, groups: tuple[str | None, ...], text: str, language: str) -> str:
    """Return a question that suggests the intended name, empty if none is similar."""
    wrong = groups[1] or ""
    names = _JOINT_TYPES if "type" in message and "link" not in message else tuple(_LINK_NAME.findall(text))
    words = sorted(wrong.split("_"))
    turned = [name for name in names if sorted(name.split("_")) == words]
    found = turned or difflib.get_close_matches(wrong, names, 1, 0.6)
    if not found:
        return ""
    return f"。是不是想写 {found[0]}？" if language == "zh" else f". Did you mean {found[0]}?"


def hints_wanted(environment: Mapping[str, str]) -> bool:
    """Return whether hints are wanted: not with `DAY6_HINTS=off` (or 0, no, false)."""
    return environment.get("DAY6_HINTS", "").lower() not in ("off", "0", "no", "false")
