"""How much memory and how many cores this process may use: the limits of control groups, wherever they are."""

from __future__ import annotations

from pathlib import Path

import pytest

from day6_core.system import memory
from day6_core.system.control_groups import Tree, core_limits, memory_limits, trees

MB, GB = 1 << 20, 1 << 30
MEMINFO = "MemTotal:  8000000 kB\nMemFree: 1 kB\nMemAvailable:  6000000 kB\n"


def group(folder: Path, **files: str) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in files.items():
        (folder / name.replace("__", ".")).write_text(text)
    return folder


@pytest.mark.parametrize(
    ("is_v2", "files", "expected"),
    [
        (True, {"memory__max": "max", "memory__current": "5"}, (8000000 << 10, 6000000 << 10)),
        (True, {"memory__max": str(GB), "memory__current": str(700 * MB)}, (GB, 324 * MB)),
        (
            True,
            {"memory__max": str(GB), "memory__current": str(700 * MB), "memory__stat": f"inactive_file {300 * MB}\n"},
            (GB, 624 * MB),
        ),
        (True, {"memory__max": str(GB), "memory__current": str(2 * GB)}, (GB, 0)),
        (False, {"memory__limit_in_bytes": str(GB), "memory__usage_in_bytes": str(GB // 2)}, (GB, GB // 2)),
        (
            False,
            {"memory__limit_in_bytes": str((1 << 63) - 4096), "memory__usage_in_bytes": "1"},
            (8000000 << 10, 6000000 << 10),
        ),
    ],
)
def test_a_limit_of_any_group_above_counts(
    tmp_path: Path, is_v2: bool, files: dict[str, str], expected: tuple[int, int]
) -> None:
    above = group(tmp_path / "above", **files)
    tree = Tree(group(above / "server"), is_v2, frozenset({"memory"}))
    assert memory.available([tree], MEMINFO) == expected
    assert memory.available([], "nonsense") is None


@pytest.mark.parametrize(
    ("is_v2", "files", "most"),
    [
        (True, {"cpu__max": "50000 100000\n"}, 0.5),
        (True, {"cpu__max": "max 100000\n"}, None),
        (False, {"cpu__cfs_quota_us": "25000", "cpu__cfs_period_us": "100000"}, 0.25),
        (False, {"cpu__cfs_quota_us": "-1", "cpu__cfs_period_us": "100000"}, None),
    ],
)
def test_cores_that_a_group_may_not_fill_do_not_count(
    tmp_path: Path, is_v2: bool, files: dict[str, str], most: float | None
) -> None:
    tree = Tree(group(tmp_path, **files), is_v2, frozenset({"cpu"}))
    assert memory.cores([tree]) == (memory.cores([]) if most is None else most)


def proc(folder: Path, mounts: str, memberships: str) -> Path:
    """A folder with what /proc/self says; {} in `mounts` is the folder."""
    folder.mkdir()
    (folder / "mountinfo").write_text(mounts.replace("{}", str(folder.parent).replace(" ", r"\040")))
    (folder / "cgroup").write_text(memberships)
    return folder


def test_control_groups_are_found_in_both_versions(tmp_path: Path) -> None:
    here = proc(
        tmp_path / "self",
        "30 23 0:28 / /sys/fs/cgroup rw - tmpfs tmpfs rw,mode=755\n"
        "31 23 0:29 / {}/unified rw,nosuid shared:9 - cgroup2 cgroup2 rw,nsdelegate\n"
        "32 31 0:30 / {}/cpu,cpuacct rw - cgroup cgroup rw,cpu,cpuacct\n"
        "33 31 0:31 / {}/pids rw - cgroup cgroup rw,pids\n",
        "5:pids:/a\n3:cpu,cpuacct:/\n1:name=systemd:/b\n0::/system.slice/day6.service\n",
    )
    assert [(str(tree.own), tree.is_v2, sorted(tree.controllers)) for tree in trees(here)] == [
        (f"{tmp_path}/unified/system.slice/day6.service", True, []),
        (f"{tmp_path}/cpu,cpuacct", False, ["cpu"]),
        (f"{tmp_path}/pids/a", False, ["pids"]),
    ]


def test_the_smallest_limit_of_nested_slices_counts_also_where_it_is_not_handed_down(tmp_path: Path) -> None:
    above = group(
        tmp_path / "mount" / "user.slice", memory__max=str(4 * GB), memory__current=str(GB), cpu__max="max 100000"
    )
    between = group(
        above / "user-1000.slice", memory__max=str(2 * GB), memory__current=str(GB), cpu__max="150000 100000"
    )
    group(between / "session.scope")  # no controller is handed down to it: it has no files of its own
    here = proc(
        tmp_path / "self",
        "31 23 0:29 / {}/mount rw - cgroup2 cgroup2 rw\n",
        "0::/user.slice/user-1000.slice/session.scope\n",
    )
    assert memory.available(trees(here), MEMINFO) == (2 * GB, GB)
    assert memory.cores(trees(here)) == min(1.5, memory.processors())


def test_version_1_has_a_tree_for_each_controller(tmp_path: Path) -> None:
    group(tmp_path / "memory" / "pod" / "one", memory__limit_in_bytes=str((1 << 63) - 4096), memory__usage_in_bytes="5")
    group(tmp_path / "memory" / "pod", memory__limit_in_bytes=str(GB), memory__usage_in_bytes=str(GB // 4))
    group(tmp_path / "cpu" / "pod", cpu__cfs_quota_us="25000", cpu__cfs_period_us="100000")
    here = proc(
        tmp_path / "self",
        "32 31 0:30 / {}/cpu rw - cgroup cgroup rw,cpu\n33 31 0:31 / {}/memory rw - cgroup cgroup rw,memory\n",
        "4:memory:/pod/one\n1:cpu:/pod\n",
    )
    assert memory.available(trees(here), MEMINFO) == (GB, GB * 3 // 4)
    assert memory.cores(trees(here)) == 0.25


@pytest.mark.parametrize(
    ("root", "membership"),
    [
        ("/", "/"),  # a container with a namespace of its own: it sees itself as the root
        ("/docker/abc", "/docker/abc"),  # one without: the path is that of the machine, which isn't mounted here
        ("/docker/abc", "/"),  # entered from outside
        ("/", "/../../system.slice"),  # moved out of its namespace
        ("/", "/docker/abc"),  # only the mount is the container's
    ],
)
def test_in_a_container_its_own_group_is_what_is_mounted(tmp_path: Path, root: str, membership: str) -> None:
    group(tmp_path / "with space", memory__max=str(GB), memory__current=str(GB // 2))
    here = proc(
        tmp_path / "self", f"31 23 0:29 {root} {{}}/with\\040space rw - cgroup2 cgroup2 rw\n", f"0::{membership}\n"
    )
    (tree,) = trees(here)
    assert (tree.own, tree.chain) == (tmp_path / "with space", (tmp_path / "with space",))
    assert memory.available([tree], MEMINFO) == (GB, GB // 2)


def test_a_group_below_the_one_that_is_mounted_is_found(tmp_path: Path) -> None:
    group(tmp_path / "mount" / "inner", memory__max=str(GB), memory__current="0")
    group(tmp_path, memory__max="1")  # outside of the mount: no control group
    here = proc(tmp_path / "self", "31 23 0:29 /pod {}/mount rw - cgroup2 cgroup2 rw\n", "0::/pod/inner\n")
    assert [each.most for each in memory_limits(trees(here))] == [GB]


def test_what_is_no_control_group_limits_nothing(tmp_path: Path) -> None:
    assert trees(tmp_path / "nothing") == []
    here = proc(tmp_path / "self", "31 23 0:29 / {}/mount rw - cgroup2 cgroup2 rw\n", "0::/gone\n")
    assert memory_limits(trees(here)) == core_limits(trees(here)) == []


def test_memory_is_known_also_where_nobody_says_what_is_free(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(memory, "available", lambda: None)
    monkeypatch.setattr(memory, "read", lambda path: "")
    total = memory.total_memory.__wrapped__()
    assert total is None or total > 100 * MB
