"""Groups of command line options: dataclasses that several commands share."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import MISSING, Field, fields, is_dataclass
from inspect import Parameter, Signature, getdoc, signature
from typing import Any, get_type_hints

from typer.models import OptionInfo

__all__ = ["expand_options"]


def expand_options(command: Callable[..., None]) -> Callable[..., None]:
    """Return a command for Typer whose dataclass parameters are replaced by their fields.

    Each field declares its option: ``name: Annotated[type, typer.Option(...)] = default``. The first line
    of the dataclass's docstring is the title of the group in the help.
    """
    hints = get_type_hints(command, include_extras=True)
    groups: dict[str, Any] = {name: hint for name, hint in hints.items() if is_dataclass(hint)}
    parameters: list[Parameter] = []
    for name, parameter in signature(command).parameters.items():
        if name in groups:
            parameters += _group_parameters(groups[name])
        else:
            parameters.append(_parameter(name, parameter.default, hints[name]))

    def run(**values: Any) -> None:
        for name, group in groups.items():
            values[name] = group(**{field.name: values.pop(field.name) for field in fields(group)})
        command(**values)

    run.__name__, run.__doc__ = command.__name__, command.__doc__
    run.__annotations__ = {parameter.name: parameter.annotation for parameter in parameters}
    run.__signature__ = Signature(parameters)  # type: ignore[attr-defined]  # read by Typer
    return run


def _group_parameters(group: Any) -> list[Parameter]:
    hints = get_type_hints(group, include_extras=True)
    title = (getdoc(group) or "").partition("\n")[0].rstrip(".")
    parameters = []
    for field in fields(group):
        for information in hints[field.name].__metadata__:
            if isinstance(information, OptionInfo):
                information.rich_help_panel = title
        parameters.append(_parameter(field.name, _default(field), hints[field.name]))
    return parameters


def _parameter(name: str, default: Any, annotation: Any) -> Parameter:
    return Parameter(name, Parameter.KEYWORD_ONLY, default=default, annotation=annotation)


def _default(field: Field[Any]) -> Any:
    if field.default_factory is not MISSING:
        return field.default_factory()
    return Parameter.empty if field.default is MISSING else field.default
