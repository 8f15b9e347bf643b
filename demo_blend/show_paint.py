"""Three helmets in colour-shifting wraps, measured and fitted, their visors coated with gold.

    python -m demo_blend.figures show_paint
"""

from .helmet import helmet
from .interiors import focus, set_room, show_scene
from .job import Figure
from .studio import add_camera, add_cove, add_softbox

HELMETS = (  # preset, where it stands, how it is turned about the vertical
    ("wrap_purple_gem", (0.0, -0.35, 0.0), -0.55), ("wrap_northern_aurora", (-2.05, 1.35, 0.0), 0.55),
    ("wrap_sunset", (2.02, 1.50, 0.0), -1.05),
)


def paint(job):
    """The three of them under the long lamps that cars are photographed by."""
    from addon import api
    scene = show_scene(job, 12)
    set_room(scene, "studio.exr", strength=0.7, turn=0.6)
    add_cove(scene, (0.085, 0.088, 0.10), back=6.0)
    visor = api.create_material(preset="gold_visor")
    for preset, place, turn in HELMETS:
        made = helmet(preset, api.create_material(preset=preset), visor, detail=min(1.0, 2.0 * job.scale))
        made.location, made.rotation_euler = place, (0.0, 0.0, turn)
    add_softbox(scene, (-0.5, 0.0, 6.0), (0.0, 0.0, 0.8), (8.0, 3.5), 6.0)
    add_softbox(scene, (-6.0, -2.4, 2.8), (0.0, 0.0, 0.9), (1.4, 5.0), 8.0)
    add_softbox(scene, (6.0, -1.0, 3.0), (0.0, 0.0, 0.9), (1.4, 5.0), 8.0)
    add_softbox(scene, (-2.5, -7.5, 5.5), (0.0, 0.0, 0.9), (5.0, 2.5), 3.0)
    add_softbox(scene, (0.0, 4.5, 1.2), (0.0, 9.0, 2.5), (6.0, 0.5), 5.0, seen=False)
    camera = add_camera(scene, (0.3, -9.2, 2.3), (0.02, 0.2, 0.92), 61.5)
    focus(camera, (0.1, -1.0, 0.9), 4.0)
    job.write(job.render(scene, "three helmets"), "show_paint.jpg")
    job.save_scene("show_paint")


FIGURES = (Figure("show_paint", "Helmets in colour-shifting wraps", 150.0, paint),)
