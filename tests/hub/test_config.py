"""What hub/jupyterhub_config.py asks of JupyterHub, which is not needed here; `tests/web/try_hub.py` starts a real one."""

from __future__ import annotations

import asyncio
import os
import re
import sys
import tempfile
import types
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import pytest
import yaml

from day6_tui.web.tries import MOST_OF_ONE

grp = pytest.importorskip("grp", reason="there are no Unix groups here")
traitlets = pytest.importorskip("traitlets.config", reason="there is no ipykernel here, which brings traitlets")

HUB = Path(__file__).resolve().parents[2] / "hub"
WORD, TEACHER = "chalk-and-sponge", "a sentence that only the teacher knows"


class Authenticator:
    """In the place of JupyterHub's own: without a word a name that doesn't fit is as if the password were wrong."""

    def validate_username(self, username: str) -> bool:
        return username == "anna"


class Dummy(Authenticator):
    pass


class Shared(Authenticator):
    """In the place of JupyterHub's own, whose comparison knows ASCII only."""

    async def authenticate(self, handler: object, data: dict[str, str]) -> str | None:
        data["password"].encode("ascii")
        return data["username"] if data["password"] == WORD else None


def entered(made: Any, word: str, address: str = "192.0.2.1") -> object:
    """What JupyterHub is told of somebody who logs in."""
    handler = types.SimpleNamespace(request=types.SimpleNamespace(remote_ip=address))
    return asyncio.run(made.authenticate(handler, {"username": "anna", "password": word}))


class Pam(Authenticator):
    def check_blocked_users(self, username: str, authentication: object = None) -> bool:
        return username != "blocked"


class Spawner(NamedTuple):
    user: Any


Load = Callable[..., Any]


@pytest.fixture
def load(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Load:
    """Read the configuration as some user (0: root; otherwise who runs this) with some variables; returns what it has set."""
    real = os.getuid()
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    monkeypatch.setattr(os, "umask", lambda mask: 0)
    monkeypatch.setattr(sys, "executable", "/usr/bin/env")  # any program that all may run
    for name in [name for name in os.environ if name.startswith("DAY6_HUB")]:
        monkeypatch.delenv(name)
    for name, holds in (
        ("jupyterhub", {}),
        ("jupyterhub.auth", {"PAMAuthenticator": Pam, "DummyAuthenticator": Dummy}),
        ("jupyterhub.authenticators", {}),
        ("jupyterhub.authenticators.shared", {"SharedPasswordAuthenticator": Shared}),
    ):
        module = types.ModuleType(name)
        module.__dict__.update(holds)
        monkeypatch.setitem(sys.modules, name, module)

    def read(uid: int | None = None, **variables: str) -> Any:
        monkeypatch.setattr(os, "getuid", lambda: real if uid is None else uid)
        if uid not in (None, real):  # what is made here belongs to this user then
            stat = Path.stat
            monkeypatch.setattr(Path, "stat", lambda path: os.stat_result((*stat(path)[:4], uid, *stat(path)[5:])))
        if uid is None and real == 0:
            variables["AS_ROOT"] = "1"
        for name, value in {"DATA": str(tmp_path / "data"), **variables}.items():
            monkeypatch.setenv(f"DAY6_HUB_{name}", value)
        config = traitlets.Config()
        path = HUB / "jupyterhub_config.py"
        names = {"get_config": lambda: config, "__file__": str(path), "__name__": "config"}
        exec(compile(path.read_text(encoding="utf-8"), str(path), "exec"), names)
        return config

    return read


def test_nobody_becomes_root_by_the_word(load: Load) -> None:
    with pytest.raises(SystemExit, match="as root every pupil would be root"):
        load(0, WORD=WORD)
    config = load(0, WORD=WORD, AS_ROOT="1")
    assert "--allow-root" in config.Spawner.args


def test_the_word_lets_in_under_any_name_but_the_teachers(load: Load) -> None:
    config = load(WORD=WORD)
    assert (
        config.SharedPasswordAuthenticator.user_password == WORD
        and "admin_password" not in config.SharedPasswordAuthenticator
    )
    assert config.Authenticator.blocked_users == {"teacher"}
    config = load(WORD=WORD, TEACHER_WORD=TEACHER)
    assert config.SharedPasswordAuthenticator.admin_password == TEACHER
    assert config.Authenticator.admin_users == {"teacher"} and "blocked_users" not in config.Authenticator


def test_a_word_in_chinese_is_a_wrong_one_and_no_error_of_the_server(load: Load) -> None:
    made = load(WORD=WORD).JupyterHub.authenticator_class()

    assert entered(made, WORD) == "anna" and entered(made, "wrong") is None
    assert entered(made, "粉笔和海绵粉笔和海绵") is None


def test_words_cannot_be_guessed_by_the_thousand_from_one_address(load: Load) -> None:
    web = pytest.importorskip("tornado.web", reason="there is no ipykernel here, which brings tornado")
    made = load(WORD=WORD).JupyterHub.authenticator_class()
    assert [entered(made, f"wrong {number}") for number in range(MOST_OF_ONE)] == [None] * MOST_OF_ONE
    for word in ("wrong", WORD):
        with pytest.raises(web.HTTPError, match="Too many wrong words"):
            entered(made, word)
    assert entered(made, WORD, "192.0.2.2") == "anna"


@pytest.mark.parametrize("way", ["word", "before 5.3", "accounts"])
def test_a_name_that_is_none_here_is_told_and_not_called_a_wrong_password(
    load: Load, monkeypatch: pytest.MonkeyPatch, way: str
) -> None:
    web = pytest.importorskip("tornado.web", reason="there is no ipykernel here, which brings tornado")
    groups(monkeypatch, "day6")
    if way == "before 5.3":
        monkeypatch.setitem(sys.modules, "jupyterhub.authenticators.shared", None)
    config = load(0, ACCOUNTS="1") if way == "accounts" else load(WORD=WORD)
    made = config.JupyterHub.authenticator_class()
    assert made.validate_username("anna") is True
    with pytest.raises(web.HTTPError, match=r"a to z.*字母 a 到 z") as error:
        made.validate_username("安娜")
    assert "%" not in str(error.value.log_message)  # tornado would fill it


@pytest.mark.parametrize(
    ("variables", "said"),
    [
        ({}, "DAY6_HUB_WORD"),
        ({"WORD": "seven77"}, "eight characters"),
        ({"WORD": "粉笔和海绵粉笔和海绵"}, "ASCII"),
        ({"WORD": WORD, "TEACHER_WORD": "short"}, "32 characters"),
    ],
)
def test_a_word_that_will_not_do_is_told_before_the_hub_starts(
    load: Load, variables: dict[str, str], said: str
) -> None:
    with pytest.raises(SystemExit, match=said):
        load(**variables)


def test_before_jupyterhub_5_3_the_word_is_the_dummys(load: Load, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "jupyterhub.authenticators.shared", None)
    config = load(WORD=WORD)
    assert issubclass(config.JupyterHub.authenticator_class, Dummy) and config.DummyAuthenticator.password == WORD
    with pytest.raises(SystemExit, match=r"JupyterHub 5\.3"):
        load(WORD=WORD, TEACHER_WORD=TEACHER)


def groups(monkeypatch: pytest.MonkeyPatch, *names: str) -> None:
    monkeypatch.setattr(grp, "getgrall", lambda: [types.SimpleNamespace(gr_name=name) for name in names])


def test_accounts_log_in_by_pam_and_only_those_of_the_group(load: Load, monkeypatch: pytest.MonkeyPatch) -> None:
    groups(monkeypatch, "day6", "day6-teachers", "others")
    config = load(0, ACCOUNTS="1", WORD=WORD)
    assert issubclass(config.JupyterHub.authenticator_class, Pam) and config.JupyterHub.spawner_class == "localprocess"
    assert config.LocalAuthenticator.allowed_groups == {"day6", "day6-teachers"}
    assert config.PAMAuthenticator.admin_groups == {"day6-teachers"}
    assert "root" in config.Authenticator.blocked_users and "allow_all" not in config.Authenticator
    assert "SharedPasswordAuthenticator" not in config and "DummyAuthenticator" not in config
    assert "--allow-root" not in config.Spawner.args and "DAY6_RUNTIME_DIR" not in config.Spawner.environment


def test_root_and_the_accounts_of_the_system_never_log_in(load: Load, monkeypatch: pytest.MonkeyPatch) -> None:
    groups(monkeypatch, "day6")
    numbers = {"root": 0, "www-data": 33, "nobody": 65534, "anna": 1001, "blocked": 1002}
    made = load(0, ACCOUNTS="1").JupyterHub.authenticator_class()

    def number(name: str) -> object:
        return types.SimpleNamespace(pw_uid=numbers[name])  # KeyError as pwd's

    monkeypatch.setattr("pwd.getpwnam", number)
    assert [name for name in (*numbers, "stranger") if made.check_blocked_users(name)] == ["anna"]


def test_accounts_need_root_a_group_and_an_environment_that_pupils_reach(
    load: Load, monkeypatch: pytest.MonkeyPatch, short_folder: Path
) -> None:
    with pytest.raises(SystemExit, match="needs root"):
        load(1000, ACCOUNTS="1")
    groups(monkeypatch, "others")
    with pytest.raises(SystemExit, match="groupadd day6"):
        load(0, ACCOUNTS="1")
    groups(monkeypatch, "day6")
    short_folder.chmod(0o700)
    (short_folder / "python").symlink_to("/usr/bin/env")
    monkeypatch.setattr(sys, "executable", str(short_folder / "python"))
    with pytest.raises(SystemExit, match=f"{re.escape(str(short_folder))} is closed to them"):
        load(0, ACCOUNTS="1")


def test_a_name_is_whole_or_refused(load: Load) -> None:
    pattern = load(WORD=WORD).Authenticator.username_pattern
    values = yaml.safe_load((HUB / "values.yaml").read_text(encoding="utf-8"))
    assert values["hub"]["config"]["Authenticator"]["username_pattern"] == pattern
    match = re.compile(pattern).match  # as JupyterHub does
    assert match("anna") and match("li_lei-2")
    assert not [name for name in ("anna!", "anna/..", "anna\n", "lisa.m", "小明", "9lives", "a" * 33) if match(name)]


def test_a_new_home_has_the_first_notebook_and_a_meeting_place_of_its_own(load: Load, tmp_path: Path) -> None:
    config = load(WORD=WORD)
    anna, ben = (Spawner(types.SimpleNamespace(name=name)) for name in ("anna", "ben"))
    config.Spawner.pre_spawn_hook(anna)
    file = tmp_path / "data" / "homes" / "anna" / "first_steps.ipynb"
    assert file.read_bytes() == (HUB / "first_steps.ipynb").read_bytes()
    file.unlink()
    config.Spawner.pre_spawn_hook(anna)
    assert not file.exists()
    place = config.Spawner.environment["DAY6_RUNTIME_DIR"]
    assert place(anna) != place(ben)


def test_every_file_that_the_image_copies_is_there() -> None:
    lines = (HUB / "Containerfile").read_text(encoding="utf-8").splitlines()
    sources = [word for line in lines if line.startswith("COPY ") for word in line.split()[1:-1]]
    assert sources and [name for name in sources if not (HUB.parent / name).exists()] == []
