"""What a listing does to the files of a workspace: makes one, or changes one that `ros2 pkg create` has made."""

from __future__ import annotations

import re
import textwrap
from pathlib import Path

from tests.conformance.tutorial_pages.documentation import Block

_CODE = re.compile(r"``([^`]+)``|\*\*([^*]+)\*\*")
_FILE = re.compile(r"[\w./~-]+\.(?:py|xml|ya?ml|urdf|xacro|msg|srv|action|rviz|txt|cfg|urdf\.xml|repos)$")
_DEPEND = re.compile(r"^\s*<(?:\w*depend|member_of_group)\b.*$", re.M)
_ABOUT = re.compile(r"<(description|maintainer|license)\b[^>]*>.*?</\1>", re.S)
_ENTRY = re.compile(r"^\s*(?P<quote>['\"])(?P<name>[\w.-]+)\s*=\s*(?P<module>[\w.]+):(?P<main>\w+)(?P=quote)", re.M)
_DATA = re.compile(r"^\s*\(\s*(?:os\.path\.join\(\s*['\"]share['\"]|['\"]share/?).*", re.M)
_BROKEN = re.compile(r",[ \t]*\n\s+(?=glob\()")
"""Between a target and its files, which some pages write in two lines."""
_CMAKE = re.compile(r"\s*(?:cmake_minimum_required|find_package|add_executable|add_library|install|ament_\w+)\(")
_CREATED = re.compile(r"ros2 pkg create\b(?P<rest>.*)")


def _data_lines(text: str) -> list[str]:
    """Return the lines that belong into `data_files`."""
    return _DATA.findall(_BROKEN.sub(", ", text))


class Workspace:
    """The folder in which a page works, and the package it is at."""

    def __init__(self, home: Path) -> None:
        self.home = home
        self.root = home / "ros2_ws"
        self.package: str = ""
        self.written: list[Path] = []
        self._words = ""

    # -- where we are --------------------------------------------------------------------------------------------------

    def folder(self, path: str) -> Path | None:
        """Return the folder that a page means by a path."""
        path = path.removeprefix("~/").strip("/")
        for base in (
            self.home,
            self.root,
            self.root / "src",
            self.root / "src" / self.package,
            self.root / "src" / self.package / self.package,
        ):
            if (base / path).is_dir() and path:
                return base / path
        return None

    def hear(self, words: str) -> None:
        """Remember words before a block, and which package they are about."""
        self._words = words
        for path in re.findall(r"``~?/?[\w]+/src/(\w+)", words):
            if (self.root / "src" / path).is_dir():
                self.package = path

        for word in re.findall(r"``(?:src/)?(\w+)/?``", words):
            if (self.root / "src" / word / "package.xml").is_file():
                self.package = word

    def has_package(self, command: str) -> bool:
        """Say whether a command would make a package that is there."""
        created = _CREATED.match(command)
        return created is not None and any(
            (self.root / "src" / word / "package.xml").is_file() for word in created["rest"].split()
        )

    def where(self, name: str) -> Path | None:
        """Return the folder of a file that was written for a page."""
        return next((path.parent for path in reversed(self.written) if path.name == name), None)

    def ran(self, command: str, cwd: Path) -> None:
        """Take note of a command that was run."""
        if created := _CREATED.match(command):
            words = [word for word in created["rest"].split() if (cwd / word / "package.xml").is_file()]
            if words:
                self.package = words[0]

    # -- writing -------------------------------------------------------------------------------------------------------

    def heed(self, block: Block) -> list[str]:
        """Do what a listing shows; return the files written, none where it only explains."""
        named = [one or two for one, two in _CODE.findall(block.before)]
        files = [name for name in named if _FILE.search(name) and "/" + name not in ("/__init__.py",)]
        told = re.findall(
            r"(?:called|named|create|new file|file|code in|into|call it)\W+(?:[\w']+ ){0,4}``([^`]+)``",
            block.before,
            re.I,
        )
        files = [name for name in told if name in files] or files
        comment = re.match(r"# ?(\S+\.py)\s*$", block.text.partition("\n")[0])
        if comment and not files:
            files = [comment[1]]
        text, language = block.text, block.language
        if (said := re.search(r"^\s*package_name = '(\w+)'", text, re.M)) and (self.root / "src" / said[1]).is_dir():
            self.package = said[1]
        package = self.root / "src" / self.package
        if entries := _ENTRY.findall(text):
            target = self.root / "src" / entries[0][2].partition(".")[0] / "setup.py"
            if target.is_file():
                changed = [self._entry(target, name, module, main) for _, name, module, main in entries]
                if data := _data_lines(text):
                    self._data(target, data)
                return [self._shown(target)] if any(changed) or _DATA.search(text) else []
        if language == "python" and _DATA.search(text) and self.package and "LaunchDescription" not in text:
            return [self._shown(package / "setup.py")] if self._data(package / "setup.py", _data_lines(text)) else []
        if (
            self.package
            and language in ("xml", "", "python", "console")
            and (_DEPEND.search(text) or _ABOUT.search(text))
            and "<package" not in text
        ):
            return self._manifest(package / "package.xml", text)
        if (language == "cmake" or _CMAKE.match(text)) and self.package and (package / "CMakeLists.txt").is_file():
            return self._cmake(package / "CMakeLists.txt", text)
        if not files or not self._is_whole(text, language, files[0]):
            return []
        return self.write(str(self._place(files[0], text).relative_to(self.home)), text, "whole")

    def _is_whole(self, text: str, language: str, name: str) -> bool:
        if name.endswith((".msg", ".srv", ".action")):
            return language in ("console", "bash", "", "text") and not re.search(r"[(){}]", text)
        if language == "python":
            return (
                name.endswith(".py")
                and "import " in text
                and bool(
                    re.search(r"def main|def generate_launch_description|__main__|^def test_|class Test", text, re.M)
                )
            )
        if language == "xml":
            return text.lstrip().startswith(("<?xml", "<launch", "<robot", "<package")) and name.endswith(
                (".xml", ".urdf", ".xacro")
            )
        if language == "yaml":
            return name.endswith((".yaml", ".yml", ".repos"))
        return False

    def _place(self, name: str, text: str) -> Path:
        package = self.root / "src" / self.package if self.package else self.root
        name = name.removeprefix("~/")
        if "/" in name:
            first = name.partition("/")[0]
            bases = [self.root, self.root / "src", self.home]
            for base in [package, *bases] if self.package else bases[::-1]:
                if (base / first).is_dir():
                    return base / name
            return package / name
        if re.search(r"home directory", self._words):
            return self.home / name
        launches = (
            "generate_launch_description" in text
            or re.match(r"\s*(<launch|<\?xml[^>]*>\s*<launch)", text)
            or re.search(r"^launch:", text, re.M)
        )
        if launches and self.package:
            return package / "launch" / name
        found = [path for path in package.rglob(name) if "build" not in path.parts] if self.package else []
        if found:
            return found[0]
        for folder in reversed([one or two for one, two in _CODE.findall(self._words)]):
            if "." not in folder.strip("./") and (known := self.folder(folder)) is not None:
                return known / name
        suffix = name.rpartition(".")[2]
        inside = {"msg": "msg", "srv": "srv", "action": "action", "yaml": "config", "rviz": "rviz", "urdf": "urdf"}.get(
            suffix, ""
        )
        if launches:
            inside = "launch"
        elif suffix == "py" and name not in ("setup.py", "conf.py"):
            inside = "test" if name.startswith("test_") else self.package
        return package / inside / name

    def write(self, name: str, text: str, how: str) -> list[str]:
        """Write a listing to a file below the home, or to several; return their names.

        `how`: whole (the file is this), entry, data, manifest, cmake (see `heed`), or its place in the file: `after PATTERN`,
        `before PATTERN`, `for PATTERN`.
        """
        if " " in name:
            return [each for one in name.split() for each in self.write(one, text, how)]
        path = self.home / name
        path.parent.mkdir(parents=True, exist_ok=True)
        self.written.append(path)
        kind, _, pattern = how.partition(" ")
        if kind == "whole":
            path.write_text(text + "\n", encoding="utf-8")
        elif kind == "manifest":
            return self._manifest(path, text)
        elif kind == "cmake":
            return self._cmake(path, text)
        elif kind == "entry":
            for _, program, module, main in _ENTRY.findall(text):
                self._entry(path, program, module, main)
        elif kind == "data":
            self._data(path, _data_lines(text))
        else:
            before = path.read_text(encoding="utf-8")
            match = re.search(pattern, before, re.M)
            if match is None:
                return []
            indent = re.match(r" *", match[0].lstrip("\n"))
            if indent is not None and kind in ("after", "before"):
                text = "\n".join(indent[0] + line for line in textwrap.dedent(text).split("\n"))
            start, end = {"after": (match.end(), match.end()), "before": (match.start(), match.start())}.get(
                kind, match.span()
            )
            path.write_text(
                before[:start]
                + ("\n" if kind == "after" else "")
                + text
                + ("\n" if kind == "before" else "")
                + before[end:],
                encoding="utf-8",
            )
        return [self._shown(path)]

    def _shown(self, path: Path) -> str:
        return path.relative_to(self.home).as_posix()

    def _entry(self, setup: Path, name: str, module: str, main: str) -> bool:
        text = setup.read_text(encoding="utf-8")
        line = f"'{name} = {module}:{main}',"
        if line in text:
            return False
        text = re.sub(rf"^\s*'{re.escape(name)} = .*\n", "", text, flags=re.M)
        setup.write_text(re.sub(r"('console_scripts': \[\n?)", rf"\1            {line}\n", text), encoding="utf-8")
        return True

    def _data(self, setup: Path, lines: list[str]) -> bool:
        if not setup.is_file():
            return False
        text = before = setup.read_text(encoding="utf-8")
        for line in lines:
            line = line.strip().rstrip(",")
            if (
                line.count("(") == line.count(")")
                and line not in text
                and "resource_index" not in line
                and "['package.xml']" not in line
            ):
                text = re.sub(
                    r"(\('share/' \+ package_name, \['package\.xml'\]\),\n)",
                    lambda match, line=line: f"{match[1]}        {line},\n",
                    text,
                )
        for needed in ("from glob import glob", "import os"):
            if text != before and needed not in text:
                text = f"{needed}\n{text}"
        setup.write_text(text, encoding="utf-8")
        return text != before

    def _manifest(self, manifest: Path, text: str) -> list[str]:
        if not manifest.is_file():
            return []
        now = manifest.read_text(encoding="utf-8")
        for match in _ABOUT.finditer(text):
            now = re.sub(rf"<{match[1]}\b[^>]*>.*?</{match[1]}>", lambda _, new=match[0]: new, now, count=1, flags=re.S)
        for line in _DEPEND.findall(text):
            if line.strip() not in now:
                now = re.sub(r"\n\s*<export>", f"\n  {line.strip()}\n\n  <export>", now, count=1)
        manifest.write_text(now, encoding="utf-8")
        return [self._shown(manifest)]

    def _cmake(self, lists: Path, text: str) -> list[str]:
        if re.search(r"^\s*project\(", text, re.M):
            return self.write(self._shown(lists), text, "whole")
        now = lists.read_text(encoding="utf-8")
        new = "\n".join(
            line
            for line in text.splitlines()
            if not re.match(r"\s*(ament_package\(\)|#? ?\.\.\.)", line)
            and not (line.startswith("find_package") and line.split("#")[0].strip() in now)
        )
        if new.strip() and new.strip() not in now:
            lists.write_text(
                re.sub(r"^ament_package\(\)", lambda _: f"{new}\n\nament_package()", now, flags=re.M), encoding="utf-8"
            )
        return [self._shown(lists)]
