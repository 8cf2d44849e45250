"""The traps of top-level folders as a package: forgotten sub-packages, lost data files, second copies of modules."""

from __future__ import annotations

import email
import re
import subprocess
import sys
import tarfile
import zipfile
from collections.abc import Iterator
from pathlib import Path

import pytest
from markdown_it import MarkdownIt

from tests.support.source_files import OF_DISTRIBUTIONS, ON_THE_PATH, PACKAGES, ROOT, SHARE, copy_of_checkout

VENDORED = PACKAGES["day6_tui"] / "day6_tui/web/static/vendor/xterm"


def files() -> list[Path]:
    found = [path for name, base in PACKAGES.items() for path in (base / name).rglob("*")]
    return [path for path in found if path.is_file() and not any(_is_cache(part) for part in path.parts)]


def _is_cache(part: str) -> bool:
    """Say whether a part of a path is some tool's cache."""
    return part == "__pycache__" or (part.startswith(".") and part.endswith("_cache"))


def test_each_top_folder_holds_one_package_and_nothing_else() -> None:
    held = {name: [path.name for path in base.iterdir() if not _is_cache(path.name)] for name, base in PACKAGES.items()}
    assert held == {name: [name] for name in PACKAGES}


def test_every_folder_with_python_in_it_is_a_package() -> None:
    bare = {
        str(path.parent.relative_to(ROOT))
        for path in files()
        if path.suffix == ".py"
        and not {ON_THE_PATH, OF_DISTRIBUTIONS, SHARE} & set(path.parents)
        and not (path.parent / "__init__.py").exists()
    }
    assert bare == set()


@pytest.mark.process
def test_the_packages_themselves_import_nothing() -> None:
    code = (
        f"import sys; before = set(sys.modules); import {', '.join(PACKAGES)}; "
        "print({name for name in set(sys.modules) - before if name.startswith('day6_') and '.' in name})"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT.anchor)
    assert done.stdout == "set()\n"


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A wheel and a source distribution of a copy of the checkout, so that nothing stale can leak into them."""
    folder = tmp_path_factory.mktemp("built")
    copy = copy_of_checkout(folder / "checkout")
    code = f"import hatchling.build as b; b.build_wheel({str(folder)!r}); b.build_sdist({str(folder)!r})"
    done = subprocess.run([sys.executable, "-c", code], cwd=copy, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return folder


@pytest.fixture(scope="module")
def wheel(built: Path) -> zipfile.ZipFile:
    (path,) = built.glob("*.whl")
    return zipfile.ZipFile(path)


def content(wheel: zipfile.ZipFile) -> set[str]:
    """Return what it installs as packages, without its own metadata and what is for the rest of the system."""
    return {name for name in wheel.namelist() if not name.split("/")[0].endswith((".dist-info", ".data"))}


@pytest.mark.process
def test_the_wheel_holds_every_source_and_data_file(wheel: zipfile.ZipFile) -> None:
    packed = content(wheel)
    assert packed == {
        path.relative_to(base).as_posix() for base in PACKAGES.values() for path in files() if base in path.parents
    }


@pytest.mark.process
def test_the_wheel_brings_no_other_top_level_name(wheel: zipfile.ZipFile) -> None:
    tops = {name.split("/")[0] for name in content(wheel)}
    assert tops == set(PACKAGES)


@pytest.mark.process
def test_the_wheel_brings_the_man_page_and_nothing_else_for_the_system(wheel: zipfile.ZipFile) -> None:
    shared = {name.partition(".data/")[2]: wheel.read(name) for name in wheel.namelist() if ".data/" in name}
    assert shared == {"data/share/man/man1/day6-tui.1": (ROOT / "docs" / "man" / "day6-tui.1").read_bytes()}


@pytest.mark.process
def test_the_wheel_declares_the_command(wheel: zipfile.ZipFile) -> None:
    (entry_points,) = [name for name in {*wheel.namelist()} - content(wheel) if name.endswith("entry_points.txt")]
    assert "day6-tui = day6_tui.main:main" in wheel.read(entry_points).decode()


@pytest.mark.process
def test_the_page_of_the_package_links_only_what_is_in_the_repository(wheel: zipfile.ZipFile) -> None:
    (name,) = [name for name in wheel.namelist() if name.partition("/")[2] == "METADATA"]
    metadata = email.message_from_bytes(wheel.read(name))
    pages = dict(line.split(", ") for line in metadata.get_all("Project-URL", []))
    repository, tag = pages["Homepage"], f"v{metadata['Version']}"
    own = re.compile(rf"{re.escape(repository)}/(?:blob|raw)/{re.escape(tag)}/([^#]+)")
    linked = list(targets(metadata.get_payload()))
    assert [target for target in linked if not target.startswith(("https://", "http://127.0.0.1", "#"))] == []
    files = [found[1] for target in linked if (found := own.match(target))]
    assert files and [file for file in files if not (ROOT / file).exists()] == []


def targets(markdown: str) -> Iterator[str]:
    """Yield where the links and pictures of a text lead, as a reader of Markdown understands it."""
    for token in MarkdownIt().parse(markdown):
        for inner in (token, *(token.children or ())):
            yield from (str(inner.attrs[name]) for name in ("href", "src") if name in inner.attrs)
            if inner.type in ("html_block", "html_inline"):
                yield from re.findall(r'(?:href|src|srcset)="([^"]+)"', inner.content)


@pytest.mark.process
def test_the_wheel_brings_every_license_that_its_notice_speaks_of(wheel: zipfile.ZipFile) -> None:
    (folder,) = {top for name in wheel.namelist() if (top := name.split("/")[0]).endswith(".dist-info")}
    licenses = [name for name in wheel.namelist() if name.startswith(f"{folder}/licenses/")]
    shipped = {name.rpartition(".")[2] for name in licenses if "/LICENSE." in name}
    assert shipped == {path.name.removeprefix("LICENSE.") for path in VENDORED.rglob("LICENSE.*")}
    assert {"LICENSE", "NOTICE"} <= {name.removeprefix(f"{folder}/licenses/") for name in licenses}


@pytest.mark.process
def test_the_source_distribution_has_all_that_the_repository_has(built: Path) -> None:
    (path,) = built.glob("*.tar.gz")
    with tarfile.open(path) as packed:
        names = {name.partition("/")[2] for name in packed.getnames()}
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, stdout=subprocess.PIPE, check=False).stdout.decode()
    wanted = set(filter(None, listed.split("\0"))) or {
        "README.md",
        "CHANGELOG.md",
        "hub/README.md",
        "tests/conftest.py",
    }
    assert wanted - names <= {".gitattributes"}


def test_data_files_are_found_through_real_packages() -> None:
    from importlib.resources import files as resources

    assert resources("day6_urdf").joinpath("models/day6_bot.urdf").is_file()
    assert resources("day6_core.ros").joinpath("share/std_msgs/msg/String.msg").is_file()
