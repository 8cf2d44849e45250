"""A stranger that speaks plain Zenoh: declares what it is told to, and floods. Reads one JSON command a line, answers each."""

from __future__ import annotations

import json
import sys
from typing import Any

import zenoh

SESSION = "f" * 16


def opened(port: int) -> Any:
    config = zenoh.Config()
    settings = {
        "mode": '"client"',
        "scouting/multicast/enabled": "false",
        "connect/endpoints": json.dumps([f"tcp/127.0.0.1:{port}"]),
        "timestamping/enabled": "true",
    }
    for name, value in settings.items():
        config.insert_json5(name, value)
    return zenoh.open(config)


class HostilePeer:
    def __init__(self, session: Any) -> None:
        self.session = session
        self.held: list[Any] = []

    def tokens(self, pattern: str, count: int) -> int:
        """Declare `count` tokens; `{}` in the pattern becomes their number."""
        liveliness = self.session.liveliness()
        self.held += [liveliness.declare_token(pattern.replace("{}", str(number))) for number in range(count)]
        return len(self.held)

    def messages(self, key: str, payload: str, attachment: str, count: int, vary: bool = False) -> int:
        """Send bytes (given in hexadecimal); `vary` gives each another sender."""
        body, beside = bytes.fromhex(payload), bytes.fromhex(attachment)
        for number in range(count):
            mark = beside[:-8] + number.to_bytes(8, "big") if vary else beside
            self.session.put(key, body, attachment=mark or None)
        return count

    def queries(self, key: str, payload: str, attachment: str, count: int) -> int:
        for _ in range(count):
            self.session.get(
                key, lambda reply: None, payload=bytes.fromhex(payload), attachment=bytes.fromhex(attachment) or None
            )
        return count


def main() -> None:
    peer = HostilePeer(opened(int(sys.argv[1])))
    print("ready", flush=True)
    for line in sys.stdin:
        name, positional, named = json.loads(line)
        print(json.dumps(getattr(peer, name)(*positional, **named)), flush=True)


if __name__ == "__main__":
    main()
