"""Writes scripts at random, by a grammar over bash's language and the tools that courses use; a seed gives one script."""

# ruff: noqa: E501 -- a statement of the grammar is a line, however long

from __future__ import annotations

import random
from collections.abc import Callable

NAMES = ("a", "b", "c", "x", "y", "name", "n", "path")
ARRAYS = ("arr", "list", "items")
MAPS = ("map", "conf")
TEXTS = ("foo", "bar baz", "a.b.c", "/opt/ros/jazzy/setup.bash", "x=1", "  two  spaces ", "a:b:c", "Hello World", "*", "[x]", "",
         "10", "07", "-n", "it's", 'say "hi"', "back\\slash", "tab\\there", "ros2_ws/src", "file.tar.gz", "~", "$", "é", "a,b")  # fmt: skip
PATTERNS = (
    "*",
    "?",
    "*.*",
    "a*",
    "[a-c]*",
    "[!a]*",
    "*/",
    "*o",
    "foo",
    "[[:upper:]]*",
    "[[:digit:]]",
    "b?r*",
    "*:*",
    "\\*",
)
OPERATORS = ("+", "-", "*", "/", "%", "<<", ">>", "&", "|", "^", "<", ">", "<=", ">=", "==", "!=", "&&", "||")
WORDS_OF_FILES = ("one.txt", "two.txt", "three.py", "sub/four.txt", "a b.txt")


class Writer:
    """Writes one script."""

    def __init__(self, seed: int) -> None:
        self.rng = random.Random(seed)
        self.depth = 0
        self.functions: list[str] = []

    # -- words ---------------------------------------------------------------------------------------------------------

    def one(self, *choices: str) -> str:
        return self.rng.choice(choices)

    def quoted(self, text: str) -> str:
        kind = self.rng.randrange(4)
        if kind == 0 and "'" not in text:
            return f"'{text}'"
        if kind == 1:
            return "$'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"
        return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("$", "\\$").replace("`", "\\`") + '"'

    def literal(self) -> str:
        text = self.rng.choice(TEXTS)
        if text and text.isalnum() and text.isascii() and self.rng.random() < 0.5:
            return text
        return self.quoted(text)

    def number(self) -> str:
        return str(self.rng.choice((0, 1, 2, 3, 5, 7, 10, 42, -1, -3, 255)))

    def pattern(self) -> str:
        return self.rng.choice(PATTERNS)

    def parameter(self) -> str:
        """An expansion of a variable."""
        name = self.rng.choice(NAMES)
        form = self.rng.choice(
            (
                "${N}", "$N", "${N:-D}", "${N-D}", "${N:+D}", "${N+D}", "${N:=D}", "${#N}", "${N%P}", "${N%%P}", "${N#P}", "${N##P}",
                "${N/P/D}", "${N//P/D}", "${N/#P/D}", "${N/%P/D}", "${N^}", "${N^^}", "${N,}", "${N,,}", "${N:1}", "${N:0:2}",
                "${N: -2}", "${N:1:-1}", "${!N}", "${N@Q}", "${N@U}", "${N@L}", "${N@u}", "${N//[a-c]/}", "${N/o/0}", "${N//./_}",
                "${N:$((1+1))}", "${N%.*}", "${N##*/}", "${N%/*}", "${N^^[a-m]}", "${N//\\//-}", "${N:-${b:-deep}}",
            )
        )  # fmt: skip
        return (
            form.replace("N", name)
            .replace("P", self.pattern())
            .replace("D", self.rng.choice(("d", "x y", "", "Z", "'q'")))
        )

    def array(self) -> str:
        """An expansion of an array."""
        name = self.rng.choice(ARRAYS + MAPS)
        form = self.rng.choice(
            (
                "${N[@]}", "${N[*]}", "${#N[@]}", "${!N[@]}", "${N[0]}", "${N[-1]}", "${N[1]}", "${N[@]:1}", "${N[@]:0:2}",
                "${N[@]: -1}", "${#N[1]}", "${N[@]/a/A}", "${N[@]#a}", "${N[@]%o}", "${N[@]^^}", "${N[k]}", "${N[$n]}", "${N[n+1]}",
                "${N[@]:-none}", "${N[*]/%/!}", "${N[@]@Q}", "${N}", "${N[1]:-unset}", "${N[@]@A}",
            )
        )  # fmt: skip
        return form.replace("N", name)

    def special(self) -> str:
        return self.one(
            "$?", "$#", "$@", "$*", "${@:2}", "${@:1:1}", "$0", "$1", "${2:-none}", "$-", "${#}", "${PIPESTATUS[@]}", "$LINENO",
            "${FUNCNAME[0]}", "${BASH_SOURCE[0]##*/}", "${BASH_REMATCH[0]}", "${!#}", "${*:1}", "${@@Q}",
        )  # fmt: skip

    def expansion(self) -> str:
        kind = self.rng.random()
        if kind < 0.55:
            return self.parameter()
        if kind < 0.8:
            return self.array()
        if kind < 0.87:
            return self.special()
        if kind < 0.93 and self.depth < 3:
            return f"$({self.inner()})"
        return f"$(({self.sum()}))"

    def inner(self) -> str:
        self.depth += 1
        try:
            return self.simple() if self.rng.random() < 0.8 else self.pipeline()
        finally:
            self.depth -= 1

    def word(self) -> str:
        kind = self.rng.random()
        if kind < 0.3:
            return self.literal()
        if kind < 0.65:
            return f'"{self.expansion()}"'
        if kind < 0.8:
            return self.expansion()
        if kind < 0.85:
            return self.one(
                "{a,b,c}",
                "{1..3}",
                "x{1..2}y",
                "{a,b}{1,2}",
                "{01..03}",
                "{a..e..2}",
                "{a,'b c'}",
                '"{a,b}"',
                "{x}",
                "{c..a}",
            )
        if kind < 0.9:
            return self.one("*", "*.txt", "*/", "sub/*", "?ne.*", "[ot]*", "none*", "'*'", "*.{txt,py}")
        return self.literal() + self.expansion()

    def words(self, most: int = 3) -> str:
        return " ".join(self.word() for _ in range(self.rng.randint(1, most)))

    def sum(self) -> str:
        kind = self.rng.random()
        if kind < 0.3:
            return self.number()
        if kind < 0.5:
            return self.rng.choice(("n", "$n", "n", "i", "arr[0]", "arr[1]", "${#arr[@]}", "x1", "map[k]"))
        if kind < 0.85:
            return f"{self.sum()} {self.rng.choice(OPERATORS)} {self.sum()}"
        return self.one(
            "n++",
            "++n",
            "n--",
            "n+=2",
            "n=5",
            "(n+1)*2",
            "n?1:2",
            "-n",
            "!n",
            "~n",
            "0x1F",
            "010",
            "2#101",
            "2**3",
            "n,3",
        )

    # -- commands ------------------------------------------------------------------------------------------------------

    def assignment(self) -> str:
        name = self.rng.choice(NAMES)
        arr, assoc = self.rng.choice(ARRAYS), self.rng.choice(MAPS)
        return self.one(
            f"{name}={self.word()}", f"{name}+={self.word()}", f"{name}={self.literal()}", f"{arr}=({self.words()})",
            f"{arr}+=({self.words(2)})", f"{arr}[{self.rng.randrange(4)}]={self.word()}", f"{arr}=([2]=two [5]=five six)",
            f"declare -A {assoc}=([k]=v [\"two words\"]={self.word()} [z]=3)", f"{assoc}[k]={self.word()}", f"n={self.number()}",
            f"declare -i n={self.number()}", f"{arr}=($({self.inner()}))", f"{arr}=(\"$@\")", f"unset {name}", f"unset '{arr}[1]'",
            f"local_{name}={self.word()}", f"declare -u x={self.literal()}", f"declare -l y={self.literal()}", f"export {name}={self.word()}",
            f"{arr}=(*.txt)", f"((n {self.one('+=', '-=', '=')} {self.number()}))", f"let n={self.number()}+1", f"declare -a {arr}",
            f"declare {name}={self.expansion()}", f"{name}=$(( {self.sum()} ))", f"{name}=`{self.one('echo hi', 'echo $n')}`",
        )  # fmt: skip

    def simple(self) -> str:
        return self.rng.choice(
            (
                lambda: f"echo {self.words()}", lambda: f"echo {self.words()}", lambda: f"printf '%s\\n' {self.words()}",
                lambda: f"printf '[%s]' {self.words()}; echo", lambda: f"echo \"{self.expansion()}\" {self.word()}",
                lambda: f"printf '%d %x %05d\\n' {self.number()} 255 {self.number()}", lambda: f"printf '%-8s|%8s|\\n' {self.word()} b",
                lambda: f"echo -n {self.word()}; echo", lambda: f"echo -e 'a\\tb\\n'{self.literal()}", lambda: f"printf '%q\\n' {self.word()}",
                lambda: "true", lambda: "false", lambda: self.one("type -t echo", "type -t if", "type -t nothere", "command -v cd"),
                lambda: self.one("pwd | sed 's,.*/,,' | wc -l", "ls", "ls *.txt", "cat one.txt", "cat nothere", "cd sub && ls; cd - >/dev/null"),
                lambda: f"declare -p {self.rng.choice(NAMES + ARRAYS + MAPS)}", lambda: f"test {self.test()} && echo yes || echo no",
                lambda: f"[ {self.test()} ]; echo $?", lambda: f"printf -v y '%03d' {self.number()}; echo $y",
                lambda: "eval " + self.one("echo \\$n", "echo hi", "x=1"), lambda: f"printf '%s %s\\n' {self.words()}",
                lambda: self.one("shift", "shift 5; echo $?", "set -- p 'q r' s", "set -- $x", 'set -- "$@" more', "set --"),
                lambda: self.one("echo ${#arr[@]}", 'for i in "${!arr[@]}"; do echo "$i=${arr[$i]}"; done', "echo $LINENO"),
            )
        )()  # fmt: skip

    def test(self) -> str:
        return self.one(
            f"-z {self.word_quoted()}", f"-n {self.word_quoted()}", f"{self.word_quoted()} = {self.word_quoted()}", "-f one.txt", "-d sub",
            "-e nothere", f"{self.number()} -lt {self.number()}", f"{self.number()} -eq {self.number()}", "! -f one.txt", "-s one.txt",
            "-r one.txt -a -d sub", f"{self.word_quoted()} != foo", "-v n", "-x one.txt", "a -o b", "( -f one.txt )",
        )  # fmt: skip

    def word_quoted(self) -> str:
        return f'"{self.expansion()}"' if self.rng.random() < 0.6 else self.literal()

    def conditional(self) -> str:
        return "[[ " + self.one(
            f"{self.word_quoted()} == {self.pattern()}", f"{self.expansion()} != {self.pattern()}", f"{self.expansion()} =~ ^[a-z]+$",
            f"{self.word_quoted()} =~ ([0-9]+)", f"-n {self.expansion()} && -f one.txt", f"-z {self.expansion()} || 1 -eq 1",
            f"{self.word_quoted()} < {self.literal()}", f"! {self.word_quoted()} == *o*", f"{self.number()} -ge {self.number()}",
            f"{self.expansion()} == @(foo|bar*)", f"{self.expansion()} == !(x)", f"( {self.word_quoted()} == a* ) && -d sub", "-v n", "-v arr[1]",
            "$name =~ (.)(.*)$ && ${BASH_REMATCH[1]} == f",
        ) + " ]]"  # fmt: skip

    def condition(self) -> str:
        return self.one(self.conditional(), f"[ {self.test()} ]", f"(( {self.sum()} ))", "true", "false", f"test {self.test()}",
                        "grep -q one one.txt", f"! {self.conditional()}")  # fmt: skip

    def body(self, indent: str) -> str:
        self.depth += 1
        lines = [indent + "  " + self.statement(indent + "  ") for _ in range(self.rng.randint(1, 2))]
        self.depth -= 1
        return "\n".join(lines)

    def pipeline(self) -> str:
        source = self.one(
            "printf '%s\\n' c a b a",
            "cat one.txt",
            f"printf '%s\\n' {self.words()}",
            "seq 5",
            "echo 'a b c'",
            "echo a:b:c",
        )
        stages = [self.one("sort", "sort -r", "uniq", "head -n 2", "tail -n 1", "wc -l", "tr a-z A-Z", "cat", "sed 's/a/X/'", "grep a",
                           "cut -d: -f2", "while read -r l; do echo \"<$l>\"; done", "sort -u", "(read -r l; echo \"$l\")", "grep -v a",
                           "sed -n '1p'", "awk '{print $1}'", "xargs echo", "tr -d a", "tac")
                  for _ in range(self.rng.randint(1, 2))]  # fmt: skip
        return " | ".join([source, *stages])

    def statement(self, indent: str = "") -> str:
        deep = self.depth < 3
        choices: list[Callable[[], str]] = [self.assignment] * 5 + [self.simple] * 6 + [self.pipeline] * 2
        choices += [
            lambda: f"{self.condition()} && echo yes || echo no",
            lambda: f"{self.simple()} && {self.simple()}",
            self.redirected,
        ]
        choices += [self.reading, self.odd]
        if deep:
            choices += [lambda: self.compound(indent)] * 5
        return self.rng.choice(choices)()

    def compound(self, indent: str) -> str:
        body, other = self.body(indent), self.body(indent)
        name = self.rng.choice(("f", "g", "helper"))
        return self.rng.choice(
            (
                f"if {self.condition()}; then\n{body}\n{indent}elif {self.condition()}; then\n{indent}  :\n{indent}else\n{other}\n{indent}fi",
                f"if {self.condition()}; then\n{body}\n{indent}fi",
                f"for v in {self.words()}; do\n{indent}  echo \"$v\"\n{body}\n{indent}done",
                f"for ((i = 0; i < {self.rng.randrange(4)}; i++)); do\n{body}\n{indent}done",
                f"i=0; while (( i < 2 )); do\n{body}\n{indent}  i=$((i + 1)); done",
                f"i=3; until [ $i -le 0 ]; do i=$((i - 1)); {self.one('continue', 'break', ':')}; done; echo $i",
                f"case {self.word_quoted()} in\n{indent}  {self.pattern()}) echo one ;{self.one(';', '&', ';&')}\n{indent}  a|foo) echo two ;;\n{indent}  *) echo other ;;\n{indent}esac",
                f"{name}() {{\n{indent}  local v=${{1:-none}} w\n{body}\n{indent}  {self.one('return 3', 'echo $v', ':')}\n{indent}}}\n{indent}{name} {self.words(2)}; echo $?",
                f"( {self.simple()}; {self.one('exit 4', 'x=inner', ':')} ); echo $? $x",
                f"{{ {self.simple()}; {self.simple()}; }} {self.one('', '> out.txt; cat out.txt', '2>/dev/null', '| cat')}",
                f"for f in *.txt; do\n{indent}  [[ -e $f ]] || continue\n{indent}  echo \"${{f%.txt}}\"\n{indent}done",
                "while read -r p q; do echo \"$q-$p\"; done < one.txt",
                f"while IFS= read -r line; do echo \"[$line]\"; done < <({self.simple()})",
                f"while getopts ':ab:' o {self.one('-a', '-b 1', '-ab x', '-z', '-b', '$@')}; do echo \"$o ${{OPTARG:-}}\"; done; echo $OPTIND; OPTIND=1",
            )
        )  # fmt: skip

    def redirected(self) -> str:
        return self.one(
            f"{self.simple()} > out.txt; cat out.txt", f"{self.simple()} >> out.txt; wc -l < out.txt", f"cat <<< {self.word()}",
            f"cat <<EOF\n$x ${{n}} {self.expansion()}\nEOF", "cat <<'EOF'\n$x `y`\nEOF", "cat <<-EOF\n\tindented $n\n\tEOF",
            "nothere 2>/dev/null; echo $?", "cat nothere 2>&1 | wc -l", "{ echo out; echo err >&2; } 2> err.txt; cat err.txt",
            "exec 3> three.out; echo hi >&3; exec 3>&-; cat three.out", "exec 4< one.txt; read -r l <&4; echo \"$l\"; exec 4<&-",
            "echo gone > /dev/null", f"diff <({self.simple()}) <({self.simple()}) > /dev/null; echo $?", "cat < nothere; echo $?",
            "cat <(echo p) <(echo q)", "echo both &> both.txt; cat both.txt", "wc -l < one.txt", "exec {fd}> fd.out; echo z >&$fd; cat fd.out",
        )  # fmt: skip

    def reading(self) -> str:
        return self.one(
            f"read -r a b <<< {self.word_quoted()}; echo \"$a|$b\"", f"IFS=: read -r a b c <<< {self.word_quoted()}; echo \"$a|$b|$c\"",
            f"read -ra arr <<< {self.word_quoted()}; echo ${{#arr[@]}}", "mapfile -t arr < one.txt; echo \"${arr[1]}\"",
            "readarray -t list < <(printf 'l1\\nl2\\n'); echo ${#list[@]}", "IFS=, read -ra arr <<< 'p,q,,r'; declare -p arr",
            "read -r -d '' x <<< 'multi'; echo \"$x\"", "read -n 3 x <<< abcdef; echo $x", "read -r x < one.txt; echo $x",
            "IFS=$'\\n' arr=($(cat one.txt)); echo \"${arr[0]}\"; unset IFS", "mapfile -t -n 1 -s 1 arr < one.txt; declare -p arr",
        )  # fmt: skip

    def odd(self) -> str:
        return self.one(
            "set -e; false || true; set +e", "set -u; echo ${nothere:-ok}; set +u", "set -o pipefail; false | true; echo $?; set +o pipefail",
            "trap 'echo trapped' EXIT", "trap 'echo err $?' ERR; false; trap - ERR", "trap; trap - EXIT", "shopt -s nullglob; echo none*; shopt -u nullglob",
            "shopt -s extglob\necho *.@(txt|py)", "IFS=-; echo \"$*\"; x='a-b'; echo $x; unset IFS", "(exit 3); echo $?", "false | true; echo \"${PIPESTATUS[@]}\"",
            "! true; echo $?", "true & wait $!; echo $?", "readonly R$RANDOM=1; echo $?", "echo $((RANDOM < 32768)) $((SECONDS < 100))",
            "f1() { echo \"$FUNCNAME ${#FUNCNAME[@]}\"; }; f1", "x=1 eval 'echo $x'; y=2 bash -c 'echo $y'", "printf '%s\\n' \"${BASH_SOURCE[0]}\"",
            "declare -n ref=x; echo \"$ref\"; unset -n ref", "alias zz='echo z'; zz 2>/dev/null; echo $?", "echo ~ ~/x \"~\"", "set -f; echo *; set +f",
            "x='a b'; for w in $x; do echo $w; done; for w in \"$x\"; do echo $w; done", "echo a{1,2}b$n", "echo $'a\\x41\\u00e9\\n'", "hash -r; echo $?",
            "x=abc; echo ${x:1:1}${x: -1}", "echo \"${x:+set}\" ${undefinedvar-unset}", "echo ${arr[@]:+has}", "unset arr; echo ${#arr[@]} ${arr[@]-none}",
            "local z=1; echo $?", "return 2>/dev/null; echo $?", "cd nothere; echo $?", "nothere_cmd; echo $?", "if (( n > 2 )); then echo big; fi",
            ". ./nothere.sh; echo $?", "printf 'echo sourced $1 ${BASH_SOURCE[0]}\\nreturn 5\\n' > s.sh; . ./s.sh arg; echo $?", "bash -c 'echo $0 $1' n1 n2",
            "bash -e -c 'false; echo no'; echo $?", "set -x; echo traced; { set +x; } 2>/dev/null", "( set -e; false; echo no ); echo $?", "echo {a..c}{1..2}",
            "time true 2>/dev/null", "[[ abc =~ b(.) ]]; echo ${BASH_REMATCH[@]}", "echo ${x@A} ${arr[@]@K}", "break; echo $?", "while true; do break 2; done; echo $?",
        )  # fmt: skip

    def script(self) -> str:
        head = "printf '%s\\n' 'one 1' 'two 2' 'three 3' > one.txt; : > two.txt; echo x > three.py; mkdir sub; echo 4 > sub/four.txt; echo s > 'a b.txt'"
        setup = f"x={self.literal()}; y={self.literal()}; name=foo; path=/opt/ros/jazzy/setup.bash; n={self.number()}; a=b; b=x"
        arrays = f"arr=(alpha 'be ta' {self.literal()}); declare -A map=([k]=v [j]='w w'); set -- {self.words(3)}"
        lines = [self.statement() for _ in range(self.rng.randint(2, 5))]
        return "\n".join([head, setup, arrays, *lines, ""])


def generated(seed: int) -> str:
    """Return the script of a seed."""
    return Writer(seed).script()
