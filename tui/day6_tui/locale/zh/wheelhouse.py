"""The wheelhouse."""

TEXTS = {
    "wheelhouse.no_platform": "没有适合这种电脑的 wheel；请用 --platform 说明给哪种电脑用",
    "wheelhouse.no_pip": "这里没有 pip，没法下载（{command}）",
    "wheelhouse.foreign": "{file} 不是以前做出来的，或者后来被改过：请换一个文件夹",
    "wheelhouse.failed": "什么都没有写：{reason}",
    "wheelhouse.no_internet": "没有网络：需要的文件没法下载（{reason}），什么都没有写",
    "wheelhouse.done": "{count} 个 wheel，共 {size} MB，在 {folder}",
    "wheelhouse.next": "怎么安装，写在 {file} 里",
    "wheelhouse.guide.unix": "Linux、树莓派、macOS：",
    "wheelhouse.guide.windows": "Windows（PowerShell）：",
    "wheelhouse.guide.other": "\n如果用上面列出的另一个 Python 版本，就把 {python} 换成那个版本号。\n",
    "wheelhouse.guide": """\
不联网安装 day6-tui
===================

这个文件夹只适合：

{targets}

不能用在别的电脑或别的 Python 版本上。linux-aarch64 也包括 64 位树莓派系统。Debian、Ubuntu 和树莓派系统还要有 python3-venv
这个包。把这个文件夹拷到电脑上，在里面打开终端，输入：

1. 文件夹对不对，文件都完整吗？
{check}

2. 安装。
{install}
{other}
3. 运行。
{run}
""",
}
