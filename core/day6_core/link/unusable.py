"""What is wrong with an endpoint or a secret that a person typed, in English and Chinese."""

from __future__ import annotations

from day6_core.language import Pair, said


class Unusable(ValueError):
    """It cannot be used. The message is the reason in English; `said` has it in both languages."""

    def __init__(self, key: str, **values: object) -> None:
        self._key, self._values = key, values
        super().__init__(self.said("en"))

    def said(self, language: str) -> str:
        """Return the reason in 'zh' or 'en'."""
        values = {"where": said(TEXTS["secret"], language), **self._values}
        return said(TEXTS[self._key], language).format(**values)


TEXTS: dict[str, Pair] = {
    "endpoint": (
        "{endpoint!r} is not an endpoint like tcp/192.168.1.5:7447",
        "{endpoint!r} 不是 tcp/192.168.1.5:7447 这样的地址",
    ),
    "protocol": (
        "{endpoint!r} has an unknown protocol: use {others} or {last}",
        "{endpoint!r} 的协议不认识：请用 {others} 或 {last}",
    ),
    "port_missing": ("{endpoint!r} has no port: write {right}", "{endpoint!r} 没有端口：应该写 {right}"),
    "port": ("{endpoint!r} has no port from 1 to 65535", "{endpoint!r} 的端口不是 1 到 65535 的数"),
    "brackets": (
        "{endpoint!r} needs brackets around an IPv6 address: {right}",
        "{endpoint!r} 的 IPv6 地址要加方括号：{right}",
    ),
    "address": ("{endpoint!r} has no valid address: {host}", "{endpoint!r} 的地址不对：{host}"),
    "every": (
        "{endpoint!r} means every address of this machine, so it cannot be connected to",
        "{endpoint!r} 指这台电脑的所有地址，不能用来连接",
    ),
    "host": ("{endpoint!r} has no valid host name", "{endpoint!r} 的主机名不对"),
    "host_named": ("{endpoint!r} has no valid host name: {host}", "{endpoint!r} 的主机名不对：{host}"),
    "host_empty": ("{endpoint!r} has no valid host name: it is empty", "{endpoint!r} 没有主机名"),
    "secret": ("the secret", "口令"),
    "secret_short": (
        "{where} has {count} characters, at least {least} are needed",
        "{where}：只有 {count} 个字符，至少要 {least} 个",
    ),
    "secret_long": ("{where} has more than {most} characters", "{where}：超过 {most} 个字符"),
    "secret_word": ("{where} must be one word without a colon", "{where}：必须是一个词，不能有冒号"),
    "secret_no_file": ("{path} is not a file", "{path} 不是文件"),
    "secret_open": (
        "other users can read {path}; do: chmod 600 {path}",
        "别的用户能读 {path}；请运行 chmod 600 {path}",
    ),
    "secret_unread": ("{path}: {reason}", "{path} 打不开：{reason}"),
}
"""By key: English, Chinese."""
