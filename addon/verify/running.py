"""Runs the checks one after the other and writes the report.  Blender is imported when it starts."""

import importlib.util
import json
import os
import platform
import sys
import time

from .. import models
from ..errors import FacetFilmError, choice
from ..models.realisations import REALISATIONS
from .devices import DEVICES, switched_on

__all__ = ["checks", "groups", "verify", "DEVICES", "REPORT"]

REPORT = "facet_film_verification.html"
DATA = "data"


def groups():
    """The names of the groups of checks: one a model, and that of the measured data."""
    return (*models.names(), DATA)


def checks(only=None):
    """(the checks that this Blender can run, (realisation, reason) of what it cannot).

    only  one of groups(), or None for all
    """
    _require_blender()
    from ..nodes.osl_compiler import why_no_osl
    reason = why_no_osl()
    left_out = [name for name, found in REALISATIONS.items() if reason and found.osl]
    chosen = groups() if only is None else (choice("only", only, groups()),)
    found = [check for group in chosen for check in _checks_of(group, left_out)]
    return found, [(name, reason) for name in left_out]


def _checks_of(group, left_out):
    """A group's checks: of a model those of its own file, else those that any model has to pass."""
    name = f"{__package__}.{group}_checks"
    own = importlib.util.find_spec(name)
    model = models.named(models.DEFAULT if group == DATA else group)  # measured metals become the default's
    realisations = [name for name in model.realisations if name not in left_out]
    if own is not None:
        return importlib.import_module(name).checks(realisations)
    from . import any_model
    return any_model.checks(group, realisations)


def verify(path=REPORT, *, device="CPU", only=None, record=None, say=print):
    """Run the checks, write the report, and return (whether all passed, its first line).

    path    of the HTML file
    device  one of DEVICES: "CPU"; "GPU" for those that Blender's preferences switch on; or "CUDA", "OPTIX", "HIP",
            "METAL", "ONEAPI", which are switched on meanwhile
    only    one of groups(), or None for all
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
    with switched_on(device) as (cycles_device, device_name):
        facts = _facts(device_name)
        # A path that cannot be written is known before minutes pass, and a run that is cut short is not green.
        write_text(path, report.unfinished(facts))
        scenes.render_on(cycles_device)
        with _quiet():
            scenes.require_readable()
        results = _results(todo, say)
    written = write_text(path, report.page(results, facts, data_checks.table_of_presets(), left_out))
    if record is not None:
        write_text(record, _record(results, facts, left_out))
    line = report.verdict(results, facts)
    return line.startswith("Green"), f"{line}\n{written}"


def _results(todo, say):
    """(check, Outcome or an error's text, seconds) of each, in turn."""
    results = []
    for number, check in enumerate(todo, 1):
        outcome, seconds = _run(check)
        results.append((check, outcome, seconds))
        passed = "passed" if not isinstance(outcome, str) and outcome.passed else "FAILED"
        say(f"{number}/{len(todo)} {passed}: {check.title} ({seconds:.1f} s)")
    return results


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


def _facts(device_name):
    """What decides the results, as (name, value) pairs."""
    import bpy
    import numpy
    return (("Blender", bpy.app.version_string), ("Device", device_name),
            ("Facet & Film", _version()), ("Build", bpy.app.build_hash.decode()),
            ("Python", platform.python_version()), ("numpy", numpy.__version__),
            ("System", f"{platform.system()} {platform.machine()}"),
            ("When", time.strftime("%Y-%m-%d %H:%M UTC", time.gmtime())))


def _version():
    import tomllib
    from pathlib import Path
    manifest = Path(__file__).parents[2] / "blender_manifest.toml"
    return tomllib.loads(manifest.read_text(encoding="utf-8"))["version"]


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
