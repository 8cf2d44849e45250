"""The command, made at its import (see `ros2cli`)."""

from ros2cli.made_modules import install

install()
