"""Parameter files of unusual shapes: tabs, names written twice, keys that are none, node names with slashes."""
import os
import tempfile

import rclpy
from rclpy.context import Context
from rclpy.node import Node

HEAD = 'robot:\n  ros__parameters:\n    '


def start(text, *more):
    path = os.path.join(tempfile.mkdtemp(), 'robot.yaml')
    with open(path, 'w') as file:
        file.write(text)
    context = Context()
    try:
        rclpy.init(args=['--ros-args', '--params-file', path, *more], context=context)
        node = Node('robot', context=context, automatically_declare_parameters_from_overrides=True)
        own = {name: p.value for name, p in node._parameters.items() if not name.startswith(('use_', 'start_'))}
        print(repr(text), more, own)
        rclpy.shutdown(context=context)
    except Exception as error:
        print(repr(text), more, type(error).__name__, str(error).replace(path, '<FILE>'))


for body in (
    'gain:\t5\n', 'gain: 5\t# per cent\n', 'gain: [1,\t2]\n', 'gain: 5\n\trate: 2\n', 'gain: 5\n    gain: text\n',
    'gain: text\n    gain: 5\n', 'wheel.radius: 1\n    wheel:\n      radius: 2\n', 'gain: |\n', 'gain: [1, [2]]\n',
    '"": 5\n', '[gain]: 5\n', '{gain: 1}: 5\n', 'gain: 1e999\n', 'wheel: {radius: null}\n', 'wheel: {}\n',
):
    start(HEAD + body)
start('robot/:\n  ros__parameters:\n    gain: 5\n')
start('//robot:\n  ros__parameters:\n    gain: 5\n')
start('/:\n  robot:\n    ros__parameters:\n      gain: 5\n')
start(HEAD + 'gain: 5\n', '-p', 'gain:=7')
start('/**:\n  ros__parameters:\n    rate: 1\nrobot:\n  ros__parameters:\n    gain: 5\n', '-p', 'gain:=7')
start('/**:\n  ros__parameters:\n    gain: 5\n', '-p', 'gain:=text')
start('/robot:\n  ros__parameters:\n    gain: 5\n/**:\n  ros__parameters:\n    gain: 6\n', '-p', 'robot:gain:=7')
