"""A desktop that outlives its terminal: `day6-tui --detach`, `day6-tui attach`.

The keeper holds the pseudo-terminal of the desktop; the client carries bytes between it and the real terminal. Neither of
them imports Textual; `day6_tui/features/detachment.py` is the desktop's own part.
"""
