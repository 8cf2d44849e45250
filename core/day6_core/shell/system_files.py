"""Files of an Ubuntu with ROS that a .bashrc sources, as far as they mean something here."""

from __future__ import annotations

_COLCON_CD = """\
colcon_cd() {
  local place
  case "$1" in
    '')
      if [ -n "$_colcon_cd_root" ]; then cd "$_colcon_cd_root"; fi
      return ;;
    --set)
      _colcon_cd_root=$PWD; echo "Set the root directory to: $PWD"
      return ;;
    --reset)
      unset _colcon_cd_root; return ;;
  esac
  place=$(colcon list --packages-select "$1" --paths-only 2>/dev/null)
  if [ -z "$place" ] && [ -n "$_colcon_cd_root" ]; then
    place=$(colcon list --base-paths "$_colcon_cd_root" --packages-select "$1" --paths-only 2>/dev/null)
    case "$place" in [!/]*) place=$_colcon_cd_root/$place ;; esac
  fi
  if [ -z "$place" ]; then
    echo "Could not find package '$1' from the current working directory${_colcon_cd_root:+ or from $_colcon_cd_root}" >&2
    return 1
  fi
  cd "$place"
}
"""

TEXTS = {
    "/usr/share/colcon_cd/function/colcon_cd.sh": _COLCON_CD,
    "/usr/share/colcon_cd/function/colcon_cd-argcomplete.bash": "",
    "/usr/share/colcon_argcomplete/hook/colcon-argcomplete.bash": "",
    "/usr/share/bash-completion/bash_completion": "",
    "/etc/bash_completion": "",
    "/etc/bash.bashrc": "",
}
"""Path -> its content here. Tab completion works without the files that set it up in bash."""
