"""Straight lines between knots, put into the curves and ramps of nodes."""

__all__ = ["set_knots", "set_stops"]


def set_knots(mapping, curve, knots, values):
    """Put straight lines between knots into a curve of a CurveMapping; their ends are held."""
    mapping.use_clip = False
    mapping.extend = "HORIZONTAL"
    points = mapping.curves[curve].points
    while len(points) < len(knots):
        points.new(0.5, 0.5)
    for point, knot, value in zip(points, knots, values):
        point.location = (float(knot), float(value))
        point.handle_type = "VECTOR"
    mapping.update()


def set_stops(ramp, knots, values):
    """Put straight lines between knots, at most 32, into a color ramp."""
    ramp.color_mode, ramp.interpolation = "RGB", "LINEAR"
    while len(ramp.elements) < len(knots):
        ramp.elements.new(0.5)
    for stop, knot in zip(ramp.elements, knots):
        stop.position = float(knot)
    for stop, value in zip(ramp.elements, values):
        stop.color = (*map(float, value), 1.0)
