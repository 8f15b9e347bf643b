"""Runs the checks one after the other and writes the report.  Blender is imported when it starts."""

import json
import os
import platform
import sys
import time

from ..errors import FacetFilmError, choice
from ..parameters import REALISATIONS

__all__ = ["checks", "verify", "GROUPS", "DEVICES", "REPORT"]

GROUPS = ("cook_torrance", "layered_rgb", "data")
DEVICES = ("CPU", "GPU")
REPORT = "facet_film_verification.html"
OSL = ("osl", "osl_fast")


def checks(only=None):
    """(the checks that this Blender can run, (realisation, reason) of what it cannot).

    only  one of GROUPS, or None for all
    """
    _require_blender()
    from ..nodes.osl_compiler import why_no_osl
    from . import cook_torrance_checks, data_checks, layered_checks
    modules = {"cook_torrance": cook_torrance_checks, "layered_rgb": layered_checks, "data": data_checks}
    reason = why_no_osl()
    realisations = [name for name in REALISATIONS if not (reason and name in OSL)]
    groups = GROUPS if only is None else (choice("only", only, GROUPS),)
    found = [check for group in groups for check in modules[group].checks(realisations)]
    return found, [(name, reason) for name in OSL if reason]


def verify(path=REPORT, *, device="CPU", only=None, record=None, say=print):
    """Run the checks, write the report, and return (whether all passed, its first line).

    path    of the HTML file
    device  "CPU", or "GPU" for those that Blender's preferences switch on
    only    one of GROUPS, or None for all
    record  path of the same as JSON, or None
    say     function that is told each line of progress

    The open file is replaced by the probes' scenes.  Raises FacetFilmError
    outside Blender, for an unknown device or group, a GPU that is not there,
    or a path that cannot be written.
    """
    choice("device", device, DEVICES)
    todo, left_out = checks(only)
    from ..export import write_text
    from . import data_checks, report, scenes
    facts = _facts(device)
    # A path that cannot be written is known before minutes pass, and a run that is cut short is not green.
    write_text(path, report.unfinished(facts))
    scenes.render_on(device)
    results = []
    for number, check in enumerate(todo, 1):
        outcome, seconds = _run(check)
        results.append((check, outcome, seconds))
        passed = "passed" if not isinstance(outcome, str) and outcome.passed else "FAILED"
        say(f"{number}/{len(todo)} {passed}: {check.title} ({seconds:.1f} s)")
    written = write_text(path, report.page(results, facts, data_checks.table_of_presets(), left_out))
    if record is not None:
        write_text(record, _record(results, facts, left_out))
    line = report.verdict(results, facts)
    return line.startswith("Green"), f"{line}\n{written}"


def _run(check):
    """(Outcome, seconds) of a check; the error's text in place of an Outcome where it broke off."""
    start = time.perf_counter()
    with _quiet():
        try:
            outcome = check.run()
        except Exception as error:  # one check that breaks off is a failed check, and the others still run
            outcome = f"{type(error).__name__}: {error}"
    return outcome, time.perf_counter() - start


class _quiet:
    """Keeps Blender's own lines, one a render, out of the output, also those that it writes from C."""

    def __enter__(self):
        sys.stdout.flush()
        self._kept, silence = os.dup(1), os.open(os.devnull, os.O_WRONLY)
        os.dup2(silence, 1)
        os.close(silence)

    def __exit__(self, *_error):
        sys.stdout.flush()
        os.dup2(self._kept, 1)
        os.close(self._kept)


def _facts(device):
    """What decides the results, as (name, value) pairs."""
    import bpy
    import numpy
    return (("Blender", bpy.app.version_string), ("Device", _device_name(device)),
            ("Facet & Film", _version()), ("Build", bpy.app.build_hash.decode()),
            ("Python", platform.python_version()), ("numpy", numpy.__version__),
            ("System", f"{platform.system()} {platform.machine()}"),
            ("When", time.strftime("%Y-%m-%d %H:%M UTC", time.gmtime())))


def _version():
    import tomllib
    from pathlib import Path
    manifest = Path(__file__).parents[2] / "blender_manifest.toml"
    return tomllib.loads(manifest.read_text(encoding="utf-8"))["version"]


def _device_name(device):
    if device == "CPU":
        return "CPU"
    import bpy
    preferences = bpy.context.preferences.addons["cycles"].preferences
    used = [found.name for found in getattr(preferences, "devices", ())
            if found.use and found.type == preferences.compute_device_type]
    if preferences.compute_device_type == "NONE" or not used:
        raise FacetFilmError("device GPU needs one switched on in Preferences, System, Cycles Render Devices.")
    return f"{preferences.compute_device_type}: {', '.join(used)}"


def _record(results, facts, left_out):
    return json.dumps({
        "facts": dict(facts), "left_out": [list(pair) for pair in left_out],
        "checks": [{
            "model": check.model, "realisation": check.realisation, "name": check.name, "seconds": round(seconds, 2),
            **({"error": outcome} if isinstance(outcome, str) else {
                "passed": outcome.passed,
                "figures": [{"name": f.name, "value": f.value, "limit": f.limit} for f in outcome.figures]}),
        } for check, outcome, seconds in results]}, ensure_ascii=False, indent=1) + "\n"


def _require_blender():
    try:
        import bpy  # noqa: F401
    except ImportError:
        raise FacetFilmError("verify renders, so it runs in Blender: blender --command facet_film verify, "
                             "or python -m addon verify where bpy is installed.") from None
