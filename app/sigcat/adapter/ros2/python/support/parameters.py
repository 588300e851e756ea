"""Parameters of a node: settings that every node has, and those that its core takes."""

import math
from threading import Lock
from typing import Any, Callable, Dict, Mapping, Optional, Sequence, Tuple

from rcl_interfaces.msg import ParameterDescriptor, SetParametersResult
from rclpy.exceptions import InvalidParameterValueException
from rclpy.lifecycle import LifecycleNode
from rclpy.parameter import Parameter

from .core import Core

POLICIES = ('other', 'fifo', 'rr')
"""Scheduling policies of the thread that runs the calls."""
Limits = Tuple[float, float]
"""Smallest and largest value of a parameter, in its unit."""
ANY: Limits = (-math.inf, math.inf)
CoreParameters = Callable[[Callable[[str], Any]], Dict[str, Any]]
"""Parameters of the core, from what answers those of the node."""


class Parameters:
    """All parameters of a node."""

    def __init__(
        self, node: LifecycleNode, core: Core, core_lock: Lock, core_parameters: CoreParameters,
    ) -> None:
        """Begin with none; made before any other callback of parameters is added."""
        self._node = node
        self._core = core
        self._core_lock = core_lock
        self._core_parameters = core_parameters
        self._defaults: Dict[str, Any] = {}
        self._limits: Dict[str, Limits] = {}
        self._are_declared = False
        self._has_post_set = hasattr(node, 'add_post_set_parameters_callback')
        if not self._has_post_set:  # Humble calls the first callback last, if no other refuses
            node.add_on_set_parameters_callback(self._take)

    def declare_settings(self, policy: str, priority: Optional[int], *, is_stored: bool) -> None:
        """
        Declare what the node has beside the parameters of its function.

        Raises InvalidParameterValueException for an unknown policy.
        """
        self._declare_setting(
            'lock_step', False,
            'Whether the service ~/step gives the time: for tests and replays.')
        if is_stored:
            self._declare_setting(
                'storage_folder', '',
                f'Folder of the values that the node keeps; $ROS_HOME/{self._core.package} or '
                f'~/.ros/{self._core.package} if empty.')
        if priority is not None:
            self._declare_policy(policy, priority)

    def _declare_policy(self, policy: str, priority: int) -> None:
        self._declare_setting(
            'scheduling_policy', policy,
            f'Policy of the thread that runs the calls, with priority {priority}.',
            'one of ' + ', '.join(POLICIES))
        given = self.value('scheduling_policy')
        if given not in POLICIES:
            reason = f'it must be one of {", ".join(POLICIES)}'
            raise InvalidParameterValueException('scheduling_policy', given, reason)

    def _declare_setting(
        self, name: str, default: Any, description: str, constraints: str = ''
    ) -> None:
        self._node.declare_parameter(name, default, ParameterDescriptor(
            description=description, additional_constraints=constraints, read_only=True))

    def declare(
        self, name: str, default: Any, descriptor: ParameterDescriptor, limits: Limits = ANY,
    ) -> None:
        """Declare a parameter of the function."""
        self._defaults[name] = default
        self._limits[name] = limits
        self._node.declare_parameter(name, default, descriptor)

    def value(self, name: str) -> Any:
        """Answer the present value."""
        return self._node.get_parameter(name).value

    def take_changes(self) -> None:
        """Refuse what the node was started with if the core does, and ask it from now on."""
        result = self._set([])
        if not result.successful:
            values = {name: self.value(name) for name in self._defaults}
            names = ', '.join(self._defaults)
            raise InvalidParameterValueException(names, values, result.reason)
        self._are_declared = True
        if self._has_post_set:
            self._node.add_on_set_parameters_callback(self._check)
            self._node.add_post_set_parameters_callback(self._set)

    def given(self, stored: Mapping[str, Any]) -> Dict[str, Any]:
        """Answer what differs from the defaults, which the core has itself."""
        given = self._core_parameters(self.value)
        defaults = self._core_parameters(lambda name: self._defaults[name])
        return {
            name: {'value': value, 'is_there': True}
            for name, value in given.items()
            if value != defaults[name] and (name not in self._core.learned or name not in stored)
        }

    def _take(self, parameters: Sequence[Parameter]) -> SetParametersResult:
        """Take changes, but no value that a parameter is declared with."""
        if not self._are_declared:
            return SetParametersResult(successful=True)
        return self._set(parameters)

    def _check(self, parameters: Sequence[Parameter]) -> SetParametersResult:
        """Refuse what the core would; it keeps what it has, since others may refuse, too."""
        return self._set(parameters, is_only_checked=True)

    def _set(
        self, parameters: Sequence[Parameter], *, is_only_checked: bool = False,
    ) -> SetParametersResult:
        """Take all of them, or none."""
        changed = {each.name: each.value for each in parameters}
        try:
            values = self._of_core(
                lambda name: changed[name] if name in changed else self.value(name))
            present = self._of_core(self.value) if is_only_checked else values
            with self._core_lock:
                is_taken = self._core.set_parameters(values)
                if is_taken and is_only_checked:
                    self._core.set_parameters(present)
        except (TypeError, ValueError, OverflowError) as error:
            return SetParametersResult(successful=False, reason=str(error))
        reason = '' if is_taken else self._refusal(changed or {
            name: self.value(name) for name in self._defaults})
        return SetParametersResult(successful=is_taken, reason=reason)

    def _of_core(self, value: Callable[[str], Any]) -> Dict[str, Any]:
        """Answer the parameters of the core that the node sets."""
        return {
            name: each for name, each in self._core_parameters(value).items()
            if name not in self._core.learned
        }

    def _refusal(self, values: Mapping[str, Any]) -> str:
        """Answer which parameter the core refuses, and what its limits are."""
        for name, value in values.items():
            low, high = self._limits.get(name, ANY)
            elements = [value] if isinstance(value, (int, float)) else value
            if any(isinstance(each, (int, float)) and not low <= each <= high
                   for each in elements):
                return f'{name} must be from {low:g} to {high:g}'
        return f'{", ".join(values)}: a value is out of its range'


def symbol(numbers: Mapping[str, int], text: Any) -> int:
    """Answer the number of a symbol. Raises ValueError for a text that is none."""
    if text not in numbers:
        raise ValueError(f'{text!r} is none of {", ".join(numbers)}')
    return numbers[text]
