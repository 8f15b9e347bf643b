"""The group of an OSL realisation: the sockets of the model's table before its script."""

from .parameters import add_inputs
from .realisations import REALISATIONS

__all__ = ["build_script", "parameter_of"]


def build_script(builder, model, realisation, given=lambda sockets: {}):
    """Build a model's script, "<model>.osl" in its folder, into a group; `Exact` where the realisation draws the
    formula.

    given  function(operands of the sockets) -> {parameter of the script: operand} that takes the socket's place
    """
    sockets = add_inputs(builder, model.parameters.TABLE, realisation)
    exact = not REALISATIONS[realisation].native
    values = {"Exact": int(exact), **given(sockets)}
    builder.output("BSDF", builder.script(model.folder / f"{model.name}.osl", values))


def parameter_of(socket):
    """What a script calls the parameter that a socket's name is for.

    >>> parameter_of("Slope Ratio 2"), parameter_of("See-through")
    ('SlopeRatio2', 'Seethrough')
    """
    return socket.replace(" ", "").replace("-", "")
