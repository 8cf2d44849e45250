"""The wheelhouse."""

TEXTS = {
    "wheelhouse.no_platform": "no wheels are known for machines like this one; choose some with --platform",
    "wheelhouse.no_pip": "pip is needed to fetch the files, and it isn't installed ({command})",
    "wheelhouse.foreign": "{file} is not from an earlier run, or has been changed since: choose another folder",
    "wheelhouse.failed": "nothing was written: {reason}",
    "wheelhouse.no_internet": "no internet: the files could not be fetched ({reason}), and nothing was written",
    "wheelhouse.done": "{count} wheels, {size} MB in {folder}",
    "wheelhouse.next": "{file} says how to install them",
    "wheelhouse.guide.unix": "Linux, Raspberry Pi OS, macOS:",
    "wheelhouse.guide.windows": "Windows (PowerShell):",
    "wheelhouse.guide.other": "\nFor another of the Python versions above, replace {python} with its number.\n",
    "wheelhouse.guide": """\
Installing day6-tui without internet
====================================

This folder is for

{targets}

and for no other machine or version of Python. linux-aarch64 includes 64-bit Raspberry Pi OS. Debian, Ubuntu and
Raspberry Pi OS also need the package python3-venv. Copy this folder to the machine, open a terminal in it, and type:

1. Check that this is the right folder and that no file is damaged.
{check}

2. Install.
{install}
{other}
3. Run.
{run}
""",
}
