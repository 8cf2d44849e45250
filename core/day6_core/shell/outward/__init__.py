"""The real terminal and editors of the user: `day6-tui shell`, `env` and `exec`."""
