"""The report of a verification: one HTML file that needs no other, and whose first line says how it went."""

import html

from ..models import all_models
from ..models.realisations import REALISATIONS
from .pictures import data_url, strip

__all__ = ["realisation_title", "verdict", "page", "unfinished", "table_text"]

STYLE = """
body { font: 15px/1.5 system-ui, sans-serif; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; color: #1c1c1c; }
h1 { font-size: 1.4rem; padding: .7rem 1rem; border-radius: .4rem; color: #fff; }
.green h1 { background: #1a7f37; } .red h1 { background: #b42318; }
h2 { margin-top: 2.2rem; font-size: 1.15rem; }
table { border-collapse: collapse; width: 100%; } th { text-align: left; }
th, td { padding: .35rem .6rem; border-bottom: 1px solid #ddd; vertical-align: top; }
td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.passed { color: #1a7f37; font-weight: 600; } .failed { color: #b42318; font-weight: 600; }
img { image-rendering: pixelated; display: block; } small { color: #666; }
details { margin-top: 1rem; } summary { cursor: pointer; }
"""


def _titles():
    """{group of checks: its heading}."""
    return {**{model.name: model.title for model in all_models()}, "data": "Measured data"}


def realisation_title(name):
    """What people call a realisation; of what is none, the name itself.

    >>> realisation_title("exact"), realisation_title("")
    ('Reference', '')
    """
    return REALISATIONS[name].title if name in REALISATIONS else name


def verdict(results, facts):
    """The first line: Green or Not green, how many checks, and on what.

    results  (Check, Outcome or the text of an error, seconds) of each
    facts    (name, value) pairs; "Blender" and "Device" are named in the line
    """
    failed = [check.title for check, outcome, _ in results if not _passed(outcome)]
    named = dict(facts)
    where = f"on Blender {named['Blender']}, {named['Device']}"
    if not results:
        return f"Not green: nothing was checked {where}"
    if failed:
        return f"Not green: {len(failed)} of {len(results)} checks failed {where}"
    return f"Green: all {len(results)} checks passed {where}"


def unfinished(facts):
    """The page while the checks run, and what is left of a run that was cut short."""
    named = dict(facts)
    line = html.escape(f"Not green: not finished on Blender {named['Blender']}, {named['Device']}")
    return (f"<!doctype html><title>{line}</title>\n<html lang=\"en\"><meta charset=\"utf-8\"><style>{STYLE}</style>"
            f"<body class=\"red\"><h1>{line}</h1></body></html>\n")


def page(results, facts, presets, left_out=()):
    """The HTML of the whole report.

    presets   rows of :func:`addon.verify.data_checks.table_of_presets`
    left_out  (realisation, reason) of what this Blender cannot render
    """
    line = html.escape(verdict(results, facts))
    green = line.startswith("Green")
    parts = [f"<!doctype html><title>{line}</title>", '<html lang="en"><meta charset="utf-8">',
             f"<style>{STYLE}</style>", f'<body class="{"green" if green else "red"}">', f"<h1>{line}</h1>",
             "<p>Facet &amp; Film rendered its probes on this Blender and compared the pixels with the formulas of the "
             "papers, by quadrature. A figure passes when it is at most its limit; |z| is a difference in standard "
             "errors, and its limit what chance exceeds once in a thousand runs of the check.</p>",
             _rows([(html.escape(name), html.escape(str(value))) for name, value in facts])]
    if left_out:
        named = "; ".join(f"{html.escape(realisation_title(name))} ({html.escape(why)})" for name, why in left_out)
        parts.append(f"<p>Not run: {named}.</p>")
    for model, title in _titles().items():
        of_model = [result for result in results if result[0].model == model]
        if of_model:
            parts += [f"<h2>{title}</h2>", _checks(of_model)]
    parts += ["<h2>Presets</h2>", _presets(presets), "</body></html>"]
    return "\n".join(parts) + "\n"


def _passed(outcome):
    return not isinstance(outcome, str) and outcome.passed


def _rows(pairs):
    return "<table>" + "".join(f"<tr><th>{name}</th><td>{value}</td></tr>" for name, value in pairs) + "</table>"


def _checks(results):
    rows = ["<table><tr><th>Check</th><th>Figures</th><th>Formula, render, difference</th></tr>"]
    for check, outcome, seconds in results:
        mark = '<span class="passed">passed</span>' if _passed(outcome) else '<span class="failed">FAILED</span>'
        name = html.escape(f"{realisation_title(check.realisation)}: {check.name}" if check.realisation else check.name)
        if isinstance(outcome, str):
            figures, shown = html.escape(outcome), ""
        else:
            figures = "<br>".join(html.escape(_figure(figure)) for figure in outcome.figures)
            shown = _picture(outcome.picture)
        rows.append(f"<tr><td><b>{name}</b> {mark}<br><small>{html.escape(check.what)}; {seconds:.1f} s</small></td>"
                    f"<td>{figures}</td><td>{shown}</td></tr>")
    return "\n".join(rows + ["</table>"])


def _figure(figure):
    sign = "" if figure.passed else "  ✗"
    if figure.per_cent:
        return f"{figure.name}: {figure.value:.2%} of at most {figure.limit:.2%}{sign}"
    return f"{figure.name}: {figure.value:.3g} of at most {figure.limit:.3g}{sign}"


def _picture(picture):
    if picture is None:
        return ""
    return f'<img alt="formula, render, difference × {picture.times:g}" src="{data_url(strip(picture))}">'


def _presets(rows):
    head = (f"<details><summary>How far each of the {len(rows)} presets is from its measured spectrum: largest "
            "CIEDE2000 over angle</summary><table><tr><th>Preset</th><th>Kind</th><th>Dataset</th><th>n and k</th>"
            "<th>n and k, this Blender</th><th>F0 and F82</th></tr>")
    body = "".join(
        "<tr>" + "".join(f"<td>{html.escape(text)}</td>" for text in row[:3])
        + "".join(f'<td class="number">{value:.2f}</td>' for value in row[3:]) + "</tr>" for row in rows)
    return head + body + "</table></details>"


def table_text(results):
    """The checks as the rows of a Markdown table: realisation, check, figures, passed or not."""
    rows, titles = ["| realisation | check | figures | |", "|---|---|---|---|"], _titles()
    for check, outcome, _ in results:
        figures = outcome if isinstance(outcome, str) else "; ".join(_figure(figure) for figure in outcome.figures)
        rows.append(f"| {titles[check.model]} {realisation_title(check.realisation)} | {check.name} | {figures} | "
                    f"{'passed' if _passed(outcome) else '**FAILED**'} |")
    return "\n".join(rows)
