"""Removing day6-tui."""

TEXTS = {
    "uninstall.files_alone": "--files goes with --data",
    "uninstall.ours": "Written by day6-tui; removed by day6-tui uninstall --data:",
    "uninstall.user": "Yours; kept, unless --files is given as well:",
    "uninstall.ros": "Shared with a real ROS; always kept:",
    "uninstall.kept": "Your files were kept:",
    "uninstall.nothing": "nothing",
    "uninstall.named": (
        "Folders that you named yourself are not listed: those of --home, serve --data and wheelhouse, recordings, bags,\n"
        "and the .vscode, .idea and .env of projects."
    ),
    "uninstall.runs": "nothing was removed, because day6-tui is running: {what}. End it first",
    "uninstall.inside": "this is a terminal of the desktop, where ~ is another folder: type it in a real terminal",
    "uninstall.comma": ", ",
    "uninstall.runs.program": "process {pid} on domain {domain}",
    "uninstall.runs.desktop": "a detached desktop (day6-tui attach, then ^Q)",
    "uninstall.runs.server": "the server of a class (day6-tui serve)",
    "uninstall.nobody": "there is no terminal to ask the question in: --yes removes without asking",
    "uninstall.data.these": "To be removed:",
    "uninstall.data.ask": "Remove these, {size}? [y/N]",
    "uninstall.data.none": "There is nothing of day6-tui to remove.",
    "uninstall.data.done": "Removed: {size}.",
    "uninstall.files.these": "Your files, which nobody can bring back:",
    "uninstall.files.ask": "Remove YOUR files too, {size}? [y/N]",
    "uninstall.files.none": "There are no files of yours.",
    "uninstall.files.done": "Removed: {size} of your files.",
    "uninstall.left": "Nothing was removed.",
    "uninstall.foreign": "left alone, not from day6-tui: {path}",
    "uninstall.package": "To remove the package itself:",
    "uninstall.checkout": "It runs from a folder of yours, which stays: {folder}",
}
