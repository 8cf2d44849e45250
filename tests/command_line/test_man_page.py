"""The man page in the repository is the one that the parsers make."""

from __future__ import annotations

import importlib.util
import re
import shutil
import subprocess

import pytest

from day6_tui.commands.table import commands
from tests.support.source_files import ROOT

_spec = importlib.util.spec_from_file_location("man_page", ROOT / ".ci" / "man_page.py")
assert _spec is not None and _spec.loader is not None
man_page = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(man_page)


def test_the_page_is_that_of_the_parsers() -> None:
    assert man_page.PAGE.read_text(encoding="ascii") == man_page.page(), "stale: run python .ci/man_page.py"


def test_the_page_names_every_command_and_option() -> None:
    page = man_page.page().replace("\\-", "-")
    for command in commands():
        parser = command.parser("en")
        if parser is None:
            assert f"\n.B {command.name}\n" in page
            continue
        for each in (parser, *parser.verbs.values()):
            assert f'.SS "{each.prog}"' in page or not command.name
            for action in each.actions:
                assert all(f"\\fB{option}\\fR" in page for option in action.option_strings), action.option_strings


def test_no_text_can_be_taken_for_a_command_of_roff() -> None:
    assert man_page._text(".x\n'y\\-…") == "\\&.x\n\\&'y\\e\\-\\[u2026]"


@pytest.mark.outside
@pytest.mark.process
@pytest.mark.parametrize(("tool", "command"), [("groff", "groff -ww -man -Tutf8"), ("mandoc", "mandoc -W warning")])
def test_the_page_is_read_without_a_warning(tool: str, command: str) -> None:
    if shutil.which(tool) is None:
        pytest.skip(f"there is no {tool} here")
    done = subprocess.run(
        [*command.split(), str(man_page.PAGE)], capture_output=True, encoding="utf-8", errors="replace"
    )
    warnings = [
        line for line in done.stderr.splitlines() if "WARNING: missing date" not in line and "see above" not in line
    ]  # it would be stale every day
    assert not warnings and re.search(r"day6.tui.serve", done.stdout)
