"""Several actions with their own launch configurations and environment."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, List  # noqa: UP035

from launch.action import Action
from launch.actions.pop_environment import PopEnvironment
from launch.actions.pop_launch_configurations import PopLaunchConfigurations
from launch.actions.push_environment import PushEnvironment
from launch.actions.push_launch_configurations import PushLaunchConfigurations
from launch.actions.reset_environment import ResetEnvironment
from launch.actions.reset_launch_configurations import ResetLaunchConfigurations, kept_configurations
from launch.actions.set_launch_configuration import SetLaunchConfiguration
from launch.frontend.expose import expose_action
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType

if TYPE_CHECKING:
    from launch.frontend.entity import Entity
    from launch.frontend.parser import Parser
    from launch.launch_context import LaunchContext


@expose_action("group")
class GroupAction(Action):
    """Visits `actions`.

        `scoped`: their changes to launch configurations and environment are undone after them. `forwarding`: they see
    those from outside the group (else only `launch_configurations`, which are set for them in both cases).
    """

    def __init__(
        self,
        actions: Iterable[LaunchDescriptionEntity],
        *,
        scoped: bool = True,
        forwarding: bool = True,
        launch_configurations: Mapping[SomeSubstitutionsType, SomeSubstitutionsType] | None = None,
        **left_over_kwargs: Any,
    ) -> None:
        super().__init__(**left_over_kwargs)
        self.__actions = actions
        self.__scoped = scoped
        self.__forwarding = forwarding
        self.__launch_configurations = launch_configurations or {}
        self.__all: list[LaunchDescriptionEntity] | None = None

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[Any, dict[str, Any]]:
        from launch.frontend.entity import Entity as AnyEntity

        _, keywords = super().parse(entity, parser)
        for name in ("scoped", "forwarding"):
            value = entity.get_attr(name, data_type=bool, optional=True)
            if value is not None:
                keywords[name] = value
        keeps = entity.get_attr("keep", data_type=List[AnyEntity], optional=True)  # noqa: UP006
        if keeps is not None:
            keywords["launch_configurations"] = kept_configurations(keeps, parser)
        keywords["actions"] = [parser.parse_action(each) for each in entity.children if each.type_name != "keep"]
        return cls, keywords

    def get_sub_entities(self) -> Sequence[LaunchDescriptionEntity]:
        if self.__all is None:
            settings = [SetLaunchConfiguration(name, value) for name, value in self.__launch_configurations.items()]
            inside = list(self.__actions)
            if self.__forwarding or not self.__scoped:
                inside = [*settings, *inside]
            if self.__scoped:
                start: list[LaunchDescriptionEntity] = [PushLaunchConfigurations(), PushEnvironment()]
                if not self.__forwarding:
                    start += [ResetEnvironment(), ResetLaunchConfigurations(self.__launch_configurations)]
                inside = [*start, *inside, PopEnvironment(), PopLaunchConfigurations()]
            self.__all = inside
        return self.__all

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        return self.get_sub_entities()
