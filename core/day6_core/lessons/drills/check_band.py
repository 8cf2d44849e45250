"""Check of drill 4: whether a clean build of ~/ros2_ws, made in a folder of its own, installs the launch file of band."""

import subprocess
import sys
import tempfile
from pathlib import Path

WORKSPACE = Path.home() / "ros2_ws"


def share(install: Path) -> list[Path]:
    """The launch files that are installed."""
    return list((install / "band" / "share" / "band").rglob("band.launch.py"))


def main() -> int:
    """Print what was seen; return 0 if the file is there."""
    if not share(WORKSPACE / "install"):
        print("ros2 launch 还找不到 band.launch.py (ros2 launch doesn't find it yet)")
        return 1
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        bases = ["--build-base", str(place / "build"), "--install-base", str(place / "install")]
        words = ["colcon", "--log-base", str(place / "log"), "build", *bases, "--packages-select", "band"]
        built = subprocess.run(words, cwd=WORKSPACE, capture_output=True, check=False)
        if built.returncode or not share(place / "install"):
            print("清空后重新编译，band.launch.py 就没有了 (after a clean build it would be gone)")
            return 1
    print("清空后重新编译，band.launch.py 还在 (it is still there after a clean build)")
    return 0


if __name__ == "__main__":
    sys.exit(main())
