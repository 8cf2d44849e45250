"""The browser of the tests of the built site."""

from tests.web.browser import background, chromium  # noqa: F401
