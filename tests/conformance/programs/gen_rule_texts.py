"""What remap rules, parameter rules and log levels on the command line may look like, and what is said of the others."""
import rclpy
from rclpy.context import Context
from rclpy.node import Node


def start(*words):
    context = Context()
    try:
        rclpy.init(args=['--ros-args', *words], context=context)
        node = Node('robot', context=context, automatically_declare_parameters_from_overrides=True)
        own = {name: p.value for name, p in node._parameters.items() if not name.startswith(('use_', 'start_'))}
        print(words, node.get_fully_qualified_name(), node.resolve_topic_name('scan'), own)
        rclpy.shutdown(context=context)
    except Exception as error:
        print(words, type(error).__name__, error)


for rule in (
    'scan__raw:=front', 'scan:=__front', '__scan:=front', '__nodes:=arm', '__node:=__arm', '__node:=4wd', '__node:=a.b',
    '__ns:=/fleet/', '__ns:=/4wd', '__ns:=//fleet', 'scan:=\\1', 'scan:=_front', '_:=front',
):
    start('-r', rule)
for rule in (
    'gain:=1e999', 'gain:=1e-999', 'gain:=0xffffffffffffffff', 'gain:= 7 ', 'gain:=*x', 'gain:=&x', 'gain:=-', 'gain:=|',
    'gain:={', 'gain:=[1, [2]]', 'gain:=[1, true]', '/**:gain:=1', '//gain:=1', 'two__words:=1', 'gain:=\t7',
):
    start('-p', rule)
for rule in ('nav:=', 'nav:=loud', 'nav:=7', 'nav:=info:=info', 'nav.planner:=warn'):
    start('--log-level', rule)
for first in ('1', '1.5', 'x', 'true', '[1]', '[x]'):
    for second in ('2', '2.5', 'y', 'false', '[2]', '[y]'):
        start('-p', 'gain:=' + first, '-p', 'gain:=' + second)
start('-p', 'gain:=1', '-p', 'robot:gain:=text')
