"""Cook and Torrance 1982, figure 7: twelve vases, six of metals and six of the materials of Table I."""

from .job import Figure
from .pictures import column, labelled, row, strip
from .turned import VASE_PROFILE, turned_object
from .vases import paper_scene

METALS = (("bronze", "figure_7_bronze"), ("tungsten", "figure_7_tungsten"), ("copper", "figure_7_copper"),
          ("tin", "figure_7_tin"), ("nickel", "figure_7_nickel"), ("stainless steel", "figure_7_stainless_steel"))
OTHERS = (("carbon", "carbon"), ("rubber", "rubber"), ("obsidian", "obsidian"),
          ("lunar dust", "lunar_dust"), ("olive drab", "olive_drab"), ("rust", "rust"))
SCALES = {"metals": "energy", "others": "published"}
"""As for figure 6: a metal at the printed scale reflects more light than arrives."""


def figure_7(job):
    """The vases in their order in the paper, all under the lights of figure 6."""
    from addon import api
    scene = paper_scene(job, 210, 270, 32)
    vases = []
    for kind, materials in (("metals", METALS), ("others", OTHERS)):
        for title, preset in materials:
            material = api.create_material(preset=preset, name=title, scale=SCALES[kind])
            vases.append((title, turned_object(title, VASE_PROFILE, material)))
    shown = []
    for title, vase in vases:
        for _, other in vases:
            other.hide_render = other is not vase
        shown.append(labelled(job.render(scene, f"figure 7, {title}"), title, size=round(14 * job.scale) or 1))
    width = row(shown[:6]).shape[1]
    job.write(column([strip("metals: s = 1, m = 0.4 (40 %) and 0.2 (60 %)", width, round(15 * job.scale) or 1),
                      row(shown[:6]),
                      strip("Table I: specular and diffuse of one colour", width, round(15 * job.scale) or 1),
                      row(shown[6:])]), "twelve_vases.jpg")
    for j, (_, vase) in enumerate(vases):
        vase.hide_render = False
        vase.location = (2.4 * (j % 6 - 2.5), 3.4 * (j // 6), 0.0)
    job.save_scene("twelve_vases")


FIGURES = (Figure("twelve_vases", "Cook and Torrance, figure 7: twelve vases", 100.0, figure_7),)
