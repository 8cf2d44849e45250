"""JupyterHub for a class on one machine: everybody logs in with a name and the word of the class. See README.md.

    DAY6_HUB_WORD   the word (needed)
    DAY6_HUB_DATA   folder for the homes and what the hub remembers (default: the current one)
    DAY6_HUB_URL    where the hub listens (default: http://127.0.0.1:8000)

The servers of all pupils run as the user who starts the hub, so pupils are not kept apart: whoever writes a program can read the
homes of the others. Where that matters, use Unix users (README.md) or containers (values.yaml).
"""

import hashlib
import os
import secrets
import sys
import tempfile
from pathlib import Path

c = get_config()  # noqa: F821 - JupyterHub's

word = os.environ.get("DAY6_HUB_WORD", "")
if len(word) < 6:
    sys.exit("set DAY6_HUB_WORD to the word of the class, at least six characters")
data = Path(os.environ.get("DAY6_HUB_DATA", ".")).resolve()
data.mkdir(parents=True, exist_ok=True)
sockets = Path(tempfile.gettempdir(), f"day6-hub-{os.getuid()}-{hashlib.sha256(bytes(data)).hexdigest()[:8]}")
sockets.mkdir(mode=0o700, exist_ok=True)
if sockets.stat().st_uid != os.getuid() or sockets.stat().st_mode & 0o077:
    sys.exit(f"{sockets} belongs to somebody else")


def runtime(spawner):
    """Give each pupil's programs a meeting place of their own: programs that share one share a graph."""
    return str(sockets / hashlib.sha256(spawner.user.name.encode()).hexdigest()[:12])


c.JupyterHub.bind_url = os.environ.get("DAY6_HUB_URL", "http://127.0.0.1:8000")
c.JupyterHub.db_url = f"sqlite:///{data / 'jupyterhub.sqlite'}"
c.JupyterHub.cookie_secret_file = str(data / "cookie_secret")
c.ConfigurableHTTPProxy.pid_file = str(data / "proxy.pid")
c.ConfigurableHTTPProxy.auth_token = secrets.token_hex(32)
c.JupyterHub.authenticator_class = "dummy"
c.DummyAuthenticator.password = word
c.Authenticator.allow_all = True
c.Authenticator.username_pattern = "[a-z][a-z0-9_-]{0,31}"

c.JupyterHub.spawner_class = "simple"
c.SimpleLocalProcessSpawner.home_dir_template = str(data / "homes" / "{username}")
c.Spawner.cmd = [str(Path(sys.executable).with_name("jupyterhub-singleuser"))]
c.Spawner.args = ["--allow-root"] if os.getuid() == 0 else []
c.Spawner.default_url = "/lab"
c.Spawner.environment = {"DAY6_RUNTIME_DIR": runtime}
c.Spawner.start_timeout = 120
c.Spawner.http_timeout = 120

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
