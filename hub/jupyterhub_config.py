"""JupyterHub for a class on one machine. See README.md.

Everybody logs in with a name and the word of the class, and all servers run as the user who starts the hub, so that pupils are
not kept apart:
    DAY6_HUB_WORD          the word (needed, at least eight characters of ASCII)
    DAY6_HUB_TEACHER_WORD  with it (at least 32 characters) the name `teacher` logs in and reaches the page /hub/admin
    DAY6_HUB_AS_ROOT=1     start as root all the same: every pupil is root then
Or everybody logs in with a Unix account of this machine and its password, and is kept apart by it, which needs root:
    DAY6_HUB_ACCOUNTS=1    instead of a word
    DAY6_HUB_GROUP         the group whose members may (default: day6)
    DAY6_HUB_TEACHERS      the group whose members reach the page /hub/admin, too (default: day6-teachers)
For both:
    DAY6_HUB_DATA          folder for the homes and what the hub remembers (default: the current one)
    DAY6_HUB_URL           where the hub listens (default: http://127.0.0.1:8000)
"""

import grp
import hashlib
import os
import pwd
import secrets
import shutil
import sys
import tempfile
from pathlib import Path

c = get_config()  # noqa: F821 - JupyterHub's

FIRST_STEPS = Path(__file__).resolve().with_name("first_steps.ipynb")
NAMES = r"[a-z][a-z0-9_-]{0,31}\Z"
NO_NAME = (
    "A name here begins with a letter from a to z; letters, digits, - and _ may follow, 32 characters at most: wang_xiaoming. "
    "这里的名字以字母 a 到 z 开头，后面可以有字母、数字、- 和 _，最多 32 个字符，例如 wang_xiaoming。"
)
OFTEN = "Too many wrong words: wait a minute. 错的口令太多了，请等一分钟。"
FIRST_PERSON, NOBODY = 1000, 65534
"""Unix accounts below the first one are the system's (UID_MIN of login.defs)."""


def refuse(text):
    """End with one line."""
    sys.exit(f"jupyterhub_config.py: {text}")


def told_by_name(base):
    """JupyterHub calls a name that it doesn't take a wrong password; here it is said what a name looks like."""
    from tornado.web import HTTPError

    class ToldByName(base):
        def validate_username(self, username):
            if super().validate_username(username):
                return True
            raise HTTPError(403, NO_NAME)

    return ToldByName


# -- whoever knows the word --------------------------------------------------------------------------------------------


def let_in_by_word(word, teacher_word):
    """Whoever knows the word is whoever he says he is, but not the teacher."""
    if len(word) < 8 or not word.isascii():
        refuse(
            "set DAY6_HUB_WORD to the word of the class, at least eight characters of ASCII (or DAY6_HUB_ACCOUNTS=1)"
        )
    if teacher_word and (len(teacher_word) < 32 or not teacher_word.isascii()):
        refuse("DAY6_HUB_TEACHER_WORD needs at least 32 characters of ASCII")
    if os.getuid() == 0 and os.environ.get("DAY6_HUB_AS_ROOT") != "1":
        refuse("as root every pupil would be root: start it as another user, or set DAY6_HUB_ACCOUNTS=1")
    try:
        from jupyterhub.authenticators.shared import SharedPasswordAuthenticator
    except ImportError:  # before 5.3
        if teacher_word:
            refuse("DAY6_HUB_TEACHER_WORD needs JupyterHub 5.3 or newer")
        from jupyterhub.auth import DummyAuthenticator

        c.JupyterHub.authenticator_class = told_by_name(DummyAuthenticator)
        c.DummyAuthenticator.password = word
    else:
        c.JupyterHub.authenticator_class = told_by_name(by_word(SharedPasswordAuthenticator))
        c.SharedPasswordAuthenticator.user_password = word
        if teacher_word:
            c.SharedPasswordAuthenticator.admin_password = teacher_word
            c.Authenticator.admin_users = {"teacher"}
        else:
            c.Authenticator.blocked_users = {"teacher"}
    c.Authenticator.allow_all = True


def by_word(base):
    """JupyterHub's own way compares words of ASCII only; any other word that somebody types is a wrong one.

    And it lets everybody try as often as they like; here wrong words count as they do for `day6-tui serve`.
    """
    from tornado.web import HTTPError

    from day6_tui.web.tries import Tries

    tries = Tries()

    class ByWord(base):
        async def authenticate(self, handler, data):
            found = await super().authenticate(handler, data) if data["password"].isascii() else None
            if tries.refusal(handler.request.remote_ip, is_right=found is not None) == "often":
                raise HTTPError(429, OFTEN)
            return found

    return ByWord


def homes(data):
    """Folders below ours in place of accounts; each has a meeting place of its own: programs that share one share a graph."""
    sockets = Path(tempfile.gettempdir(), f"day6-hub-{os.getuid()}-{hashlib.sha256(bytes(data)).hexdigest()[:8]}")
    sockets.mkdir(mode=0o700, exist_ok=True)
    if sockets.stat().st_uid != os.getuid() or sockets.stat().st_mode & 0o077:
        refuse(f"{sockets} belongs to somebody else")

    def runtime(spawner):
        return str(sockets / hashlib.sha256(spawner.user.name.encode()).hexdigest()[:12])

    def furnish(spawner):
        home = data / "homes" / spawner.user.name
        if not home.exists():
            home.mkdir(parents=True)
            shutil.copy(FIRST_STEPS, home)

    c.JupyterHub.spawner_class = "simple"
    c.SimpleLocalProcessSpawner.home_dir_template = str(data / "homes" / "{username}")
    c.Spawner.pre_spawn_hook = furnish
    c.Spawner.environment = {"DAY6_RUNTIME_DIR": runtime}
    c.Spawner.args = ["--allow-root"] if os.getuid() == 0 else []


# -- accounts ----------------------------------------------------------------------------------------------------------


def let_in_by_account(group, teachers):
    """Members of the group log in with the password of their account; root and the accounts of the system never do."""
    from jupyterhub.auth import PAMAuthenticator

    if os.getuid() != 0:
        refuse("DAY6_HUB_ACCOUNTS needs root, which starts the servers as their users")
    groups = {each.gr_name for each in grp.getgrall()}
    if group not in groups:
        refuse(f"there is no group {group}: groupadd {group}, and usermod -aG {group} NAME for each pupil")
    for python in (Path(sys.executable), Path(sys.executable).resolve()):
        closed = [folder for folder in python.parents if not folder.stat().st_mode & 0o001]
        if closed:
            refuse(f"pupils cannot run {python}: {closed[0]} is closed to them. Take the system's Python, below /opt")

    class ByAccount(PAMAuthenticator):
        def check_blocked_users(self, username, authentication=None):
            return is_person(username) and super().check_blocked_users(username, authentication)

    c.JupyterHub.authenticator_class = told_by_name(ByAccount)
    c.LocalAuthenticator.allowed_groups = {group, teachers} & groups
    c.PAMAuthenticator.admin_groups = {teachers} & groups
    c.Authenticator.blocked_users = {"root"}
    c.JupyterHub.spawner_class = "localprocess"
    c.Spawner.environment = {}  # an account has a runtime folder of its own
    c.Spawner.args = []


def is_person(name):
    """Whether an account of this machine belongs to a person and not to the system."""
    try:
        return FIRST_PERSON <= pwd.getpwnam(name).pw_uid != NOBODY
    except KeyError:
        return False


# -- for both ----------------------------------------------------------------------------------------------------------

os.umask(0o077)  # what the hub and the pupils write is nobody else's
data = Path(os.environ.get("DAY6_HUB_DATA", ".")).resolve()
data.mkdir(parents=True, exist_ok=True)
if os.environ.get("DAY6_HUB_ACCOUNTS") == "1":
    let_in_by_account(os.environ.get("DAY6_HUB_GROUP", "day6"), os.environ.get("DAY6_HUB_TEACHERS", "day6-teachers"))
else:
    let_in_by_word(os.environ.get("DAY6_HUB_WORD", ""), os.environ.get("DAY6_HUB_TEACHER_WORD", ""))
    homes(data)

c.JupyterHub.bind_url = os.environ.get("DAY6_HUB_URL", "http://127.0.0.1:8000")
c.JupyterHub.db_url = f"sqlite:///{data / 'jupyterhub.sqlite'}"
c.JupyterHub.cookie_secret_file = str(data / "cookie_secret")
c.ConfigurableHTTPProxy.pid_file = str(data / "proxy.pid")
c.ConfigurableHTTPProxy.auth_token = secrets.token_hex(32)
c.Authenticator.username_pattern = NAMES

programs = Path(sys.executable).parent
c.Spawner.cmd = [str(programs / "jupyterhub-singleuser")]
c.Spawner.default_url = "/lab"
c.Spawner.start_timeout = 120
c.Spawner.http_timeout = 120
# JupyterLab's terminals are bash with ros2, python3 and the others of day6-tui.
c.Spawner.environment.update({"PATH": os.pathsep.join([str(programs), os.environ.get("PATH", os.defpath)])})
shell = ["bash", "-c", 'eval "$(day6-tui env)"; exec bash -i']
c.Spawner.args.append(f"--ServerApp.terminado_settings={ {'shell_command': shell} }")

# A server that nobody has used for two hours ends; the files stay.
c.JupyterHub.load_roles = [
    {
        "name": "idle",
        "scopes": ["list:users", "read:users:activity", "read:servers", "delete:servers"],
        "services": ["idle"],
    }
]
c.JupyterHub.services = [
    {"name": "idle", "command": [sys.executable, "-m", "jupyterhub_idle_culler", "--timeout=7200"]}
]
