import rclpy, sys
from rclpy.node import Node
from rclpy.context import Context
from rclpy.parameter import Parameter


def run(args, decl=True):
    c = Context()
    try:
        c.init(args)
        n = Node("talker", context=c, automatically_declare_parameters_from_overrides=True)
        out = [
            n.get_fully_qualified_name(),
            n.resolve_topic_name("chatter"),
            n.resolve_topic_name("~/x"),
            n.resolve_service_name("srv"),
        ]
        out += [
            (k, p.type_.name, p.value)
            for k, p in n._parameters.items()
            if k not in ("use_sim_time", "start_type_description_service")
        ]
        print("OK", args, out)
        c.shutdown()
    except BaseException as e:
        print(type(e).__name__, args, "|", e)
    sys.stdout.flush()


R = "--ros-args"
for a in [
    ["p", "chatter:=news"],
    ["p", "__node:=x"],
    [R, "-r", "chatter:=news"],
    [R, "--remap", "chatter:=news"],
    [R, "-r", "/chatter:=/news"],
    [R, "-r", "talker:chatter:=news"],
    [R, "-r", "other:chatter:=news"],
    [R, "-r", "__node:=bob", "-r", "__ns:=/x"],
    [R, "-r", "__name:=bob"],
    [R, "-r", "__ns:=x"],
    [R, "-r", "__node:=a b"],
    [R, "-r", "talker:__node:=bob"],
    [R, "-r", "~/x:=~/y"],
    [R, "-r", "~/x:=/y"],
    [R, "-r", "rostopic://chatter:=news"],
    [R, "-r", "rosservice://srv:=news"],
    [R, "-r", "rosservice://chatter:=news"],
    [R, "-r", "a b:=c"],
    [R, "-r", ":=c"],
    [R, "-r", "a:="],
    [R, "-r", "a:=b:=c"],
    [R, "-r", "1a:=b"],
    [R, "-r", "{node}/x:=y"],
    [R, "-r", "chatter:={node}/y"],
    [R, "-r", "a/*:=b"],
    [R, "-r", "/**:=b"],
    [R, "-p", "a:=1"],
    [R, "--param", "a:=1"],
    [R, "-p", "a.b:=1"],
    [R, "-p", "a/b:=1"],
    [R, "-p", "talker:a:=1"],
    [R, "-p", "other:a:=1"],
    [R, "-p", "/talker:a:=1"],
    [R, "-p", "a b:=1"],
    [R, "-p", "a:="],
    [R, "-p", ":=1"],
    [R, "-p", "a:=1:=2"],
    [R, "-p", "a=1"],
    [R, "-p", "1a:=1"],
    [R, "-p", "a:=-1"],
    [R, "-p", "a:=+1"],
    [R, "-p", "a:=0x10"],
    [R, "-p", "a:=010"],
    [R, "-p", "a:=1."],
    [R, "-p", "a:=.5"],
    [R, "-p", "a:=.inf"],
    [R, "-p", "a:=nan"],
    [R, "-p", "a:=.nan"],
    [R, "-p", "a:=inf"],
    [R, "-p", "a:=1e5"],
    [R, "-p", "a:=True"],
    [R, "-p", "a:=TRUE"],
    [R, "-p", "a:=Yes"],
    [R, "-p", "a:=on"],
    [R, "-p", "a:=off"],
    [R, "-p", "a:=y"],
    [R, "-p", "a:=n"],
    [R, "-p", "a:=no"],
    [R, "-p", "a:='5'"],
    [R, "-p", 'a:="true"'],
    [R, "-p", "a:=null"],
    [R, "-p", "a:=~"],
    [R, "-p", "a:=a b"],
    [R, "-p", "a:=a:b"],
    [R, "-p", "a:=a: b"],
    [R, "-p", "a:={x: 1}"],
    [R, "-p", "a:=[1, 2.5]"],
    [R, "-p", "a:=[1.5, 2]"],
    [R, "-p", "a:=[1, a]"],
    [R, "-p", "a:=[true, false]"],
    [R, "-p", "a:=[]"],
    [R, "-p", "a:=[[1]]"],
    [R, "-p", 'a:=["1","2"]'],
    [R, "-p", "a:=[1"],
    [R, "-p", "a:=9223372036854775808"],
    [R, "-p", "a:=1_000"],
    [R, "-p", "a:=#x"],
    [R, "-p", "a:=x #y"],
    [R, "-p", "a:=2021-01-01"],
    [R, "-p", "a:=!!str 5"],
    [R, "-p"],
    [R, "-r"],
    [R, "--params-file"],
    [R, "--log-level"],
    [R, "--enclave"],
    [R, "-e", "/x"],
    [R, "-e", "x"],
    [R, "--log-level", "debug"],
    [R, "--log-level", "DEBUG"],
    [R, "--log-level", "loud"],
    [R, "--log-level", "talker:=loud"],
    [R, "--log-level", "talker:=info"],
    [R, "--log-level", "10"],
    [R, "--log-level", ":=info"],
    [R, "--log-config-file", "x"],
    [R, "--log-config-file"],
    [R, "--log-file-name", "x"],
    [R, "--disable-stdout-logs"],
    [R, "--enable-rosout-logs"],
    [R, "--disable-rosout-logs"],
    [R, "--disable-external-lib-logs"],
    [R, "--enable-stdout-logs", "x"],
    [R, "foo", "bar"],
    [R, "foo", "--", "bar"],
    ["a", R, "-r", "x:=y", "--", "b", R, "-p", "z:=1"],
    [R, R],
    ["--"],
    [R, "-x"],
    [R, "-r=x:=y"],
    [R, "-rx:=y"],
    [R, "__node:=x"],
    [R, "--remap", "-p"],
    [5],
    ["a", None],
]:
    run(a)
for text in (
    "talker:\n  ros__parameters:\n    a: 1\n",
    "/**:\n  ros__parameters:\n    a: 1\n    n:\n      x: 2\n      y: [1,2]\n",
    "/talker:\n  ros__parameters:\n    a: hi\n",
    "/*:\n  ros__parameters:\n    a: hi\n",
    "/x/talker:\n  ros__parameters:\n    a: hi\n",
    "x:\n  talker:\n    ros__parameters:\n      a: 1\n",
    "/**/talker:\n  ros__parameters: {a: 5}\n",
    "talker:\n  ros__parameters:\n",
    "talker:\n",
    "talker: 5\n",
    "- a\n",
    "talker:\n  a: 1\n",
    "talker:\n  ros__parameters:\n    a: [1, x]\n",
    "talker:\n  ros__parameters:\n    a: {}\n",
    "talker:\n  ros__parameters:\n    a:\n",
    "talker:\n  ros__parameters:\n    a: [[1]]\n",
    "talker:\n  ros__parameters:\n    a: 1\n    a: 2\n",
    "5:\n  ros__parameters:\n    a: 1\n",
    "talker:\n  ros__parameters:\n    5: 1\n",
    "talker:\n  ros__parameters:\n    a: &x 1\n    b: *x\n",
    "#c\n",
    "{talker: {ros__parameters: {a: 1.5}}}",
    '"talker":\n  "ros__parameters":\n    a: "1"\n    b: \'true\'\n',
    "talker:\n  ros__parameters:\n    a: |\n      x\n      y\n",
    "talker:\n  ros__parameters:\n    a: b: c\n",
    "talker\n",
    "talker:\n  ros__params:\n    a: 1\n",
    "/**:\n  ros__parameters:\n    a: 1\n/talker:\n  ros__parameters:\n    a: 2\n",
    "/talker:\n  ros__parameters:\n    a: 2\n/**:\n  ros__parameters:\n    a: 1\n",
    "---\ntalker:\n  ros__parameters:\n    a: 1\n",
    "talker:\n  ros__parameters:\n    a.b: 1\n",
    "talker:\n  ros__parameters:\n    a: null\n",
    "talker:\n  ros__parameters:\n    a: []\n",
    "ros__parameters:\n  a: 1\n",
    "talker:\n  ros__parameters:\n  a: 1\n",
):
    open("p.yaml", "w").write(text)
    print(repr(text))
    run([R, "--params-file", "p.yaml"])
run([R, "--params-file", "."])
open("p.yaml", "w").write("talker:\n  ros__parameters:\n    a: 1\n    b: 7\n")
run([R, "--params-file", "p.yaml", "-p", "a:=2"])
run([R, "-p", "a:=2", "--params-file", "p.yaml"])
run([R, "-r", "__node:=bob", "--params-file", "p.yaml"])
run([R, "-r", "__ns:=/x", "--params-file", "p.yaml"])
open("p.yaml", "w").write("bob:\n  ros__parameters:\n    a: 1\n")
run([R, "-r", "__node:=bob", "--params-file", "p.yaml"])
