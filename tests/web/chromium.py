"""A real Chromium without a window, driven over its DevTools protocol (https://chromedevtools.github.io/devtools-protocol/).

Own profile, own process group, nothing of the network but this machine; every wait has an end.
"""

from __future__ import annotations

import asyncio
import base64
import contextlib
import itertools
import json
import os
import shutil
import signal
import subprocess
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import aiohttp

from tests.support.waiting import until
from tests.web.background import Background

PROGRAMS = ("chromium", "chromium-browser", "google-chrome")
SWITCHES = (
    "--headless=new",
    "--no-sandbox",  # tests may run as root
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-default-apps",
    "--disable-dev-shm-usage",
    "--disable-extensions",
    "--disable-features=SpareRendererForSitePerProcess,BackForwardCache",
    "--disable-sync",
    "--mute-audio",
    "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1, EXCLUDE localhost",
    "--remote-debugging-port=0",
    "--renderer-process-limit=1",
    "--lang=en-US",
)

CODES = {
    "Enter": 13,
    "Tab": 9,
    "Escape": 27,
    "Backspace": 8,
    "ArrowLeft": 37,
    "ArrowUp": 38,
    "ArrowRight": 39,
    "ArrowDown": 40,
}
CODES |= {f"F{number}": 111 + number for number in range(1, 13)}
CODES |= {"\\": 220, "-": 189, "=": 187, "/": 191, ".": 190, ",": 188}
TEXTS = {"Enter": "\r"}
MODIFIERS = {"alt": 1, "ctrl": 2, "meta": 4, "shift": 8}


def program() -> str | None:
    """The path of a Chromium; None where there is none."""
    return next((found for name in PROGRAMS if (found := shutil.which(name))), None)


class Chromium:
    """One browser; `page` opens a tab of it. Close it."""

    def __init__(self, executable: str, background: Background, switches: Sequence[str] = ()) -> None:
        self.background = background
        self._profile = Path(tempfile.mkdtemp(prefix="day6-chromium-"))
        self._process = subprocess.Popen(
            [executable, *SWITCHES, *switches, f"--user-data-dir={self._profile}", "about:blank"],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
            env={**os.environ, "HOME": str(self._profile)},
        )
        self._numbers = itertools.count(1)
        self._answers: dict[int, asyncio.Future[dict[str, Any]]] = {}
        self._pages: dict[str, Page] = {}
        try:
            background.run(self._connect(self._address()))
        except BaseException:
            self._kill()
            raise

    def _address(self) -> str:
        """Where the browser listens, which it writes into its profile."""

        def noted() -> str:
            assert self._process.poll() is None, f"Chromium ended at once with {self._process.returncode}"
            with contextlib.suppress(OSError, ValueError):
                port, path = (self._profile / "DevToolsActivePort").read_text().split("\n")[:2]
                return f"ws://127.0.0.1:{int(port)}{path}"
            return ""

        return until(noted)

    async def _connect(self, address: str) -> None:
        self._session = aiohttp.ClientSession()
        self._socket = await self._session.ws_connect(address, max_msg_size=0)
        self._reader = asyncio.ensure_future(self._read())

    async def _read(self) -> None:
        async for frame in self._socket:
            message = json.loads(frame.data)
            if (answer := self._answers.pop(message.get("id", 0), None)) is not None:
                if not answer.done():
                    answer.set_result(message)
            elif (page := self._pages.get(message.get("sessionId", ""))) is not None:
                page.hear(message["method"], message["params"])

    async def ask(self, method: str, parameters: Mapping[str, Any], session: str = "") -> dict[str, Any]:
        """A command's result. Raises RuntimeError with what the browser says."""
        number = next(self._numbers)
        self._answers[number] = asyncio.get_running_loop().create_future()
        message: dict[str, Any] = {"id": number, "method": method, "params": dict(parameters)}
        await self._socket.send_json(message | ({"sessionId": session} if session else {}))
        answer = await self._answers[number]
        if "error" in answer:
            raise RuntimeError(f"{method}: {answer['error']['message']}")
        result: dict[str, Any] = answer["result"]
        return result

    def page(self) -> Page:
        """A new tab with cookies and storage of its own."""
        return self.background.run(self._page())

    async def _page(self, context: str = "") -> Page:
        context = context or (await self.ask("Target.createBrowserContext", {}))["browserContextId"]
        target = await self.ask("Target.createTarget", {"url": "about:blank", "browserContextId": context})
        attached = await self.ask("Target.attachToTarget", {"targetId": target["targetId"], "flatten": True})
        page = Page(self, attached["sessionId"], context)
        self._pages[attached["sessionId"]] = page
        for domain in ("Page", "Runtime", "Network", "Log"):
            await self.ask(f"{domain}.enable", {}, attached["sessionId"])
        await self.ask("Emulation.setFocusEmulationEnabled", {"enabled": True}, attached["sessionId"])
        return page

    def close(self) -> None:
        """End the browser and everything it started."""
        with contextlib.suppress(Exception):  # it is killed anyway
            self.background.run(self._leave(), 5)
        self._kill()

    async def _leave(self) -> None:
        self._reader.cancel()
        await self._socket.close()
        await self._session.close()

    def _kill(self) -> None:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(self._process.pid, signal.SIGKILL)
        self._process.wait(10)
        shutil.rmtree(self._profile, ignore_errors=True)


class Page:
    """One tab."""

    def __init__(self, browser: Chromium, session: str, context: str) -> None:
        self._browser = browser
        self._session = session
        self._context = context
        self.requests: list[str] = []
        """Every address the tab asked for."""
        self.troubles: list[str] = []
        """Exceptions of scripts, and errors that the browser logged."""

    def beside(self) -> Page:
        """A new tab of the same browser: with the same cookies and storage."""
        return self._browser.background.run(self._browser._page(self._context))

    def hear(self, method: str, parameters: Mapping[str, Any]) -> None:
        """Take an event of the browser."""
        if method == "Network.requestWillBeSent":
            self.requests.append(parameters["request"]["url"])
        elif method == "Network.webSocketCreated":
            self.requests.append(parameters["url"])
        elif method == "Runtime.exceptionThrown":
            details = parameters["exceptionDetails"]
            self.troubles.append(details.get("exception", {}).get("description") or details["text"])
        elif method == "Log.entryAdded" and parameters["entry"]["level"] == "error":
            self.troubles.append(f"{parameters['entry']['text']} {parameters['entry'].get('url', '')}")

    def ask(self, method: str, **parameters: Any) -> dict[str, Any]:
        """A command for this tab."""
        return self._browser.background.run(self._browser.ask(method, parameters, self._session))

    def navigate(self, address: str) -> None:
        """Load a page, and wait until its scripts have run."""
        self.ask("Page.navigate", url=address)
        self.wait_for("document.readyState === 'complete'")

    def reload(self) -> None:
        """Load the page anew; the browser answers while the old one is still there, so that is waited for, too."""
        self.evaluate("window.isTheOldPage = true")
        self.ask("Page.reload")
        self.wait_for("!window.isTheOldPage && document.readyState === 'complete'")

    def evaluate(self, expression: str) -> Any:
        """The value of an expression, waited for if it is a promise. Raises RuntimeError with the script's own error."""
        answer = self.ask("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(answer["exceptionDetails"].get("exception", {}).get("description", "failed"))
        return answer["result"].get("value")

    def wait_for(self, expression: str) -> Any:
        """The expression's value as soon as it is true."""

        def value() -> Any:
            with contextlib.suppress(RuntimeError):  # the page is just being loaded
                return self.evaluate(expression)

        return until(value, every=0.02, told=lambda: f"{expression} ({self.troubles})")

    def press(self, key: str, *held: str, command: str = "") -> None:
        """Press and release a key, named as in KeyboardEvent.key, with `held` of alt, ctrl, meta, shift.

        `command` is what the browser would do with it, such as "paste": without a window it knows no shortcuts.
        """
        modifiers = sum(MODIFIERS[name] for name in held)
        code = CODES.get(key) or ord(key.upper())
        single = len(key) == 1
        text = TEXTS.get(key, key if single else "") if not modifiers & 3 else ""
        event = {"key": key, "modifiers": modifiers, "windowsVirtualKeyCode": code, "code": _physical(key)}
        self.ask(
            "Input.dispatchKeyEvent",
            type="keyDown" if text else "rawKeyDown",
            text=text,
            commands=[command] if command else [],
            **event,
        )
        self.ask("Input.dispatchKeyEvent", type="keyUp", **event)

    def compose(self, *steps: str, result: str) -> None:
        """Type with an input method: what it shows step by step, and what it enters at last."""
        for step in steps:
            self.ask("Input.imeSetComposition", text=step, selectionStart=len(step), selectionEnd=len(step))
        self.ask("Input.insertText", text=result)

    def mouse(self, kind: str, x: float, y: float, button: str = "left", *held: str, **more: Any) -> None:
        """`kind` is mousePressed, mouseReleased, mouseMoved or mouseWheel."""
        modifiers = sum(MODIFIERS[name] for name in held)
        extra = {"clickCount": 1} if kind in ("mousePressed", "mouseReleased") else {}
        buttons = {"buttons": 1} if kind == "mouseMoved" and button == "left" else {}
        event = {"x": x, "y": y, "button": button, "modifiers": modifiers, **extra, **buttons, **more}
        self.ask("Input.dispatchMouseEvent", type=kind, **event)

    def click(self, x: float, y: float, button: str = "left", *held: str) -> None:
        for kind in ("mousePressed", "mouseReleased"):
            self.mouse(kind, x, y, button, *held)

    def click_on(self, selector: str) -> None:
        """Click into the middle of an element."""
        place = self.wait_for(
            f"(e => {{ if (!e) return null; const r = e.getBoundingClientRect();"
            f" return r.width ? [r.x + r.width / 2, r.y + r.height / 2] : null; }})(document.querySelector({selector!r}))"
        )
        self.click(*place)

    def swipe(self, start: tuple[float, float], end: tuple[float, float], steps: int = 8) -> None:
        """Drag one finger."""
        self.ask("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": start[0], "y": start[1]}])
        for step in range(1, steps + 1):
            x, y = (a + (b - a) * step / steps for a, b in zip(start, end, strict=True))
            self.ask("Input.dispatchTouchEvent", type="touchMove", touchPoints=[{"x": x, "y": y}])
        self.ask("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])

    def device(self, width: int, height: int, *, mobile: bool = False, scale: float = 1) -> None:
        """Make the tab as large as a device; `mobile` ones have fingers in place of a mouse."""
        self.ask(
            "Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=scale, mobile=mobile
        )
        self.ask("Emulation.setTouchEmulationEnabled", enabled=mobile, maxTouchPoints=5 if mobile else 1)

    def allow_clipboard(self) -> None:
        """Let the page read and fill the clipboard, as a person may."""
        names = ["clipboardReadWrite", "clipboardSanitizedWrite"]
        self._browser.background.run(
            self._browser.ask("Browser.grantPermissions", {"permissions": names, "browserContextId": self._context})
        )

    def offline(self, offline: bool) -> None:
        """Cut the tab off, or connect it again; a WebSocket that is open stays."""
        nothing = {"latency": 0, "downloadThroughput": -1, "uploadThroughput": -1}
        self.ask("Network.emulateNetworkConditions", offline=offline, **nothing)

    def screenshot(self, path: Path | str) -> None:
        Path(path).write_bytes(base64.b64decode(self.ask("Page.captureScreenshot", format="png")["data"]))

    def close(self) -> None:
        """Close the tab; its cookies and storage go with it."""
        with contextlib.suppress(RuntimeError):
            self._browser.background.run(
                self._browser.ask("Target.disposeBrowserContext", {"browserContextId": self._context})
            )


def _physical(key: str) -> str:
    """KeyboardEvent.code on a US keyboard, as far as letters and named keys go."""
    if len(key) == 1 and key.isalpha():
        return f"Key{key.upper()}"
    return f"Digit{key}" if key.isdigit() else key
