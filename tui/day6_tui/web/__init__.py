"""`day6-tui serve`: a desktop of their own in every browser tab, for a class.

The server holds no desktop. Each is kept by a keeper of `detached` in the pupil's cell (`day6_core.isolation`), and the server is
the keeper's client: so a desktop outlives reloads, closed laptops and the server. aiohttp comes with the extra `serve` and is
imported by nothing else; nothing here imports Textual.
"""
