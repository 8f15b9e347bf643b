"""What a model offers to everything outside of its folder, and the few values that it does so with."""

import dataclasses
from collections.abc import Callable, Mapping
from importlib import import_module
from pathlib import Path
from typing import NamedTuple

from .parameters import Checked, read, sockets_of, written
from .renderer import Renderer

__all__ = ["Baked", "Feed", "Form", "Group", "Look", "Model", "Picture", "Renderer", "Swatch"]


@dataclasses.dataclass(frozen=True)
class Group:
    """A node group of a model.

    identifier  what it is found by in files, unique among all models
    name        what people see
    version     raised whenever what it computes or its interface changes
    build       "module.function" of the model's folder: a function of the GroupBuilder that it is handed
    summary     one sentence for menus and assets
    stand_in    id of the group that EEVEE shows in its place, or ""
    osl         whether its code is compiled by the Blender that it is built in
    in_menu     whether the Add menu offers it
    pictured    whether its Image Texture nodes show the Picture of a material: a group takes no image through a socket,
                so the file has a copy of the group for each
    """

    identifier: str
    name: str
    version: int
    build: str
    summary: str
    stand_in: str = ""
    osl: bool = False
    in_menu: bool = True
    pictured: bool = False


class Feed(NamedTuple):
    """A group node that stands before a material's own and feeds it.

    group   id of its group
    values  {socket: value} of it
    links   {output of it: socket of the material's node}
    """

    group: str
    values: Mapping
    links: Mapping


class Picture(NamedTuple):
    """An image that a material's group looks its colours up in.

    name  what the image is called
    key   a text that no other image has: a file holds one image for each
    make  function() -> (pixels ``(rows, columns, 4)``, {name: text} that model.read() finds again, {socket: value}
          that the look-up needs)
    """

    name: str
    key: str
    make: Callable


class Baked(NamedTuple):
    """What a model makes of a preset or measurement.

    parameters  {name: value} that it sets
    facts       what was baked, from what and how far off it is, ready for JSON; {} where nothing was
    variant     which of a realisation's groups renders it: 0 is the usual one
    """

    parameters: Mapping
    facts: Mapping
    variant: int = 0


class Look(NamedTuple):
    """What a material looks like at a glance, for the Solid viewport and small pictures: linear RGB, ``(..., 3)``.

    colour    all of it
    mirror    what its mirror reflects at normal incidence
    specular  the mirror's share, ``(...)``
    slope     rms slope of its facets
    diffuse   what the diffuse part reflects
    """

    colour: object
    mirror: object
    specular: float
    slope: float
    diffuse: object


class Swatch(NamedTuple):
    """Colours of a material over what they depend on, as a strip.

    over    what that is: "angle", "thickness" or "depth"
    unit    of it, as people read it
    places  the values, ``(columns,)``
    rgb     linear RGB in the material's working space, ``(rows, columns, 3)``; of several rows the lower are seen at
            a more grazing angle
    """

    over: str
    unit: str
    places: object
    rgb: object


class Form(NamedTuple):
    """A form that a material leaves in: its title, what it holds, and the file's ending."""

    title: str
    tip: str
    ending: str


@dataclasses.dataclass(frozen=True, eq=False)
class Model:
    """A reflectance model, as everything outside of its folder sees it.

    package       dotted name of its folder
    title         what people call it
    summary       one sentence on what it is for
    citation      the publication
    parameters    its class of checked parameters, with its TABLE
    groups        every Group of its own
    realisations  {name of addon.models.realisations.REALISATIONS: ids of the groups that render it, the usual one
                  first}
    evaluate      function(parameters, n, v, l) -> the whole BRDF in 1/sr, ``(..., 3)``, of unit directions ``(..., 3)``
                  and, where the surface has a direction of its own, a tangent, by default around the z axis
    facts         function(resolved preset, addon.bake.Bake) -> all that was baked, ready for JSON; for measurements
    bake          function(resolved preset, viewing options, realisation, Renderer) -> Baked
    look          function(parameters, place) -> Look; place is None, or x, y, z on a unit ball, ``(...)`` each
    as_baked      function(parameters, facts) -> whether what was baked is still what the material holds
    baked_names   the parameters that a new bake of the same measurement replaces; all others stay as the user set them
    respaced      function(parameters, names that the user changed of what was baked, space, other space) ->
                  {name: value} of them in the other scene-linear space; those that are colours may be left out
    follows       {parameter: option of a bake}: it is replaced, too, by a bake that has another value of the option
    feeds         function(parameters) -> Feeds that stand before its node
    read_feed     function({group's id: ({socket: value}, outputs that are linked)}) -> {parameter's name: value}
    forms         {name: Form} that :func:`write_form` knows
    write_form    function(form, Record) -> text
    swatch        function(Record, columns) -> Swatch, or None where its colours depend on nothing that a strip shows
    fits          {name of what F is: "module.Class" of the addon.models.fitted.Form that measurements are fitted in}
    standin       function(Record in linear Rec.709 by the exact formula) -> addon.export.standin.Standin, the shader of
                  base colour and metalness that comes closest; None where a look has to do
    measured      whether a measurement that is no preset can become a material of it
    refracts     function(parameters) -> whether light is bent by a material, which EEVEE has to be told
    sheet        function(parameters) -> whether a material is one sheet that light goes straight through, which EEVEE
                 has to be told, too
    index, index_outside  of clear bodies the parameters that are the index of refraction inside, and of what a face is
                  against
    made_of       the parameter that says in words what the material is made of, which preset= takes as well; or ""
    own_data      the parameter that holds the user's own measurements which those words name, as JSON; or ""
    picture       function(parameters, viewing options) -> the Picture of its pictured groups
    newcomers     whether its groups have links that only some Blenders take: see addon.nodes.newcomers
    work_ahead    function(resolved preset, viewing options, progress) that works out what takes long of a bake, telling
                  progress the share that is done; None where nothing does
    no_longer     function(parameters, Baked of other words) -> {name: value} of what the user set and those words do
                  not have, such as a thickness beyond the new ones
    """

    package: str
    title: str
    summary: str
    citation: str
    parameters: type[Checked]
    groups: tuple[Group, ...]
    realisations: Mapping[str, tuple[str, ...]]
    evaluate: Callable
    bake: Callable
    look: Callable
    facts: Callable | None = None
    as_baked: Callable = lambda parameters, facts: False
    baked_names: tuple[str, ...] = ()
    respaced: Callable = lambda parameters, changed, before, after: {}
    follows: Mapping[str, str] = dataclasses.field(default_factory=dict)
    feeds: Callable = lambda parameters: ()
    read_feed: Callable = lambda fed: {}
    forms: Mapping[str, Form] = dataclasses.field(default_factory=dict)
    write_form: Callable | None = None
    swatch: Callable | None = None
    fits: Mapping[str, str] = dataclasses.field(default_factory=dict)
    standin: Callable | None = None
    measured: bool = False
    refracts: Callable = lambda parameters: False
    sheet: Callable = lambda parameters: False
    index: str = ""
    index_outside: str = ""
    made_of: str = ""
    own_data: str = ""
    picture: Callable | None = None
    newcomers: bool = False
    work_ahead: Callable | None = None
    no_longer: Callable = lambda parameters, baked: {}

    @property
    def name(self):
        """What scripts call it: its folder's name."""
        return self.package.rpartition(".")[2]

    @property
    def folder(self):
        """Path of its folder."""
        return Path(import_module(self.package).__file__).parent

    def group(self, identifier):
        """The Group with this id."""
        return next(group for group in self.groups if group.identifier == identifier)

    def build(self, identifier, builder):
        """Build the group with this id into a GroupBuilder."""
        module, _, function = self.group(identifier).build.partition(".")
        getattr(import_module(f".{module}", self.package), function)(builder)

    def realisation_of(self, identifier):
        """(realisation, variant) of the group with this id, or None for a group that renders no material."""
        for realisation, identifiers in self.realisations.items():
            if identifier in identifiers:
                return realisation, identifiers.index(identifier)
        return None

    def group_of(self, realisation, variant=0):
        """The Group that renders a realisation; where it has no such variant, the usual one."""
        identifiers = self.realisations[realisation]
        return self.group(identifiers[variant] if variant < len(identifiers) else identifiers[0])

    def sockets(self, realisation):
        """The Sockets of a realisation's groups."""
        return sockets_of(self.parameters.TABLE, realisation)

    def written(self, parameters, realisation):
        """{socket: value} of the parameters in a realisation's group."""
        names = {socket.name for socket in self.sockets(realisation)}
        return {name: value for name, value in written(parameters).items() if name in names}

    def read(self, values, fed):
        """The checked parameters of a node's values, ``{socket: value}``, and of what feeds it, as read_feed has it."""
        return self.parameters(**{**read(self.parameters.TABLE, values), **self.read_feed(fed)})
