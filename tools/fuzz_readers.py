"""Reads measurements that were tampered with at random: each is read, or refused in a sentence, without a traceback.

    python tools/fuzz_readers.py [HOW_MANY] [SEED]

The seeds are the readings of tests/unit/readings.py and the valid files of tests/unit/malformed.py; a part of them
is cut, doubled, swapped, flipped, or mixed with a part of another.
"""

import collections
import pathlib
import sys
import tempfile
import time
import traceback
import warnings

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from addon.bake.reflected import reflect  # noqa: E402
from addon.errors import FacetFilmError  # noqa: E402
from addon.spectra.readers import read_file  # noqa: E402

PUT = [
    b"nan",
    b"\n",
    b"-",
    b"1e308",
    b"1e-308",
    b"\x00",
    b"\xff",
    b",",
    b";",
    b"\t",
    b"(",
    b"[",
    b"{",
    b"<td>",
    b"#",
    b"%",
    b"R",
    b"k",
    b"eV",
    b"DATA:",
    b"NM A 2 0 1",
    b"MATE X",
    b"BEGIN_DATA",
    b"9" * 40,
    "波长".encode(),
    b"1.5+2j",
    b'"',
    b"'",
    b"0",
    b"1e999",
]


def tampered(random, seeds):
    """(content, name) of a file with one to four things done to it."""
    content, name = seeds[random.integers(len(seeds))]
    content = bytearray(content)
    for _ in range(random.integers(1, 5)):
        size = len(content)
        start = int(random.integers(size + 1))
        end = min(size, start + int(random.integers(0, 40)))
        kind = random.integers(7)
        if kind == 0:
            del content[start:end]
        elif kind == 1:
            content[start:start] = PUT[random.integers(len(PUT))]
        elif kind == 2 and size:
            content[min(start, size - 1)] ^= 1 << int(random.integers(8))
        elif kind == 3:
            content[start:start] = content[start:end] * 3
        elif kind == 4:
            other = seeds[random.integers(len(seeds))][0]
            at = int(random.integers(len(other) + 1))
            content[start:end] = other[at : at + 200]
        elif kind == 5:
            lines = bytes(content).split(b"\n")
            random.shuffle(lines)
            content = bytearray(b"\n".join(lines))
        else:
            lines = bytes(content).split(b"\n")
            for separator in (b",", b"\t", b";", b" "):
                if separator in content:
                    order = random.permutation(max(line.count(separator) for line in lines) + 1)
                    cells = [line.split(separator) for line in lines]
                    content = bytearray(
                        b"\n".join(separator.join(row[at] for at in order if at < len(row)) for row in cells)
                    )
                    break
    return bytes(content), name


def run(count, seed, folder):
    """(how many were read, refused; the ten slowest; the tracebacks)."""
    from tests.unit.malformed import VALID
    from tests.unit.readings import READINGS

    seeds = [(reading.content, reading.file) for reading in READINGS.values()]
    seeds += [(content.encode(), name) for name, content in VALID.values()]
    random, outcomes, failures, slowest = np.random.default_rng(seed), collections.Counter(), [], 0.0
    for number in range(count):
        content, name = tampered(random, seeds)
        path = folder / name
        path.write_bytes(content)
        start = time.perf_counter()
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                constants = read_file(path)
                assert np.isfinite(reflect(constants).colours).all() and (np.diff(constants.wavelength_nm) > 0.0).all()
            outcomes["read"] += 1
        except FacetFilmError as error:
            assert str(error).isprintable() and len(str(error)) < 1000, str(error)
            outcomes["refused"] += 1
        except Exception:
            failures.append((number, content, traceback.format_exc()))
        slowest = max(slowest, time.perf_counter() - start)
    return outcomes, failures, slowest


if __name__ == "__main__":
    how_many, with_seed = (int(word) for word in (sys.argv[1:] + ["10000", "1"][len(sys.argv) - 1 :]))
    with tempfile.TemporaryDirectory() as made:
        found, broken, longest = run(how_many, with_seed, pathlib.Path(made))
    for number, content, why in broken[:5]:
        print(number, content[:300], why, sep="\n")
    print(f"{dict(found)}, {len(broken)} tracebacks, the slowest {longest:.2f} s")
    sys.exit(bool(broken))
