"""The scripts a build leaves for shells: hooks and `package.*` of each package, `local_setup.*` and `setup.*` of the workspace.

They do little themselves: the changes are written in .dsv files, which `local_setup_util.py`, copied beside them, reads.
"""

from __future__ import annotations

import os
import re
import shlex
import sys
from collections.abc import Iterable
from pathlib import Path

from day6_core.workspace.files import BuildOutput

HOOK_SHELLS = ("ps1", "dsv", "sh")
_UTIL = Path(__file__).with_name("local_setup_util.py")
_MADE_BY = "# made by colcon of day6-tui"

_OWN_FOLDER = {
    "bash": '"$(builtin cd "$(dirname "${BASH_SOURCE[0]}")" > /dev/null && pwd)"',
    "zsh": '"$(builtin cd -q "$(dirname "${(%):-%N}")" > /dev/null && pwd)"',
}
"""How a script finds its own folder; plain sh cannot, so the path is written into it."""


# -- one package -------------------------------------------------------------------------------------------------------


def write_hook(output: BuildOutput, prefix: Path, package: str, name: str, variable: str, value: str) -> list[str]:
    """Write the hooks `share/PACKAGE/hook/NAME.*` that prepend a path to a variable; returns their relative paths."""
    folder = f"share/{package}/hook"
    inside = f"/{value}" if value and not os.path.isabs(value) else value
    whole = value if os.path.isabs(value) else f"$COLCON_CURRENT_PREFIX{inside}"
    texts = {
        "dsv": f"prepend-non-duplicate;{variable};{value}\n",
        "sh": f'{_MADE_BY}\n\n_colcon_prepend_unique_value {variable} "{whole}"\n',
        "ps1": f'{_MADE_BY}\n\ncolcon_prepend_unique_value {variable} "{whole.replace("$COLCON", "$env:COLCON")}"\n',
    }
    for extension in HOOK_SHELLS:
        output.write_text(prefix / folder / f"{name}.{extension}", texts[extension])
    return [f"{folder}/{name}.{extension}" for extension in HOOK_SHELLS]


def write_package_scripts(
    output: BuildOutput, prefix: Path, package: str, hooks: Iterable[str], needs: Iterable[str]
) -> None:
    """Write `share/PACKAGE/package.*` and the file with the package's run-time dependencies."""
    hooks = list(hooks)
    share = prefix / "share" / package
    output.write_text(share / "package.dsv", "".join(f"source;{hook}\n" for hook in hooks))
    output.write_text(share / "package.sh", _package_sh(prefix, package, hooks))
    for shell in ("bash", "zsh"):
        folder = _OWN_FOLDER[shell].replace(" > /dev/null", "/../.. > /dev/null")
        output.write_text(share / f"package.{shell}", _package_of(shell, package, folder))
    output.write_text(share / "package.ps1", _package_ps1(package, hooks))
    output.write_text(prefix / "share" / "colcon-core" / "packages" / package, os.pathsep.join(sorted(needs)))


def _package_sh(prefix: Path, package: str, hooks: list[str]) -> str:
    lines = [hook for hook in hooks if hook.endswith(".sh")]
    sources = "".join(
        f'[ ! -f "$COLCON_CURRENT_PREFIX/{hook}" ] || . "$COLCON_CURRENT_PREFIX/{hook}"\n' for hook in lines
    )
    return f"""{_MADE_BY}
# adds the package {package} to the environment

# put a path first into a variable, once
_colcon_prepend_unique_value() {{
  eval _colcon_rest=\\":\\$$1:\\"
  while case "$_colcon_rest" in *":$2:"*) true ;; *) false ;; esac; do
    _colcon_rest="${{_colcon_rest%%":$2:"*}}:${{_colcon_rest#*":$2:"}}"
  done
  _colcon_rest="${{_colcon_rest#:}}"
  _colcon_rest="${{_colcon_rest%:}}"
  eval export "$1"=\\"\\$2${{_colcon_rest:+:\\$_colcon_rest}}\\"
  unset _colcon_rest
}}

if [ -z "$COLCON_CURRENT_PREFIX" ]; then
  COLCON_CURRENT_PREFIX={shlex.quote(str(prefix))}
  if [ ! -d "$COLCON_CURRENT_PREFIX" ]; then
    echo "$COLCON_CURRENT_PREFIX, where this package was built, is not there: set COLCON_CURRENT_PREFIX to its new place" 1>&2
    unset COLCON_CURRENT_PREFIX
    return 1
  fi
fi
{sources}unset COLCON_CURRENT_PREFIX
"""


def _package_of(shell: str, package: str, folder: str) -> str:
    return f"""{_MADE_BY}
[ -n "$COLCON_CURRENT_PREFIX" ] || COLCON_CURRENT_PREFIX={folder}
. "$COLCON_CURRENT_PREFIX/share/{package}/package.sh"
"""


def _package_ps1(package: str, hooks: list[str]) -> str:
    lines = [hook for hook in hooks if hook.endswith(".ps1")]
    sources = "".join(f'. "$env:COLCON_CURRENT_PREFIX/{hook}"\n' for hook in lines)
    return f"""{_MADE_BY}
# adds the package {package} to the environment

function colcon_prepend_unique_value {{
  param ($name, $value)
  $separator = [IO.Path]::PathSeparator
  $before = @()
  if (Test-Path "Env:$name") {{
    $before = (Get-Item "Env:$name").Value.Split($separator) | Where-Object {{ $_ -and ($_ -ne $value) }}
  }}
  Set-Item "Env:$name" -Value ((@($value) + @($before)) -join $separator)
}}

$env:COLCON_CURRENT_PREFIX = (Get-Item $PSCommandPath).Directory.Parent.Parent.FullName
{sources}Remove-Item Env:\\COLCON_CURRENT_PREFIX
"""


# -- the whole workspace -----------------------------------------------------------------------------------------------


def write_workspace_scripts(output: BuildOutput, install: Path, chained: Iterable[str]) -> None:
    """Write `local_setup.*` and `setup.*`; the latter first source the workspaces in `chained` (underlays, nearest first)."""
    util = _UTIL.read_text(encoding="utf-8")
    underlays = list(chained)[::-1]
    for shell in ("sh", "ps1", *(("bat",) if sys.platform == "win32" else ())):
        output.write_text(install / f"_local_setup_util_{shell}.py", util)
    for shell in ("sh", "bash", "zsh"):
        folder = _OWN_FOLDER.get(shell) or shlex.quote(str(install))
        output.write_text(install / f"local_setup.{shell}", _local_setup(shell, folder))
        output.write_text(install / f"setup.{shell}", _setup(shell, folder, underlays))
    output.write_text(
        install / "local_setup.ps1", _LOCAL_SETUP_PS1.replace("@PYTHON@", sys.executable.replace("'", "''"))
    )
    output.write_text(install / "setup.ps1", _setup_ps1(underlays))
    if sys.platform == "win32":
        output.write_text(install / "local_setup.bat", _LOCAL_SETUP_BAT.replace("@PYTHON@", sys.executable))
        chain = "".join(f'call "{prefix}\\local_setup.bat"\n' for prefix in underlays)
        output.write_text(install / "setup.bat", f'@echo off\n{chain}call "%~dp0local_setup.bat"\n')


def chained_in(setup_file: Path) -> list[str]:
    """Return the workspaces a `setup.*` script, ours or the real colcon's, sources before its own, in order."""
    try:
        text = setup_file.read_text(encoding="utf-8", errors="replace")
    except OSError:
        return []
    found = re.findall(r"""(?m)^COLCON_CURRENT_PREFIX=(?:"([^"$]+)"|'([^']+)'|([^\s"'$]+))$""", text)
    return [next(part for part in parts if part) for parts in found]


def _local_setup(shell: str, folder: str) -> str:
    missing = (
        ""
        if shell != "sh"
        else """if [ ! -d "$_colcon_prefix" ]; then
  echo "$_colcon_prefix, where this workspace was built, is not there: set COLCON_CURRENT_PREFIX to its new place" 1>&2
  unset _colcon_prefix
  return 1
fi
"""
    )
    return f"""{_MADE_BY}
# adds all packages of this folder to the environment

_colcon_prefix="$COLCON_CURRENT_PREFIX"
[ -n "$_colcon_prefix" ] || _colcon_prefix={folder}
{missing}_colcon_python="${{COLCON_PYTHON_EXECUTABLE:-}}"
[ -n "$_colcon_python" ] || _colcon_python={shlex.quote(sys.executable)}
[ -f "$_colcon_python" ] || _colcon_python=python3
_colcon_commands="$("$_colcon_python" "$_colcon_prefix/_local_setup_util_sh.py" sh)"
unset _colcon_prefix _colcon_python
eval "$_colcon_commands"
unset _colcon_commands
"""


def _setup(shell: str, folder: str, underlays: list[str]) -> str:
    chain = "".join(
        f'COLCON_CURRENT_PREFIX={_plain(prefix)}\n[ ! -f "$COLCON_CURRENT_PREFIX/local_setup.{shell}" ] || '
        f'. "$COLCON_CURRENT_PREFIX/local_setup.{shell}"\n'
        for prefix in underlays
    )
    given = '[ -z "$COLCON_CURRENT_PREFIX" ] || _colcon_own="$COLCON_CURRENT_PREFIX"\n' if shell == "sh" else ""
    return f"""{_MADE_BY}
# adds the workspaces that were sourced when this one was built, then all packages of this folder

_colcon_own={folder}
{given}{chain}COLCON_CURRENT_PREFIX="$_colcon_own"
unset _colcon_own
. "$COLCON_CURRENT_PREFIX/local_setup.{shell}"
unset COLCON_CURRENT_PREFIX
"""


def _plain(path: str) -> str:
    return f'"{path}"' if not re.search(r'["$`\\]', path) else shlex.quote(path)


def _setup_ps1(underlays: list[str]) -> str:
    chain = "".join(f'. "{prefix}/local_setup.ps1"\n' for prefix in underlays)
    return f'{_MADE_BY}\n{chain}. "$(Split-Path $PSCommandPath -Parent)/local_setup.ps1"\n'


_LOCAL_SETUP_PS1 = f"""{_MADE_BY}
$_colcon_python = '@PYTHON@'
if (!(Test-Path $_colcon_python -PathType Leaf)) {{ $_colcon_python = 'python3' }}
& $_colcon_python "$(Split-Path $PSCommandPath -Parent)/_local_setup_util_ps1.py" ps1 | ForEach-Object {{ Invoke-Expression $_ }}
"""

_LOCAL_SETUP_BAT = """@echo off
for /f "usebackq delims=" %%L in (`""@PYTHON@" "%~dp0_local_setup_util_bat.py" bat"`) do %%L
"""
