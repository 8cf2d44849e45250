"""Builds an ament_python (or plain Python) package by running its setup.py, and leaves the same files as the real colcon."""

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

from day6_core.ros import differences
from day6_core.ros.home_python import prefix_of, python_of
from day6_core.workspace.files import NotOurOutput, links_in
from day6_core.workspace.jobs import JobFailure, Work
from day6_core.workspace.local_setup_util import Environment, source_package
from day6_core.workspace.packages import Package
from day6_core.workspace.settings import BuildSettings
from day6_core.workspace.setup_child import MARK, TAKES_TESTS_REQUIRE
from day6_core.workspace.setup_scripts import write_hook, write_package_scripts

_CHILD = Path(__file__).with_name("setup_child.py")
_TASK = "colcon.colcon_ros.task.ament_python.build"
_IGNORED = ("setup.py install is deprecated", "easy_install command is deprecated")
"""Warnings that colcon tells Python to ignore when it runs a setup.py."""
_FALLBACK = "(colcon-ros currently does it implicitly but that fallback will be removed in the future)"


def python_library(prefix: Path) -> Path:
    """Return `lib/python3.12/site-packages` (Windows: `Lib/site-packages`) below a prefix."""
    scheme = "nt" if sys.platform == "win32" else "posix_prefix"
    return Path(sysconfig.get_path("purelib", scheme, vars={"base": str(prefix)}))


def build(package: Package, settings: BuildSettings, work: Work) -> int:
    """Build and install one package; returns an exit status."""
    return _PythonBuild(package, settings, work).run()


@dataclass
class _Description:
    """The arguments of setup() in setup.py, as `setup_child` reports them."""

    data: dict[str, Any]

    def named_data_files(self) -> Iterator[tuple[str, str]]:
        """Yield (folder below the prefix, source), as they are written in setup.py."""
        for entry in self.data.get("data_files") or []:
            folder, sources = ("", [entry]) if isinstance(entry, str) else entry
            yield from ((folder, source) for source in sources)

    def data_files(self) -> Iterator[tuple[str, str]]:
        """Yield (source, destination below the prefix)."""
        for folder, source in self.named_data_files():
            yield source, "/".join(part for part in (folder.replace(os.sep, "/"), Path(source).name) if part)

    def option(self, section: str, name: str) -> str | None:
        value: str | None = self.data["options"].get(section, {}).get(name)
        return value

    @property
    def modules(self) -> list[str]:
        """The files of single modules."""
        return [f"{name.replace('.', os.sep)}.py" for name in self.data.get("py_modules") or []]

    @property
    def sources(self) -> list[str]:
        """Files and top-level folders that a build in another folder needs links to."""
        where = self.data.get("package_dir") or {}
        folders = [
            where.get(name) or os.path.join(where.get("", ""), name)
            for name in self.data.get("packages") or []
            if "." not in name
        ]
        return ["setup.py", *folders, *self.modules, *(self.data.get("scripts") or [])]


class _PythonBuild:
    def __init__(self, package: Package, settings: BuildSettings, work: Work) -> None:
        self.package = package
        self.settings = settings
        self.output = settings.output
        self.work = work
        self.prefix = settings.prefix(package.name)
        self.folder = settings.build_base / package.name
        self.library = python_library(self.prefix)
        self.environment = self._child_environment()
        self._python = python_of(settings.environment)

    def run(self) -> int:
        self.output.make_folder(self.folder)
        self._write_prefix_files()
        hooks = list(self._hook_of_ros())
        process = self._start()
        try:
            description = _Description(self._read_description(process))
            if self.package.type == "ros.ament_python":
                self._check_data_files(description)
            self._check_places(description)
            self.output.make_folder(self.library)
            if self.settings.symlink_install:
                self._undo_install()
                request = self._develop(description)
            else:
                self._undo_develop()
                request = self._install(description)
            status = self._run_commands(process, request)
        finally:
            self._close(process)
        if status:
            return status
        hooks = [*self._hooks(), *hooks]
        if self.settings.symlink_install:
            self._link_develop(description)
            hooks += self._develop_hooks(description)
        needs = self.package.dependencies("run")
        hooks += self.package.meta.hooks
        write_package_scripts(self.output, self.prefix, self.package.name, hooks, needs)
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
        self.output.write_text(
            self.folder / "prefix_override" / "sitecustomize.py",
            f"import sys\n\nif sys.prefix == {prefix_of(self._python)!r}:\n    sys.real_prefix = sys.prefix\n"
            f"    sys.prefix = sys.exec_prefix = {str(self.prefix)!r}\n",
        )
        self.output.write_text(
            self.folder / "colcon_command_prefix_setup_py.sh", "# nothing is needed before a command\n"
        )
        lines = "".join(f"{name}={value}\n" for name, value in sorted(self.environment.items()))
        self.output.write_text(self.folder / "colcon_command_prefix_setup_py.sh.env", lines)

    def _start(self) -> subprocess.Popen[bytes]:
        setup = self.package.path / "setup.py"
        if not setup.is_file():
            if self.package.type == "ros.ament_python":
                self._check_data_files(_Description({}))
            self.output.make_folder(self.library)
            ignored = [word for what in _IGNORED for word in ("-W", f"ignore:{what}")]
            command = [self._python, *ignored, "setup.py", "--help-commands"]
            reason = f"can't open file '{setup}': [Errno 2] No such file or directory"
            raise _failed(self.work, AssertionError(f"Expected {command} to pass: {self._python}: {reason}\n"))
        # The interpreter that runs setup.py does not need the prefix: setuptools gets every folder as an option.
        env = {**self.environment, "PYTHONPATH": self.environment["PYTHONPATH"].partition(os.pathsep)[2]}
        told = [TAKES_TESTS_REQUIRE] if differences.value("setuptools.takes_tests_require") else []
        process = self.work.start([self._python, str(_CHILD), *told], self.package.path, env)
        self._first_errors: list[str] = []
        self._first_output: list[str] = []
        self._marked = False
        self._replies: queue.Queue[str | None] = queue.Queue()
        self._readers = [
            self.work.copy(process.stdout, self._on_stdout, self._replies.put),
            self.work.copy(process.stderr, self._on_stderr),
        ]
        return process

    def _on_stdout(self, line: str) -> None:
        if line.startswith(MARK):
            self._replies.put(line[1:])
        elif self._is_described:
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

    _is_described = False

    def _read_description(self, process: subprocess.Popen[bytes]) -> dict[str, Any]:
        """Wait for the arguments of setup(). Anything setup.py has printed to standard error goes to the terminal unchanged."""
        reply = self._replies.get()
        self._is_described = reply is not None
        if reply is None:
            status = self.work.reap(process, self._readers)
        if self._first_errors and not self.work.stopped:
            self.settings.print_error("".join(self._first_errors))
        if reply is None:
            raise _failed(self.work, subprocess.CalledProcessError(status, [self._python, "setup.py", "--dry-run"]))
        try:
            # colcon reads the arguments from the same stream, so that a print() in setup.py, which comes after them, breaks it.
            ast.literal_eval("{}" + "".join(self._first_output))
        except (SyntaxError, ValueError) as error:
            raise _failed(self.work, error) from None
        description: dict[str, Any] = json.loads(reply)
        return description

    def _run_commands(self, process: subprocess.Popen[bytes], request: dict[str, Any]) -> int:
        shown = f"{self._python} setup.py {' '.join(request['commands'])}"
        cwd = Path(request["cwd"])
        self.work.log_command(cwd, shown)
        assert process.stdin is not None
        with suppress(OSError):  # it was interrupted: its status says so
            process.stdin.write(json.dumps(request).encode() + b"\n")
            process.stdin.close()
        return self.work.finish(process, self._readers, cwd, shown)

    def _close(self, process: subprocess.Popen[bytes]) -> None:
        """Let the child end; without a request it does so at once."""
        if process.stdin is not None and not process.stdin.closed:
            with suppress(OSError):
                process.stdin.close()
        self.work.reap(process, self._readers)

    # -- commands of setuptools ----------------------------------------------------------------------------------------

    def _install(self, description: _Description) -> dict[str, Any]:
        scripts = description.option("install", "install_scripts")
        source = os.path.realpath(self.package.path)
        commands = ["egg_info", "--egg-base", os.path.relpath(os.path.realpath(self.folder), source)]
        commands += ["build", "--build-base", str(self.folder / "build")]
        commands += ["install", "--prefix", str(self.prefix), "--install-lib", str(self.library)]
        commands += ["--install-data", str(self.prefix), "--record", str(self.folder / "install.log")]
        commands += ["--install-scripts", _based(scripts, self.prefix)]
        commands += ["--single-version-externally-managed"]
        if description.data.get("data_files"):
            commands += ["install_data", *(["--force"] if self._was_developed else [])]
        return {"cwd": source, "commands": commands}

    def _develop(self, description: _Description) -> dict[str, Any]:
        for name in description.modules:
            if not (self.package.path / name).exists():
                raise _failed(self.work, RuntimeError(f"Provided py_modules '{name}' does not exist"))
        for target, source in self._wanted_links(description).items():
            self.output.link(source, target)
        scripts = _based(description.option("develop", "script_dir"), self.prefix)
        for path in links_in(Path(scripts)):  # setuptools would write the program into a link's target
            if self._is_own_link(path):
                self.output.remove(path)
        # A linked folder may have the name of one of setuptools' own folders; it must not write into the sources then.
        root = (description.data.get("package_dir") or {}).get("") or "."
        base = root if self._is_own_folder(self.folder / root) else "."
        made = self.folder / ("build" if self._is_own_folder(self.folder / "build") else "build.setuptools") / "scripts"
        commands = ["egg_info", "--egg-base", base] if base != root else ["egg_info"]
        if description.data.get("scripts"):
            commands += ["build_scripts", "--build-dir", str(made)]
        commands += ["install_scripts", "--install-dir", scripts, "--build-dir", str(made)]
        return {"cwd": str(self.folder), "commands": commands}

    def _is_own_folder(self, path: Path) -> bool:
        """Return whether a file written there would stay in the build folder."""
        inside = Path(os.path.normpath(path / "x"))
        return self.folder in inside.parents and self.output.owns(inside)

    def _wanted_links(self, description: _Description) -> dict[Path, Path]:
        """Return the links of the build folder, target → source; files in a linked folder need no link of their own.

        The real colcon checks whether both are the same file by then, which has the same effect.
        """
        wanted: dict[Path, Path] = {}
        renamed = {name: folder for name, folder in (description.data.get("package_dir") or {}).items() if name}
        names = [(name, name) for name in ("setup.py", "setup.cfg", *description.sources)]
        names += [(name, folder) for name, folder in renamed.items() if "." not in name]
        names += [(_relative(source, self.package.path),) * 2 for source, _ in description.data_files()]
        for name, where in names:
            target, source = Path(os.path.normpath(self.folder / name)), self.package.path / where
            if self.folder in target.parents and os.path.lexists(source):
                wanted.setdefault(target, source)
        return {
            target: source for target, source in wanted.items() if not any(each in wanted for each in target.parents)
        }

    def _link_develop(self, description: _Description) -> None:
        name = str(description.data["name"]).replace("_", "-")
        self.output.write_text(self.library / f"{name}.egg-link", f"{self.folder}\n.")
        for name, destination in description.data_files():
            source = self.package.path / name
            linked = self.folder / _relative(name, self.package.path)
            if not source.is_file():
                raise _failed(self.work, OSError(f"can't copy '{name}': doesn't exist or not a regular file"))
            self.output.link(linked if _is_same(linked, source) else source, self.prefix / destination)

    _was_developed = False

    def _undo_develop(self) -> None:
        """Remove the links of a build with --symlink-install from the build folder and the prefix."""
        linked = list(links_in(self.folder))
        installed = [path for path in links_in(self.prefix) if self._is_own_link(path)]
        egg_links = [path for path in self.library.glob("*.egg-link") if self._is_own_egg_link(path)]
        self._was_developed = bool(linked or installed)
        for path in (*linked, *installed, *egg_links):
            self.output.remove(path)

    def _is_own_link(self, path: Path) -> bool:
        """Return whether a link in the prefix leads into this package: a merged prefix also has those of others.

        A broken link counts as well: the workspace was moved, or came from another computer together with its build, or
        `build` was removed. setuptools cannot overwrite it.
        """
        if not path.is_symlink():
            return False
        if not path.exists():
            return True
        if self.folder in Path(os.path.normpath(path.parent / path.readlink())).parents:
            return True  # the file was removed from the sources and left a broken link
        return Path(os.path.realpath(path)).is_relative_to(os.path.realpath(self.package.path))

    def _is_own_egg_link(self, path: Path) -> bool:
        return path.read_text(encoding="utf-8", errors="surrogateescape").partition("\n")[0] == str(self.folder)

    def _undo_install(self) -> None:
        """Remove the Python files of a build without --symlink-install: they would shadow the links."""
        record = self.folder / "install.log"
        if not record.is_file() or record.is_symlink():
            return
        for line in record.read_text(encoding="utf-8", errors="surrogateescape").splitlines():
            path = Path(os.path.normpath(line))
            if self.library in path.parents and self.output.owns(path) and (path.is_file() or path.is_symlink()):
                self.output.remove(path)
                for parent in path.parents:
                    if parent == self.library or not self.output.remove_folder_if_empty(parent):
                        break
        self.output.remove(record)

    def _check_places(self, description: _Description) -> None:
        """Check that setuptools will not write outside our folders, by `..`, an absolute path or over a link.

        Raises:
            NotOurs: it would.
        """
        built = self.folder / "build" / "lib"
        packages = [(name, os.path.join(*name.split("."))) for name in description.data.get("packages") or [] if name]
        modules = [(name, os.path.join(*name.split("."))) for name in description.data.get("py_modules") or [] if name]
        for package, patterns in (description.data.get("package_data") or {}).items():
            packages += [(pattern, os.path.join(*package.split("."), pattern)) for pattern in patterns if package]
        for name, path in (*packages, *modules):
            target = Path(os.path.normpath(built / path))
            if self.folder not in target.parents:
                raise NotOurOutput(
                    f"setup.py: '{name}' would be installed to '{target}', outside the build and install folders"
                )
        targets = [self.library / path for _, path in (*packages, *modules) if ".." not in path.split(os.sep)]
        targets += [self.prefix / destination for _, destination in description.data_files()]
        if self.settings.symlink_install:
            targets.append(
                Path(self.folder, _based(description.option("develop", "script_dir"), self.prefix), "program")
            )
        else:
            targets.append(
                Path(self.package.path, _based(description.option("install", "install_scripts"), self.prefix), "x")
            )
            targets.append(self.folder / "build" / "lib" / "x")
        for target in targets:
            self.output.remove_links_above(target)

    # -- additions of colcon-ros ---------------------------------------------------------------------------------------

    def _check_data_files(self, description: _Description) -> None:
        name = self.package.name
        for folder, source in description.named_data_files():
            for path in (folder, source):
                if os.path.isabs(path):
                    raise _failed(self.work, AssertionError(f"'data_files' must be relative, '{path}' is absolute"))
        installed = {destination: source for source, destination in description.data_files()}
        marker = f"share/ament_index/resource_index/packages/{name}"
        if marker not in installed:
            self.settings.warn(
                _TASK, f"Package '{name}' doesn't explicitly install a marker in the package index {_FALLBACK}"
            )
            self.output.write_text(self.prefix / marker, "")
        manifest = f"share/{name}/package.xml"
        if installed.get(manifest) != "package.xml":
            self.settings.warn(_TASK, f"Package '{name}' doesn't explicitly install the 'package.xml' file {_FALLBACK}")
            if self.settings.symlink_install:
                self.output.link(self.package.path / "package.xml", self.prefix / manifest)
            else:
                self.output.copy(self.package.path / "package.xml", self.prefix / manifest)

    def _hooks(self) -> Iterator[str]:
        name = self.package.name
        binaries = self.prefix / "bin"
        has_binaries = binaries.is_dir() and any(path.is_file() for path in binaries.iterdir())
        if has_binaries:
            yield from write_hook(self.output, self.prefix, name, "path", "PATH", "bin")
        yield from write_hook(
            self.output, self.prefix, name, "pythonpath", "PYTHONPATH", self.library.relative_to(self.prefix).as_posix()
        )
        if has_binaries:
            yield from write_hook(self.output, self.prefix, name, "pythonscriptspath", "PATH", "bin")

    def _hook_of_ros(self) -> Iterator[str]:
        """Write the hook that colcon-ros leaves even where setup.py then fails."""
        if self.package.type.startswith("ros."):
            yield from write_hook(
                self.output, self.prefix, self.package.name, "ament_prefix_path", "AMENT_PREFIX_PATH", ""
            )

    def _develop_hooks(self, description: _Description) -> list[str]:
        root = (description.data.get("package_dir") or {}).get("")
        folder = self.folder / root if root else self.folder
        place = folder if self._is_own_folder(folder) else self.folder
        hooks = write_hook(self.output, place, self.package.name, "pythonpath_develop", "PYTHONPATH", str(folder))
        return [Path(os.path.relpath(place / hook, self.prefix)).as_posix() for hook in hooks]


def _based(folder: str | None, prefix: Path) -> str:
    return str(prefix / "bin") if folder is None else folder.replace("$base", str(prefix))


def _relative(source: str, folder: Path) -> str:
    return os.path.relpath(source, folder) if os.path.isabs(source) else source


def _is_same(path: Path, other: Path) -> bool:
    return path.exists() and path.samefile(other)


def _failed(work: Work, error: Exception) -> JobFailure:
    """Report an error as colcon does an exception in a task: a traceback in the package's block, the text again at the end."""
    if not work.stopped:
        work.stderr("Traceback (most recent call last):\n" + "".join(traceback.format_exception_only(error)))
    return JobFailure(str(error))
