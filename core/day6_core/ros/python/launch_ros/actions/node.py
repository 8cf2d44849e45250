"""Runs a node."""

from __future__ import annotations

import os
import pathlib
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, List  # noqa: UP035

import launch.logging
from launch.actions.execute_process import ExecuteProcess
from launch.frontend.entity import Entity
from launch.frontend.expose import expose_action
from launch.frontend.type_utils import get_data_type_from_identifier
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitutions.local_substitution import LocalSubstitution
from launch.substitutions.text_substitution import TextSubstitution
from launch.utilities import ensure_argument_type, normalize_to_list_of_substitutions, perform_substitutions

from launch_ros.parameter_descriptions import Parameter, ParameterFile, ParameterValue
from launch_ros.remap_rule_type import SomeRemapRules
from launch_ros.substitutions.executable_in_package import ExecutableInPackage, LeftOut
from launch_ros.utilities import (
    add_node_name,
    evaluate_parameters,
    get_node_name_count,
    make_namespace_absolute,
    normalize_parameters,
    normalize_remap_rules,
    prefix_namespace,
)

if TYPE_CHECKING:
    from launch.frontend.parser import Parser
    from launch.launch_context import LaunchContext

_TEXTS = {
    "node-name": "node_name",
    "name": "name",
    "exec_name": "exec_name",
    "pkg": "package",
    "namespace": "namespace",
}


@expose_action("node")
class Node(ExecuteProcess):
    """Runs the executable of a package (without `package`: the executable at a path) with `--ros-args`.

    - `name`, `namespace`: of the node; a relative namespace is below that of `PushRosNamespace`. None: the node's own.
        - `exec_name`: shown before its output, by default the executable's name.
    - `parameters`: a list of files, dicts (written to a file) and `Parameter`s; the last value of a parameter wins.
    - `remappings`: pairs (from, to). `arguments`: words before `--ros-args`. `ros_arguments`: words after it.
    """

    UNSPECIFIED_NODE_NAME = "<node_name_unspecified>"
    UNSPECIFIED_NODE_NAMESPACE = "<node_namespace_unspecified>"

    def __init__(
        self,
        *,
        executable: SomeSubstitutionsType,
        package: SomeSubstitutionsType | None = None,
        name: SomeSubstitutionsType | None = None,
        namespace: SomeSubstitutionsType | None = None,
        exec_name: SomeSubstitutionsType | None = None,
        parameters: Sequence[Any] | None = None,
        remappings: SomeRemapRules | None = None,
        ros_arguments: Iterable[SomeSubstitutionsType] | None = None,
        arguments: Iterable[SomeSubstitutionsType] | None = None,
        **kwargs: Any,
    ) -> None:
        in_package = executable if package is None else ExecutableInPackage(executable=executable, package=package)
        cmd: list[SomeSubstitutionsType] = [in_package, *(arguments or ())]
        if ros_arguments is not None:
            cmd += ["--ros-args", *ros_arguments]
        cmd += ["--ros-args"]
        if name is not None:
            cmd += ["-r", LocalSubstitution("ros_specific_arguments['name']", description="node name")]
        if parameters is not None:
            ensure_argument_type(parameters, (list), "parameters", "Node")
        normalized = normalize_parameters(parameters or [])
        super().__init__(cmd=cmd, **{**kwargs, "name": exec_name})
        self.__package = package
        self.__node_executable = executable
        self.__node_name = name
        self.__node_namespace = namespace
        self.__parameters = normalized
        self.__remappings = list(normalize_remap_rules(remappings or ()))
        self.__expanded_name = self.UNSPECIFIED_NODE_NAME
        self.__expanded_namespace = self.UNSPECIFIED_NODE_NAMESPACE
        self.__expanded_parameter_arguments: list[tuple[str, bool]] = []
        self.__expanded_remappings: list[tuple[str, str]] | None = None
        self.__final_name: str | None = None
        self.__performed = False

    # -- parsing XML and YAML ------------------------------------------------------------------------------------------

    @classmethod
    def parse(cls, entity: Entity, parser: Parser, ignore: Iterable[str] = ()) -> tuple[Any, dict[str, Any]]:
        _, keywords = super().parse(entity, parser, ignore=[*ignore, "cmd", "name"])
        for attribute, keyword in (("args", "arguments"), ("ros_args", "ros_arguments")):
            text = entity.get_attr(attribute, optional=True)
            if text is not None:
                keywords[keyword] = cls._parse_cmdline(text, parser)
        for attribute, keyword in _TEXTS.items():
            text = entity.get_attr(attribute, optional=True)
            if text is not None:
                keywords[keyword] = parser.parse_substitution(text)
        keywords["executable"] = parser.parse_substitution(entity.get_attr("exec"))
        remaps = entity.get_attr("remap", data_type=List[Entity], optional=True)  # noqa: UP006
        if remaps is not None:
            keywords["remappings"] = [
                tuple(parser.parse_substitution(each.get_attr(side)) for side in ("from", "to")) for each in remaps
            ]
            for each in remaps:
                each.assert_entity_completely_parsed()
        parameters = entity.get_attr("param", data_type=List[Entity], optional=True)  # noqa: UP006
        if parameters is not None:
            keywords["parameters"] = cls.parse_nested_parameters(parameters, parser)
        return cls, keywords

    @staticmethod
    def parse_nested_parameters(params: Iterable[Entity], parser: Parser) -> list[Any]:
        """Return the `param` tags of a node in the form of the argument `parameters`."""
        found: list[Any] = []
        for param in params:
            source = param.get_attr("from", optional=True)
            allow_substs = param.get_attr("allow_substs", data_type=bool, optional=True)
            name = param.get_attr("name", optional=True)
            if source is not None and name is not None:
                raise RuntimeError("name and from attributes are mutually exclusive")
            if source is not None:
                param.assert_entity_completely_parsed()
                allowed = (
                    parser.parse_substitution(allow_substs) if isinstance(allow_substs, str) else bool(allow_substs)
                )
                found.append(ParameterFile(parser.parse_substitution(source), allow_substs=allowed))
            elif name is not None:
                if allow_substs is not None:
                    raise RuntimeError("'allow_substs' can only be used together with 'from' attribute")
                found.append(_nested([param], parser))
            else:
                raise ValueError("param Entity should have name or from attribute")
        return found

    # -- properties ----------------------------------------------------------------------------------------------------

    @property
    def node_package(self) -> Any:
        return self.__package

    @property
    def node_executable(self) -> Any:
        return self.__node_executable

    @property
    def node_name(self) -> str:
        """The full name. Raises RuntimeError before the action is executed."""
        if self.__final_name is None:
            raise RuntimeError("cannot access 'node_name' before executing action")
        return self.__final_name

    def is_node_name_fully_specified(self) -> bool:
        """Return whether the launch file gives both namespace and name."""
        unknown = (self.UNSPECIFIED_NODE_NAME, self.UNSPECIFIED_NODE_NAMESPACE)
        return all(each not in self.node_name for each in unknown)

    @property
    def expanded_node_namespace(self) -> str:
        return self.__expanded_namespace

    def _parameter_source(self, path: str) -> str:
        """Return the file whose parameters those at a path are: '' for values of the launch file, written there for the node."""
        files = (each for each in self.__parameters if isinstance(each, ParameterFile) and str(each.param_file) == path)
        return "" if path in _to_remove else next((each._given or path for each in files), path)

    @property
    def expanded_remapping_rules(self) -> list[tuple[str, str]] | None:
        return self.__expanded_remappings

    # -- executing -----------------------------------------------------------------------------------------------------

    def prepare(self, context: LaunchContext) -> None:
        self._perform_substitutions(context)
        own: dict[str, str] = {}
        if self.__node_name is not None:
            own["name"] = f"__node:={self.__expanded_name}"
        if self.__expanded_namespace != "":
            own["ns"] = f"__ns:={self.__expanded_namespace}"
        context.extend_locals({"ros_specific_arguments": own})
        super().prepare(context)

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        try:
            result = super().execute(context)
        except LeftOut as error:  # a real ROS 2 would run it, so what is beside it runs
            launch.logging.get_logger(self.name).error(str(error))
            return None
        if self.is_node_name_fully_specified():
            add_node_name(context, self.node_name)
            count = get_node_name_count(context, self.node_name)
            if count > 1:
                launch.logging.get_logger(self.name).warning(
                    f"there are now at least {count} nodes with the name {self.node_name} created within this "
                    "launch context"
                )
        return result

    def _perform_substitutions(self, context: LaunchContext) -> None:
        """Add name, namespace, parameters and remappings to the command line. Only the first call does so."""
        if self.__performed:
            return
        self.__performed = True
        try:
            self.__expand_names(context)
        except Exception:
            launch.logging.get_logger(__name__).error(
                "Error while expanding or validating node name or namespace for "
                f"'package={self.__package}, executable={self.__node_executable}, name={self.__node_name}, "
                f"namespace={self.__node_namespace}':"
            )
            raise
        self.__final_name = prefix_namespace(self.__expanded_namespace, self.__expanded_name)
        self.__expanded_parameter_arguments = [*self.__global_parameters(context), *self.__own_parameters(context)]
        options = [
            ("--params-file" if is_file else "-p", text) for text, is_file in self.__expanded_parameter_arguments
        ]
        for words in (*options, *(("-r", rule) for rule in self.__remaps(context))):
            self.cmd.extend(normalize_to_list_of_substitutions(word) for word in words)

    def __expand_names(self, context: LaunchContext) -> None:
        from rclpy.validate_namespace import validate_namespace
        from rclpy.validate_node_name import validate_node_name

        def text(given: SomeSubstitutionsType | None) -> str | None:
            return None if given is None else perform_substitutions(context, normalize_to_list_of_substitutions(given))

        name = text(self.__node_name)
        if name is not None:
            self.__expanded_name = name
            validate_node_name(name)
        base = context.launch_configurations.get("ros_namespace")
        namespace = make_namespace_absolute(prefix_namespace(base, text(self.__node_namespace)))
        if namespace is not None:
            self.__expanded_namespace = namespace
            self.cmd.extend([[TextSubstitution(text="-r")], [LocalSubstitution("ros_specific_arguments['ns']")]])
            validate_namespace(namespace)

    def __global_parameters(self, context: LaunchContext) -> Iterable[tuple[str, bool]]:
        """Yield texts `name:=value` and paths of files, and whether it is a file."""
        for each in context.launch_configurations.get("global_params", []):
            if isinstance(each, tuple):
                yield f"{each[0]}:={_argument(each[1])}", False
            else:
                yield os.path.abspath(each), True

    def __own_parameters(self, context: LaunchContext) -> Iterable[tuple[str, bool]]:
        for each in evaluate_parameters(context, self.__parameters):
            if isinstance(each, Parameter):
                name, value = each.evaluate(context)
                yield f"{name}:={_argument(value)}", False
                continue
            path = str(each) if isinstance(each, pathlib.Path) else self.__parameter_file(each)
            if os.path.isfile(path):
                yield path, True
            else:
                launch.logging.get_logger(__name__).warning(f"Parameter file path is not a file: {path}")

    def __parameter_file(self, parameters: Mapping[str, Any]) -> str:
        import yaml

        node = self.node_name if self.is_node_name_fully_specified() else "/**"
        content = {node: {"ros__parameters": dict(parameters)}}
        with tempfile.NamedTemporaryFile("w", prefix="launch_params_", delete=False, encoding="utf-8") as file:
            yaml.dump(
                content, file, default_flow_style=False, allow_unicode=True
            )  # lists get `!!python/tuple`, as there
        _to_remove.append(file.name)
        return file.name

    def __remaps(self, context: LaunchContext) -> Iterable[str]:
        everywhere = context.launch_configurations.get("ros_remaps", [])
        own = [tuple(perform_substitutions(context, side) for side in rule) for rule in self.__remappings]
        if everywhere or own:
            self.__expanded_remappings = [*everywhere, *((source, target) for source, target in own)]
        for source, target in self.__expanded_remappings or ():
            yield f"{source}:={target}"


def _nested(params: Iterable[Entity], parser: Parser) -> dict[Any, Any]:
    found: dict[Any, Any] = {}
    for param in params:
        name = tuple(parser.parse_substitution(param.get_attr("name")))
        kind_name = param.get_attr("type", data_type=None, optional=True)
        kind = None if kind_name is None else get_data_type_from_identifier(kind_name)
        value = param.get_attr("value", data_type=kind, optional=True)
        inner = param.get_attr("param", data_type=List[Entity], optional=True)  # noqa: UP006
        param.assert_entity_completely_parsed()
        if value is not None and inner:
            raise RuntimeError("nested parameters and value attributes are mutually exclusive")
        if kind is not None and inner:
            raise RuntimeError("nested parameters and type attributes are mutually exclusive")
        if value is not None:
            found[name] = ParameterValue(parser.parse_if_substitutions(value), value_type=kind)
        elif inner:
            found[name] = _nested(inner, parser)
        else:
            raise RuntimeError("either a value attribute or nested params are needed")
    return found


def _argument(value: Any) -> str:
    """Return a value in the form that `-p name:=value` takes: one line of YAML."""
    import yaml

    text: str = yaml.safe_dump(list(value) if isinstance(value, tuple) else value, default_flow_style=True, width=2**20)
    return text.removesuffix("\n").removesuffix("\n...")


_to_remove: list[str] = []
"""Parameter files written by this launch."""


def _remove_parameter_files() -> None:
    for path in _to_remove:
        pathlib.Path(path).unlink(missing_ok=True)


def _register_removal() -> None:
    import atexit

    atexit.register(_remove_parameter_files)


_register_removal()
