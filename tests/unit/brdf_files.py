"""Files of measured BRDFs made for tests: f(v, l) as RGL-EPFL's .bsdf, MERL's .binary, or points as text.

Written apart from the readers, from the formats' descriptions: what goes wrong in a reader goes wrong there alone.
"""

import struct

import numpy as np

MERL_SCALE = (1.0 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0)


def direction(theta, phi):
    return np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], axis=-1)


def container(fields):
    """The bytes of a tensor file."""
    kinds = {"|u1": 1, "<u4": 5, "<f4": 10}
    size = 18 + sum(2 + len(name) + 11 + 8 * value.ndim for name, value in fields.items())
    head, body = struct.pack("<12sBBI", b"tensor_file\0", 1, 0, len(fields)), b""
    for name, value in fields.items():
        head += struct.pack(f"<H{len(name)}sHBQ{value.ndim}Q", len(name), name.encode(), value.ndim,
                            kinds[value.dtype.str], size + len(body), *value.shape)
        body += value.tobytes()
    return head + body


def rgl_fields(brdf, angles=12, side=32, description="A synthetic paint"):
    """The fields of an isotropic RGB file of f(v, l), θi that of v.

    The warp is of densities 1 + a (2 x − 1) in either coordinate, which a
    bilinear table holds exactly and which can be inverted by hand.
    """
    theta_i = np.linspace(0.0, np.radians(88.0), angles)
    lean_x, lean_y = np.linspace(0.5, -0.4, angles), np.linspace(-0.3, 0.6, angles)
    ends = np.array([-1.0, 1.0])
    vndf = (1.0 + lean_y[:, None, None] * ends[:, None]) * (1.0 + lean_x[:, None, None] * ends)
    facets = np.exp(-2.0 * np.linspace(0.0, 1.0, 128)) * np.ones((2, 1))
    area = (0.3 + 0.2 * np.linspace(0.0, 1.0, 128) ** 2) * np.ones((2, 1))
    s = np.linspace(0.0, 1.0, side)
    rgb = np.empty((1, angles, 3, side, side))
    for i, theta in enumerate(theta_i):
        x, y = np.meshgrid(unwarped(s, lean_x[i]), unwarped(s, lean_y[i]))
        v = np.broadcast_to(direction(theta, 0.0), (x.size, 3))
        m = direction((x * x * np.pi / 2.0).ravel(), ((2.0 * y - 1.0) * np.pi).ravel())
        l = 2.0 * np.sum(v * m, axis=-1, keepdims=True) * m - v
        f_cos = brdf(v, np.where(l[:, 2:] > 1e-4, l, v)) * np.maximum(l[:, 2:], 0.0)
        ndf, sigma = np.interp(x.ravel(), np.linspace(0, 1, 128), facets[0]), np.interp(
            np.sqrt(theta * 2.0 / np.pi), np.linspace(0, 1, 128), area[0])
        rgb[0, i] = (f_cos * (4.0 * sigma / ndf)[:, None]).T.reshape(3, side, side)
    single = {"theta_i": theta_i, "phi_i": np.zeros(1), "sigma": area, "ndf": facets, "vndf": vndf[None], "rgb": rgb,
              "luminance": rgb[:, :, 1]}
    return {"description": np.frombuffer(description.encode(), "u1"), "version": np.array([2], "<u4"),
            "jacobian": np.array([1], "u1"), **{name: value.astype("<f4") for name, value in single.items()}}


def unwarped(s, lean):
    """x at which the cumulative distribution of 1 + a (2 x − 1) is s: x (1 − a) + a x² = s."""
    return 2.0 * s / ((1.0 - lean) + np.sqrt((1.0 - lean) ** 2 + 4.0 * lean * s))


def merl_bytes(brdf):
    """The bytes of a .binary of f(v, l); −1 where a direction is below the horizon."""
    sizes = (90, 90, 180)
    theta_d, phi_d = np.meshgrid(np.arange(90) / 90 * np.pi / 2.0, np.arange(180) / 180 * np.pi, indexing="ij")
    light = direction(theta_d, phi_d).reshape(-1, 3)
    table = np.empty((3, *sizes))
    for i in range(90):
        tilt = (i / 90) ** 2 * np.pi / 2.0
        turn = np.array([[np.cos(tilt), 0.0, np.sin(tilt)], [0.0, 1.0, 0.0], [-np.sin(tilt), 0.0, np.cos(tilt)]])
        l, v = light @ turn.T, (light * (-1.0, -1.0, 1.0)) @ turn.T
        above = np.minimum(v[:, 2], l[:, 2]) > 0.0
        f = np.where(above[:, None], brdf(np.where(above[:, None], v, (0.0, 0.0, 1.0)),
                                          np.where(above[:, None], l, (0.0, 0.0, 1.0))) / MERL_SCALE, -1.0)
        table[:, i] = f.T.reshape(3, 90, 180)
    return np.array(sizes, "<i4").tobytes() + table.astype("<f8").tobytes()


def points_text(brdf, count=600, seed=1, degrees=True, heading=True, noise=0.0):
    """The text of scattered points of f(v, l): θi φi of the light, θo φo of the viewer, red green blue."""
    rng = np.random.default_rng(seed)
    theta_h, theta_d = np.radians(85.0) * rng.uniform(0, 1, 4 * count) ** 2, np.radians(75.0) * rng.uniform(
        0, 1, 4 * count)
    phi_d, phi_h = rng.uniform(0, np.pi, 4 * count), rng.uniform(-np.pi, np.pi, 4 * count)
    d = direction(theta_d, phi_d)
    def turned(x, y):
        tilted = np.stack([np.cos(theta_h) * x + np.sin(theta_h) * d[:, 2], y,
                           np.cos(theta_h) * d[:, 2] - np.sin(theta_h) * x], axis=-1)
        return np.stack([np.cos(phi_h) * tilted[:, 0] - np.sin(phi_h) * tilted[:, 1],
                         np.sin(phi_h) * tilted[:, 0] + np.cos(phi_h) * tilted[:, 1], tilted[:, 2]], axis=-1)
    l, v = turned(d[:, 0], d[:, 1]), turned(-d[:, 0], -d[:, 1])
    seen = np.flatnonzero(np.minimum(l[:, 2], v[:, 2]) > np.cos(np.radians(80.0)))[:count]
    f = brdf(v[seen], l[seen]) * (1.0 + noise * rng.normal(size=(len(seen), 1)))
    scale = np.degrees(1.0) if degrees else 1.0
    angles = [np.arccos(l[seen, 2]), np.arctan2(l[seen, 1], l[seen, 0]), np.arccos(v[seen, 2]),
              np.arctan2(v[seen, 1], v[seen, 0])]
    rows = np.column_stack([*(angle * scale for angle in angles), f])
    lines = ["theta_i phi_i theta_o phi_o R G B"] if heading else []
    return "\n".join(lines + [" ".join(f"{x:.12g}" for x in row) for row in rows]) + "\n"
