"""The panel that shows what was baked into a material."""

import bpy
from bpy.app.translations import pgettext_iface as iface_
from bpy.app.translations import pgettext_n as n_

from ..assets.thumbnails import colour_icon, strip_icon
from ..datablocks.materials import baked_of, our_node
from .drawing import draw_facts, draw_sentence
from .material import MaterialPanel

__all__ = ["CLASSES", "draw_measurement"]


class FACET_FILM_PT_baked(MaterialPanel, bpy.types.Panel):
    """What was baked into this material, and how far it is from the measurement"""

    bl_label = "Measurement"
    bl_parent_id = "FACET_FILM_PT_material"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context):
        """Shown for materials of ours that were baked."""
        return our_node(context.material) is not None and bool(baked_of(context.material))

    def draw(self, context):
        """The colours, and the record of the bake."""
        draw_measurement(self.layout, baked_of(context.material), context.region)


def draw_measurement(layout, record, region):
    """What a record of a bake says: colours, fit, source, gamut."""
    layout.label(text=record["title"], icon="MATERIAL", translate=False)
    if "conductor" not in record:
        draw_sentence(layout, record["note"], "INFO", region)
        if "fitted" in record:
            draw_facts(layout, facts_of_fit(record["fitted"]), region)
        return
    _draw_colours(layout, record)
    draw_facts(layout, facts_of(record), region)


def _draw_colours(layout, record):
    row = layout.row()
    curve, space = record["fresnel"], record["space"]
    for text, icon in ((iface_("At 0°"), colour_icon(curve["rgb"][-1], space)),
                       (iface_("0° to 90°"), strip_icon(curve["cos_theta"], curve["rgb"], space))):
        column = row.column(align=True)
        column.label(text=text, translate=False)
        column.template_icon(icon, scale=3.0)


def facts_of(record):
    """(name, value) of what the panel says."""
    source, gamut = record["source"], record["gamut"]
    low, high = source["wavelength_range_nm"]
    reach = f"{low:.0f}–{high:.0f} nm" + ("" if source["covers_visible"] else iface_("; ends held"))
    moved = iface_("Inside, unchanged")
    if gamut["outside"]:
        moved = iface_("Outside: {:s}, channels moved by up to {:.3f}").format(
            iface_(gamut["method"].capitalize()), gamut["largest_change"])
    assumed = [(n_("Read As"), line) for line in source.get("assumed", ())]
    outside = [(n_("Outside"), str(record["medium"]))] if record.get("medium", 1.0) != 1.0 else []
    return (
        ("F0", _three(record["f0"])),
        (n_("F82 Tint"), _three(record["f82_tint"])),
        (n_("Fit"), iface_("CIEDE2000 at most {:.2f}").format(record["conductor"]["delta_e_2000_max"])),
        (n_("Wavelengths"), reach),
        (n_("Light"), f"{record['illuminant']}, {record['observer']}"),
        (n_("Working Space"), record["space"]),
        (n_("Gamut"), moved),
        (n_("Dataset"), source["dataset"]),
        (n_("Citation"), source["citation"]),
        *outside, *assumed,
    )


def facts_of_fit(fitted):
    """(name, value) of what a fit to a measured BRDF said of itself."""
    difference, samples = fitted["delta_e_2000"], fitted["samples"]
    return (
        (n_("File"), fitted["file"]),
        (n_("Fit"), iface_("CIEDE2000 {:.2f} on average, below {:.1f} in 95 %").format(
            difference["mean"], difference["p95"])),
        (n_("Verdict"), iface_(fitted["verdict"])),
        (n_("Samples"), iface_("{:d} used, {:d} left out").format(samples["used"], samples["rejected"])),
    )


def _three(values):
    return "  ".join(f"{value:.3f}" for value in values)


CLASSES = (FACET_FILM_PT_baked,)
