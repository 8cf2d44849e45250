"""`day6-tui submit`: what a pupil hands in, in one file: packages, loose programs, and answers to the lessons' questions.

    day6-submission.json     who and which lesson, when, the home folder it comes from, the letters that were chosen
    src/…                    the packages of ~/ros2_ws/src, as `day6-tui export` packs them (no build, install or log)
    home/…, loose/…          programs that lie directly in the home folder, directly in ~/ros2_ws/src

Nothing in it says whether anything is right: `day6-tui grade` finds that out by running the programs (`grading`).
"""

from __future__ import annotations

import json
import os
import sys
import tempfile
import time
import zipfile
from dataclasses import dataclass, field
from pathlib import Path

from day6_core.language import language_of
from day6_core.lessons import parsers
from day6_core.lessons.grading.archive import LARGEST, MANIFEST, VERSION, fits
from day6_core.lessons.progress import Progress, ProgressError, file_of, load, name_mistake, pupils, safe_name
from day6_core.lessons.texts import Say
from day6_core.places import default_home
from day6_core.reason import reason
from day6_core.session.harmless import one_line
from day6_core.whole_file import replacing
from day6_core.workspace.export import ExportError, Reason, export
from day6_core.workspace.packages import holds_packages

LOOSE = (".py", ".urdf", ".xacro", ".yaml", ".xml", ".rviz")
"""Ends of the names of loose files that are packed."""

MOST_LOOSE = 100
LARGEST_LOOSE = 1_000_000
"""Bytes of a loose file."""


class SubmissionError(Exception):
    """There is nothing to hand in, or it cannot be packed; `say` is why."""

    def __init__(self, key: str, **values: object) -> None:
        self.say = Say(key, **values)
        super().__init__(self.say.text("en"))


@dataclass
class Packed:
    """What is in a submission."""

    pupil: str
    packages: list[str] = field(default_factory=list)
    loose: list[str] = field(default_factory=list)
    answers: int = 0
    left_out: list[Say | Reason] = field(default_factory=list)


def submit(
    home: Path,
    target: Path,
    pupil: str = "",
    lesson: str = "",
    *,
    progress: Progress | None = None,
    known_as: Path | None = None,
) -> Packed:
    """Pack the work of a pupil in a machine's home folder, or in a copy of the one `known_as` to its programs.

    Raises SubmissionError, OSError; then no new file is left.
    """
    if os.path.lexists(target) and not _is_submission(target):
        raise SubmissionError("submit.exists", file=target)
    progress = progress or _progress_of(home, pupil)
    answers = _answers_of(progress, lesson)
    packed = Packed(progress.pupil or pupil, answers=sum(map(len, answers.values())))
    loose = [("home", path) for path in _loose(home, packed)]
    source = home / "ros2_ws" / "src"
    loose += [("loose", path) for path in _loose(source, packed)]
    with tempfile.TemporaryDirectory(prefix="d6s-") as folder:
        exported = Path(folder) / "src.zip"
        if holds_packages(source):
            done = export(home / "ros2_ws", [], exported)
            packed.packages = done.packages
            packed.left_out += done.left_out
        if not (packed.packages or loose or answers):
            raise SubmissionError(
                "submit.nothing", source=(known_as or home) / "ros2_ws" / "src", home=known_as or home
            )
        manifest = {
            "version": VERSION, "pupil": packed.pupil, "lesson": lesson, "home": str(known_as or home), "made": int(time.time()),
            "answers": answers,
        }  # fmt: skip
        with replacing(target, mode=0o666) as file, zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr(MANIFEST, json.dumps(manifest, ensure_ascii=True, indent=1))
            if packed.packages:
                _copy(exported, archive)
            for top, path in loose:
                archive.writestr(f"{top}/{path.name}", path.read_bytes())
                packed.loose.append(path.name)
            file.flush()
            if file.tell() > LARGEST:
                raise SubmissionError("submit.large", size=file.tell() // 1_000_000, most=LARGEST // 1_000_000)
    return packed


def _copy(exported: Path, archive: zipfile.ZipFile) -> None:
    """Take the files of an exported workspace over, below `src`."""
    with zipfile.ZipFile(exported) as inner:
        for info in inner.infolist():
            _, _, inside = info.filename.partition("/")
            if inside.startswith("src/"):
                moved = zipfile.ZipInfo(inside, info.date_time)
                moved.external_attr, moved.compress_type = info.external_attr, zipfile.ZIP_DEFLATED
                archive.writestr(moved, inner.read(info))


def _is_submission(path: Path) -> bool:
    try:
        with zipfile.ZipFile(path) as archive:
            return MANIFEST in archive.namelist()
    except (OSError, zipfile.BadZipFile, ValueError, NotImplementedError):
        return False


def _progress_of(home: Path, pupil: str) -> Progress:
    """The progress of the pupil, of the only one there is, or an empty one."""
    known = pupils(home)
    if pupil:
        try:
            progress = load(file_of(home, pupil))
        except ProgressError as error:
            raise SubmissionError("submit.progress", name=pupil, reason=error) from None
        if not progress.steps and known:
            raise SubmissionError("submit.unknown", name=pupil, names=tuple(each.pupil for each in known))
        progress.pupil = pupil
        return progress
    if len(known) > 1:
        raise SubmissionError("submit.who", names=tuple(each.pupil for each in known))
    return known[0] if known else Progress()


def _answers_of(progress: Progress, lesson: str) -> dict[str, dict[str, str]]:
    """By lesson and step: the letters that were chosen, the last one last."""
    found = {
        name: {step: done.answers for step, done in steps.items() if done.answers}
        for name, steps in progress.steps.items()
        if lesson in ("", name)
    }
    return {name: steps for name, steps in found.items() if steps}


def _loose(folder: Path, packed: Packed) -> list[Path]:
    """The programs that lie directly in a folder; links and what is too large are left out and told."""
    found: list[Path] = []
    if not folder.is_dir():
        return found
    for path in sorted(folder.iterdir()):
        if path.name.startswith(".") or path.suffix not in LOOSE or path.is_dir():
            continue
        if path.is_symlink() or not path.is_file():
            packed.left_out.append(Say("submit.strange", path=path))
        elif not fits(f"home/{path.name}"):
            packed.left_out.append(Say("submit.name", path=path))
        elif path.stat().st_size > LARGEST_LOOSE:
            packed.left_out.append(Say("submit.file_large", path=path, most=LARGEST_LOOSE // 1_000_000))
        elif len(found) >= MOST_LOOSE:
            packed.left_out.append(Say("submit.many", path=path, most=MOST_LOOSE))
        else:
            found.append(path)
    return found


def main(arguments: list[str]) -> int:
    """Run `day6-tui submit ARGUMENTS`; returns the exit status."""
    language = language_of(os.environ, arguments)
    parser = parsers.submit(language)
    options = parser.parse_args(arguments)

    def tell(text: str) -> int:
        print(one_line(f"day6-tui submit: {text}"), file=sys.stderr)
        return 1

    home = (options.home or default_home()).expanduser().resolve()
    if options.pupil and (wrong := name_mistake(options.pupil)):
        return tell(Say(f"name.{wrong}").text(language))
    target = options.output or Path(f"{safe_name(options.pupil or 'submission').replace('%', '_')}.zip")
    try:
        packed = submit(home, target, options.pupil.strip(), options.lesson)
    except SubmissionError as error:
        return tell(error.say.text(language))
    except ExportError as error:
        return tell(error.reason.said(parser.texts))
    except OSError as error:
        return tell(f"{error.filename or target}: {reason(error)}")
    for left in packed.left_out:
        tell(Say("submit.left_out", what=left.said(parser.texts) if isinstance(left, Reason) else left).text(language))
    contents = (*packed.packages, *packed.loose, Say("submit.answers", count=packed.answers).text(language))
    print(one_line(Say("submit.done", file=target, contents=contents).text(language)))
    print(Say("submit.next").text(language))
    return 0
