"""The address that is told to others."""

from __future__ import annotations

import ipaddress
import shutil
import sys

import pytest

from day6_core.link.addresses import own_address
from tests.support.waiting import run

pytestmark = pytest.mark.process

TELL = "from day6_core.link.addresses import own_address; print(own_address())"


def test_it_is_an_address_or_this_machines_name() -> None:
    assert own_address()


@pytest.mark.skipif(shutil.which("unshare") is None, reason="needs unshare, of util-linux")
def test_in_a_network_without_a_way_out_it_is_still_the_address() -> None:
    link = (
        "ip link add school type veth peer name other && ip addr add 10.77.1.5/24 dev school && ip link set school up"
    )
    script = f'{link} && exec "$0" -c "{TELL}"'
    words = ["unshare", "--net", "--map-root-user", "sh", "-c", script, sys.executable]
    done = run(words)
    if done.returncode:
        pytest.skip(f"no network of one's own here: {done.stderr.strip()[-80:]}")
    assert ipaddress.ip_address(done.stdout.strip()) == ipaddress.ip_address("10.77.1.5")
