"""How a function is called, whatever its annotations say."""

import inspect


def signature(function):
    """Names, order and defaults of the parameters, as text."""
    found = inspect.signature(function)
    plain = [
        parameter.replace(annotation=parameter.empty) for parameter in found.parameters.values()
    ]
    return str(found.replace(parameters=plain, return_annotation=found.empty))
