"""The marks of the tests that are linters."""
