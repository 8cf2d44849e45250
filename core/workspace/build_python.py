"""Builds an ament_python (or plain Python) package by running its setup.py, and leaves what the real colcon leaves."""

from __future__ import annotations

import ast
import json
import os
import queue
import subprocess
import sys
import sysconfig
import traceback
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from day6_tui.core.workspace.files import link_or_copy, write_text
from day6_tui.core.workspace.jobs import JobFailure, Work
from day6_tui.core.workspace.local_setup_util import Environment, source_package
from day6_tui.core.workspace.packages import Package
from day6_tui.core.workspace.settings import Settings
from day6_tui.core.workspace.setup_child import MARK
from day6_tui.core.workspace.setup_scripts import write_hook, write_package_scripts

_CHILD = Path(__file__).with_name("setup_child.py")
_TASK = "colcon.colcon_ros.task.ament_python.build"
_IGNORED = ("setup.py install is deprecated", "easy_install command is deprecated")
"""Warnings that colcon has Python leave out when it runs a setup.py."""
_FALLBACK = "(colcon-ros currently does it implicitly but that fallback will be removed in the future)"


def python_library(prefix: Path) -> Path:
    """Return `lib/python3.12/site-packages` (Windows: `Lib/site-packages`) below a prefix."""
    scheme = "nt" if sys.platform == "win32" else "posix_prefix"
    return Path(sysconfig.get_path("purelib", scheme, vars={"base": str(prefix)}))


def build(package: Package, settings: Settings, work: Work) -> int:
    """Build and install one package; returns an exit status."""
    return _PythonBuild(package, settings, work).run()


@dataclass
class _Described:
    """What setup.py says of itself, as `setup_child` tells it."""

    data: dict[str, Any]

    def data_files(self) -> Iterator[tuple[str, str]]:
        """Yield (source, destination below the prefix)."""
        for entry in self.data.get("data_files") or []:
            folder, sources = ("", [entry]) if isinstance(entry, str) else entry
            for source in sources:
                yield source, "/".join(part for part in (folder.replace(os.sep, "/"), Path(source).name) if part)

    def option(self, section: str, name: str) -> str | None:
        value: str | None = self.data["options"].get(section, {}).get(name)
        return value

    @property
    def sources(self) -> list[str]:
        """Files and top folders that a build in another folder needs links to."""
        where = self.data.get("package_dir") or {}
        folders = [
            where.get(name) or os.path.join(where.get("", ""), name)
            for name in self.data.get("packages") or []
            if "." not in name
        ]
        modules = [f"{name.replace('.', os.sep)}.py" for name in self.data.get("py_modules") or []]
        return ["setup.py", *folders, *modules, *(self.data.get("scripts") or [])]


class _PythonBuild:
    def __init__(self, package: Package, settings: Settings, work: Work) -> None:
        self.package = package
        self.settings = settings
        self.work = work
        self.prefix = settings.prefix(package.name)
        self.folder = settings.build_base / package.name
        self.library = python_library(self.prefix)
        self.environment = self._child_environment()

    def run(self) -> int:
        self.folder.mkdir(parents=True, exist_ok=True)
        self._write_prefix_files()
        hooks = list(self._hook_of_ros())
        process = self._start()
        try:
            described = _Described(self._first_answer(process))
            if self.package.type == "ros.ament_python":
                self._check_data_files(described)
            self.library.mkdir(parents=True, exist_ok=True)
            if self.settings.symlink_install:
                self._undo_install()
                request = self._develop(described)
            else:
                self._undo_develop()
                request = self._install(described)
            status = self._second_answer(process, request)
        finally:
            self._close(process)
        if status:
            return status
        hooks = [*self._hooks(), *hooks]
        if self.settings.symlink_install:
            self._after_develop(described)
            hooks += self._develop_hooks(described)
        needs = self.package.dependencies("run")
        write_package_scripts(self.prefix, self.package.name, hooks, needs)
        return 0

    # -- the child -----------------------------------------------------------------------------------------------------

    def _child_environment(self) -> dict[str, str]:
        source = Environment(self.settings.environment)
        for name in self.settings.needs.get(self.package.name, ()):
            source_package(str(self.settings.prefix(name)), name, source)
        env = dict(source.variables)
        env.pop("PYTHONDONTWRITEBYTECODE", None)  # what is installed is compiled, which also finds its syntax errors
        entries = [
            str(self.folder / "prefix_override"),
            str(self.library),
            *env.get("PYTHONPATH", "").split(os.pathsep),
        ]
        env["PYTHONPATH"] = os.pathsep.join(entry for entry in entries if entry)
        env.update(COLCON="1", PYTHONUTF8="1", PYTHONUNBUFFERED="1")
        return env

    def _write_prefix_files(self) -> None:
        write_text(
            self.folder / "prefix_override" / "sitecustomize.py",
            f"import sys\n\nif sys.prefix == {sys.prefix!r}:\n    sys.real_prefix = sys.prefix\n"
            f"    sys.prefix = sys.exec_prefix = {str(self.prefix)!r}\n",
        )
        write_text(self.folder / "colcon_command_prefix_setup_py.sh", "# nothing is needed before a command\n")
        lines = "".join(f"{name}={value}\n" for name, value in sorted(self.environment.items()))
        write_text(self.folder / "colcon_command_prefix_setup_py.sh.env", lines)

    def _start(self) -> subprocess.Popen[bytes]:
        setup = self.package.path / "setup.py"
        if not setup.is_file():
            if self.package.type == "ros.ament_python":
                self._check_data_files(_Described({}))
            self.library.mkdir(parents=True, exist_ok=True)
            ignored = [word for what in _IGNORED for word in ("-W", f"ignore:{what}")]
            command = [sys.executable, *ignored, "setup.py", "--help-commands"]
            reason = f"can't open file '{setup}': [Errno 2] No such file or directory"
            raise _failed(self.work, AssertionError(f"Expected {command} to pass: {sys.executable}: {reason}\n"))
        # The prefix is of no use to the interpreter that runs setup.py: every folder is named to setuptools.
        env = {**self.environment, "PYTHONPATH": self.environment["PYTHONPATH"].partition(os.pathsep)[2]}
        process = self.work.start([sys.executable, str(_CHILD)], self.package.path, env)
        self._first_errors: list[str] = []
        self._first_output: list[str] = []
        self._marked = False
        self._answers: queue.Queue[str | None] = queue.Queue()
        self._readers = [
            self.work.copy(process.stdout, self._on_stdout, self._answers.put),
            self.work.copy(process.stderr, self._on_stderr),
        ]
        return process

    def _on_stdout(self, line: str) -> None:
        if line.startswith(MARK):
            self._answers.put(line[1:])
        elif self._answered:
            self.work.stdout(line)
        else:
            self._first_output.append(line)

    def _on_stderr(self, line: str) -> None:
        if self._marked:
            self.work.stderr(line)
        elif line.startswith(MARK):
            self._marked = True
        else:
            self._first_errors.append(line)

    _answered = False

    def _first_answer(self, process: subprocess.Popen[bytes]) -> dict[str, Any]:
        """Wait for what setup.py says of itself. What it prints to standard error then goes to the terminal as it is."""
        answer = self._answers.get()
        self._answered = answer is not None
        if answer is None:
            status = self.work.reap(process, self._readers)
        if self._first_errors and not self.work.stopped:
            self.settings.print_error("".join(self._first_errors))
        if answer is None:
            raise _failed(self.work, subprocess.CalledProcessError(status, [sys.executable, "setup.py", "--dry-run"]))
        try:
            # colcon reads what setup.py says of itself from the same stream, where a print() of the student's comes after it.
            ast.literal_eval("{}" + "".join(self._first_output))
        except (SyntaxError, ValueError) as error:
            raise _failed(self.work, error) from None
        described: dict[str, Any] = json.loads(answer)
        return described

    def _second_answer(self, process: subprocess.Popen[bytes], request: dict[str, Any]) -> int:
        shown = f"{sys.executable} setup.py {' '.join(request['commands'])}"
        cwd = Path(request["cwd"])
        self.work.tell_command(cwd, shown)
        assert process.stdin is not None
        with suppress(OSError):  # it was interrupted: its status says so
            process.stdin.write(json.dumps(request).encode() + b"\n")
            process.stdin.close()
        return self.work.finish(process, self._readers, cwd, shown)

    def _close(self, process: subprocess.Popen[bytes]) -> None:
        """Let the child end, which without a request it does at once."""
        if process.stdin is not None and not process.stdin.closed:
            with suppress(OSError):
                process.stdin.close()
        self.work.reap(process, self._readers)

    # -- what is run ---------------------------------------------------------------------------------------------------

    def _install(self, described: _Described) -> dict[str, Any]:
        scripts = described.option("install", "install_scripts")
        source = os.path.realpath(self.package.path)
        commands = ["egg_info", "--egg-base", os.path.relpath(os.path.realpath(self.folder), source)]
        commands += ["build", "--build-base", str(self.folder / "build")]
        commands += ["install", "--prefix", str(self.prefix), "--install-lib", str(self.library)]
        commands += ["--install-data", str(self.prefix), "--record", str(self.folder / "install.log")]
        commands += ["--install-scripts", _based(scripts, self.prefix)]
        commands += ["--single-version-externally-managed"]
        if described.data.get("data_files"):
            commands += ["install_data", *(["--force"] if self._was_developed else [])]
        return {"cwd": source, "commands": commands}

    def _develop(self, described: _Described) -> dict[str, Any]:
        for name in dict.fromkeys(described.sources):
            link_or_copy(self.package.path / name, self.folder / name)
        if (self.package.path / "setup.cfg").exists():
            link_or_copy(self.package.path / "setup.cfg", self.folder / "setup.cfg")
        renamed = described.data.get("package_dir") or {}
        for name, folder in renamed.items():
            if name and "." not in name:
                link_or_copy(self.package.path / folder, self.folder / name)
        for source, _ in described.data_files():
            if (self.package.path / source).exists():
                link_or_copy(self.package.path / source, self.folder / _relative(source, self.package.path))
        scripts = _based(described.option("develop", "script_dir"), self.prefix)
        commands = ["egg_info", "install_scripts", "--install-dir", scripts, "--build-dir", str(self.folder / "build")]
        return {"cwd": str(self.folder), "commands": commands}

    def _after_develop(self, described: _Described) -> None:
        name = str(described.data["name"]).replace("_", "-")
        write_text(self.library / f"{name}.egg-link", f"{self.folder}\n.")
        for source, destination in described.data_files():
            linked = self.folder / _relative(source, self.package.path)
            if not linked.exists():
                raise _failed(self.work, OSError(f"can't copy '{source}': doesn't exist or not a regular file"))
            link_or_copy(linked, self.prefix / destination)

    _was_developed = False

    def _undo_develop(self) -> None:
        """Take away what a build with --symlink-install left: links in the build folder and in the prefix."""
        if not (self.folder / "setup.py").is_symlink():
            return
        self._was_developed = True
        for path in list(self.folder.rglob("*")):
            if path.is_symlink():
                path.unlink()
        for path in list(self.prefix.rglob("*")):
            if path.is_symlink() or path.suffix == ".egg-link":
                path.unlink()

    def _undo_install(self) -> None:
        """Take away the Python files of a build without --symlink-install: they would shadow the links."""
        record = self.folder / "install.log"
        if not record.is_file():
            return
        for line in record.read_text(encoding="utf-8", errors="surrogateescape").splitlines():
            path = Path(line)
            if self.library in path.parents and (path.is_file() or path.is_symlink()):
                path.unlink()
                for parent in path.parents:
                    if parent == self.library or any(parent.iterdir()):
                        break
                    parent.rmdir()
        record.unlink()

    # -- what ROS adds -------------------------------------------------------------------------------------------------

    def _check_data_files(self, described: _Described) -> None:
        name = self.package.name
        installed = {destination: source for source, destination in described.data_files()}
        marker = f"share/ament_index/resource_index/packages/{name}"
        if marker not in installed:
            self.settings.warn(
                _TASK, f"Package '{name}' doesn't explicitly install a marker in the package index {_FALLBACK}"
            )
            write_text(self.prefix / marker, "")
        manifest = f"share/{name}/package.xml"
        if installed.get(manifest) != "package.xml":
            self.settings.warn(_TASK, f"Package '{name}' doesn't explicitly install the 'package.xml' file {_FALLBACK}")
            text = (self.package.path / "package.xml").read_text(encoding="utf-8", errors="surrogateescape")
            write_text(self.prefix / manifest, text)

    def _hooks(self) -> Iterator[str]:
        name = self.package.name
        binaries = self.prefix / "bin"
        has_binaries = binaries.is_dir() and any(path.is_file() for path in binaries.iterdir())
        if has_binaries:
            yield from write_hook(self.prefix, name, "path", "PATH", "bin")
        yield from write_hook(
            self.prefix, name, "pythonpath", "PYTHONPATH", self.library.relative_to(self.prefix).as_posix()
        )
        if has_binaries:
            yield from write_hook(self.prefix, name, "pythonscriptspath", "PATH", "bin")

    def _hook_of_ros(self) -> Iterator[str]:
        """Write the hook that colcon-ros leaves even where setup.py then fails."""
        if self.package.type.startswith("ros."):
            yield from write_hook(self.prefix, self.package.name, "ament_prefix_path", "AMENT_PREFIX_PATH", "")

    def _develop_hooks(self, described: _Described) -> list[str]:
        root = (described.data.get("package_dir") or {}).get("")
        folder = self.folder / root if root else self.folder
        hooks = write_hook(folder, self.package.name, "pythonpath_develop", "PYTHONPATH", str(folder))
        return [Path(os.path.relpath(folder / hook, self.prefix)).as_posix() for hook in hooks]


def _based(folder: str | None, prefix: Path) -> str:
    return str(prefix / "bin") if folder is None else folder.replace("$base", str(prefix))


def _relative(source: str, folder: Path) -> str:
    return os.path.relpath(source, folder) if os.path.isabs(source) else source


def _failed(work: Work, error: Exception) -> JobFailure:
    """Tell an error as colcon tells an exception in a task: a traceback in the package's block, the text again at the end."""
    if not work.stopped:
        work.stderr("Traceback (most recent call last):\n" + "".join(traceback.format_exception_only(error)))
    return JobFailure(str(error))
