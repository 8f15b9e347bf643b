"""What a measurement is read as, drawn before anything is made of it."""

from bpy.app.translations import pgettext_iface as iface_
from bpy.app.translations import pgettext_n as n_

from ..assets.thumbnails import colour_icon
from .drawing import draw_facts, draw_sentence

__all__ = ["draw_preview"]


def draw_preview(layout, operator, seen, region=None):
    """Quantity, range and colour of a Preview, what was assumed, and the choice where there is one.

    operator  whose `choose` picks a reading
    seen      an addon.bake.previewing.Preview, or None where no file is chosen
    """
    if seen is None:
        layout.label(text=iface_("Choose a file: here stands what it is read as"), icon="INFO", translate=False)
        return
    layout.label(text=seen.name, icon="FILE", translate=False)
    if seen.choices or operator.choose:
        layout.prop(operator, "choose")
    if seen.trouble:
        draw_sentence(layout, seen.trouble, "QUESTION" if seen.choices else "ERROR", region)
        return
    layout.template_icon(colour_icon(tuple(min(max(channel, 0.0), 1.0) for channel in seen.f0), "Rec.709"), scale=3.0)
    low, high = seen.range_nm
    facts = [(n_("Read As"), f"{seen.read_as}: {seen.quantity}"), (n_("Wavelengths"), f"{low:.0f}–{high:.0f} nm"),
             ("F0", "  ".join(f"{channel:.3f}" for channel in seen.f0))]
    draw_facts(layout, facts, region)
    for line in seen.assumed:
        draw_sentence(layout, line, "INFO", region)
