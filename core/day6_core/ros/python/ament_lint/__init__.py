"""What the linters have in common: the marks of their tests, the files they look at."""
