"""What a scene's settings lack to render a realisation, in a sentence."""

import bpy
from bpy.app.translations import pgettext_iface as iface_
from bpy.app.translations import pgettext_rpt as rpt_

from ..models.realisations import REALISATIONS

__all__ = ["IN_EVERY_ENGINE", "shown_name", "what_is_missing", "why_no_script_runs"]

IN_EVERY_ENGINE = tuple(name for name, found in REALISATIONS.items() if found.native and not found.osl)


def shown_name(realisation):
    """What a realisation is called in the interface's language."""
    return iface_(REALISATIONS[realisation].title)


def what_is_missing(scene, realisation):
    """What the scene's settings lack to render this realisation, or an empty text."""
    engine = scene.render.engine
    if engine == "BLENDER_WORKBENCH":
        return rpt_("Workbench shows the viewport colour only: choose Cycles in the Render properties")
    if engine != "CYCLES":
        return "" if realisation in IN_EVERY_ENGINE else rpt_("This engine renders Standard in its place: "
                                                     "for this realisation choose Cycles in the Render properties")
    return why_no_script_runs(scene, realisation)


def why_no_script_runs(scene, realisation):
    """Why Cycles shows another realisation in place of this one's script, or an empty text."""
    if not REALISATIONS[realisation].osl or not hasattr(scene, "cycles"):
        return ""
    shown = shown_name(REALISATIONS[realisation].without_osl)
    if not scene.cycles.shading_system:
        return rpt_("Open Shading Language is off: {:s} is shown in its place until you switch it on in the Render "
                    "properties").format(shown)
    if scene.cycles.device == "GPU" and _gpu_without_osl():
        return rpt_("OSL needs the CPU or OptiX: {:s} is shown in its place on this device").format(shown)
    return ""


def _gpu_without_osl():
    preferences = bpy.context.preferences.addons.get("cycles")
    return preferences is None or preferences.preferences.compute_device_type != "OPTIX"
