"""What undoes every terminal mode that Textual turns on."""

from __future__ import annotations

GIVE_BACK = "".join(
    (
        "\x1b[?2026l",  # what is drawn is shown at once
        "\x1b[?1000l\x1b[?1003l\x1b[?1015l\x1b[?1006l\x1b[?1016l",  # the mouse
        "\x1b[?2004l\x1b[?2048l\x1b[?1004l",  # marks around what is pasted, reports of the size and of the focus
        "\x1b[?7h\x1b[<u",  # long lines wrap; the keyboard sends what it always did
        "\x1b[?1049l\x1b[?25h\x1b[0m",  # the shell's screen, the cursor, plain text
    )
)
