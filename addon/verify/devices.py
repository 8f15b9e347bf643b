"""The devices that the probes are rendered on."""

import contextlib

from ..errors import FacetFilmError

__all__ = ["BACKENDS", "DEVICES", "switched_on"]

BACKENDS = ("CUDA", "OPTIX", "HIP", "METAL", "ONEAPI")
"""Cycles' names of the ways to a GPU."""
DEVICES = ("CPU", "GPU", *BACKENDS)


@contextlib.contextmanager
def switched_on(device, preferences=None):
    """Give (what a scene renders on, "CPU" or "GPU"; what it is called), and put the preferences back afterwards.

    device       one of DEVICES: the processor; what the preferences switch on; or all devices of one of BACKENDS,
                 which are switched on meanwhile, and the processor off
    preferences  those of Cycles; by default Blender's

    Raises FacetFilmError where there is no such device.
    """
    if device == "CPU":
        yield "CPU", "CPU"
        return
    preferences = preferences or _preferences()
    kept = preferences.compute_device_type, [(one, one.use) for one in _devices(preferences)]
    try:
        if device in BACKENDS:
            _switch_on(preferences, device)
        yield "GPU", _name(preferences)
    finally:
        preferences.compute_device_type = kept[0]
        for one, use in kept[1]:
            one.use = use


def _switch_on(preferences, backend):
    try:
        preferences.compute_device_type = backend
        found = list(preferences.get_devices_for_type(backend) or ())
    except (TypeError, ValueError):  # this Blender is built without it
        found = []
    if not any(one.type == backend for one in found):
        raise FacetFilmError("device {device}: Blender finds none on this machine; leave the device out to render on "
                             "the CPU.", device=backend)
    for one in found:
        one.use = one.type == backend


def _name(preferences):
    used = [one.name for one in _devices(preferences) if one.use and one.type == preferences.compute_device_type]
    if preferences.compute_device_type == "NONE" or not used:
        raise FacetFilmError("device GPU needs one switched on in Preferences, System, Cycles Render Devices.")
    return f"{preferences.compute_device_type}: {', '.join(used)}"


def _devices(preferences):
    return getattr(preferences, "devices", ())


def _preferences():
    import bpy
    return bpy.context.preferences.addons["cycles"].preferences
