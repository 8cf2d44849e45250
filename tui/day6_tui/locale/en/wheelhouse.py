"""The wheelhouse."""

TEXTS = {
    "wheelhouse.no_platform": "no wheels are known for machines like this one; say for which with --platform",
    "wheelhouse.no_pip": "there is no pip here, which fetches the files ({command})",
    "wheelhouse.foreign": "{file} is not from an earlier run, or was changed since: choose another folder",
    "wheelhouse.failed": "nothing was written: {reason}",
    "wheelhouse.no_internet": "no internet: what is needed could not be fetched ({reason}), and nothing was written",
    "wheelhouse.done": "{count} wheels, {size} MB in {folder}",
    "wheelhouse.next": "how to install them is in {file}",
    "wheelhouse.guide.unix": "Linux, Raspberry Pi OS, macOS:",
    "wheelhouse.guide.windows": "Windows (PowerShell):",
    "wheelhouse.guide.other": "\nFor another version of Python that is named above write its number in place of {python}.\n",
    "wheelhouse.guide": """\
Installing day6-tui without internet
====================================

This folder is for

{targets}

and for no other machine or version of Python. linux-aarch64 is also Raspberry Pi OS with 64 bits. On Debian, Ubuntu and
Raspberry Pi OS the package python3-venv is needed, too. Copy this folder to the machine, open a terminal in it, and type:

1. Is it the right folder, and are all files whole?
{check}

2. Install.
{install}
{other}
3. Run.
{run}

For the teacher's machine, whose browsers' tabs are desktops (day6-tui serve), write "day6-tui[serve]" instead of day6-tui in 2.
""",
}
