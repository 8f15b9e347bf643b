"""Granier and Heidrich 2003, figures 2 to 5: layers on a turned jar.

By Reference, the formula itself; three luminous balls and a dim sky light the jar.
"""

from .job import Figure
from .pictures import labelled, row
from .studio import add_camera, add_cove, add_lamp, new_scene, set_sky
from .turned import JAR_PROFILE, turned_object

FIGURE_2 = (("1–30 nm, index 1.5\nold metal", "figure_2_old_metal"),
            ("1–210 nm, index 1.3\ncoloured", "figure_2_coloured"),
            ("67–73 nm, index 1.4\nclay", "figure_2_clay"))
FIGURE_3 = (("parallel boundaries", "figure_3_parallel"), ("deviation 10°", "figure_3_deviation"))
FIGURE_4 = (("deviation along the gradient of the thickness", "figure_4"),)
FIGURE_5 = (("1–30 nm", "figure_5_1_30_nm"), ("79–106 nm", "figure_5_79_106_nm"),
            ("146–200 nm", "figure_5_146_200_nm"))


def jar_scene(job, width, height, samples):
    """Balls of light, a sky, a backdrop and a camera, without a jar."""
    scene = new_scene(job.size(width, height), job.samples(samples), denoise=True, noise=0.02)
    for place, radius, radiance in (((-3.6, -4.6, 4.2), 0.35, 20.0), ((3.4, -5.2, 2.8), 0.35, 14.0),
                                    ((0.6, -3.0, 6.5), 0.5, 12.0)):
        add_lamp(scene, place, radius, radiance)
    set_sky(scene, 0.32, 0.16, 0.08)
    add_cove(scene, (0.10, 0.105, 0.12))
    add_camera(scene, (0.0, -7.2, 2.3), (0.0, 0.0, 1.06))
    return scene


def _figure(number, cases, width, height, samples, name, exposure=0.0):
    def make(job):
        from addon import api
        scene = jar_scene(job, width, height, samples)
        scene.view_settings.exposure = exposure
        jars = []
        for title, preset in cases:
            material = api.create_material("layered_rgb", preset=preset, realisation="exact")
            jars.append((title, turned_object(title.split("\n")[0], JAR_PROFILE, material)))
        shown = []
        for title, jar in jars:
            for _, other in jars:
                other.hide_render = other is not jar
            shown.append(labelled(job.render(scene, f"figure {number}, {title.splitlines()[0]}"), title))
        job.write(row(shown), f"{name}.jpg")
        for j, (_, jar) in enumerate(jars):
            jar.hide_render = False
            jar.location.x = 2.6 * (j - 0.5 * (len(jars) - 1))
        job.save_scene(name)
    return make


FIGURES = (
    Figure("layers_2", "Granier and Heidrich, figure 2: the diffuse part", 40.0,
           _figure(2, FIGURE_2, 280, 260, 24, "layers_2", 0.4)),
    Figure("layers_3", "Granier and Heidrich, figure 3: parallel, and deviated by 10°", 60.0,
           _figure(3, FIGURE_3, 330, 310, 32, "layers_3", -0.4)),
    Figure("layers_4", "Granier and Heidrich, figure 4: deviation and thickness correlated", 40.0,
           _figure(4, FIGURE_4, 420, 390, 40, "layers_4", -0.2)),
    Figure("layers_5", "Granier and Heidrich, figure 5: diffuse and specular", 70.0,
           _figure(5, FIGURE_5, 280, 260, 32, "layers_5", -0.4)),
)
