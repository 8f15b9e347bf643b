"""Measurements as people have them, made from our gold by code: name -> Reading.

The numbers are those of Johnson and Christy in the visible; every case writes
them down in another way.  Judged by F0: Rec.709, D65, 2°.
"""

import dataclasses
import json

import numpy as np

__all__ = ["Reading", "READINGS", "REFUSED", "GOLD", "W", "N", "K", "R", "E1", "E2", "EV", "rows"]


@dataclasses.dataclass(frozen=True)
class Reading:
    """A file of measurements.

    content  its bytes
    file     its name
    f0       what follows from it, or REFUSED
    """

    content: bytes
    file: str
    f0: object


REFUSED = "refused"
GOLD, R_GOLD, GLASS = (1.0377, 0.7283, 0.3645), (1.0349, 0.7276, 0.3653), (0.04, 0.04, 0.04)
W = np.array(
    [
        331.5,
        342.5,
        354.2,
        367.9,
        381.5,
        397.4,
        413.3,
        430.5,
        450.9,
        471.4,
        495.9,
        520.9,
        548.6,
        582.1,
        616.8,
        659.5,
        704.5,
        756.0,
        821.1,
        892.0,
    ]
)
N = np.array(
    [
        1.48,
        1.48,
        1.5,
        1.48,
        1.46,
        1.47,
        1.46,
        1.45,
        1.38,
        1.31,
        1.04,
        0.62,
        0.43,
        0.29,
        0.21,
        0.14,
        0.13,
        0.14,
        0.16,
        0.17,
    ]
)
K = np.array(
    [
        1.883,
        1.871,
        1.866,
        1.895,
        1.933,
        1.952,
        1.958,
        1.948,
        1.914,
        1.849,
        1.833,
        2.081,
        2.455,
        2.863,
        3.272,
        3.697,
        4.103,
        4.542,
        5.083,
        5.663,
    ]
)
R = ((N - 1.0) ** 2 + K**2) / ((N + 1.0) ** 2 + K**2)
E1, E2 = N * N - K * K, 2.0 * N * K
EV = 1239.841984 / W
READINGS = {}


def rows(*columns, sep=",", end="\n"):
    """Lines of numbers."""
    return "".join(sep.join(f"{x:.8g}" for x in row) + end for row in zip(*columns))


def lines(form, *columns, end="\n"):
    """Lines of a form that is given a number a column."""
    return "".join(form.format(*row) + end for row in zip(*columns))


def comma(text):
    """With decimal commas."""
    return text.replace(".", ",")


def add(name, content, file="a.csv", want=GOLD):
    """One more case."""
    READINGS[name] = Reading(content if isinstance(content, bytes) else content.encode(), file, want)


# --- layouts, units, quantities, words, formats ---
add("eV unnamed header E", "E,n,k\n" + rows(EV, N, K))
add("eV alone", "eV\tn\tk\n" + rows(EV, N, K, sep="\t"), "a.txt")
add("hv (eV)", "hv (eV)  n  k\n" + rows(EV, N, K, sep="  "), "a.txt")
add("Energy[eV];n;k comma", ("Energie [eV];n;k\n" + rows(EV, N, K, sep=";")).replace(".", ","))
add("wavenumber cm^-1", "Wavenumber (cm^-1)\tn\tk\n" + rows(10000000.0 / W, N, K, sep="\t"), "a.txt")
add("wn bare cm-1 header", "cm-1,n,k\n" + rows(10000000.0 / W, N, K))
add("freq Hz header", "f (Hz),n,k\n" + rows(2.99792458e17 / W, N, K))
add("freq THz bare name", "frequency_THz,n,k\n" + rows(299792.458 / W, N, K))
add("metres named", "wavelength (m),n,k\n" + rows(W * 1e-09, N, K))
add("wl_m", "wavelength_m n k\n" + rows(W * 1e-09, N, K, sep=" "), "a.txt")
add("angstrom named", "Wavelength (A),n,k\n" + rows(W * 10, N, K))
add("eps complex col", "wavelength_nm,eps\n" + "\n".join((f"{w},{complex(a, b)}" for w, a, b in zip(W, E1, E2))))
add("n complex i", "wl (nm),n\n" + "\n".join((f"{w},{n}+{k}i" for w, n, k in zip(W, N, K))))
add("n complex minus", "wl (nm)\tn\n" + "\n".join((f"{w}\t{n}-{k}i" for w, n, k in zip(W, N, K))), "a.txt")
add("n complex spaced", "wl (nm)\tN\n" + "\n".join((f"{w}\t{n} - {k}i" for w, n, k in zip(W, N, K))), "a.txt")
add("np tuple", "nm n\n" + "\n".join((f"{w} ({n}+{k}j)" for w, n, k in zip(W, N, K))), "a.txt")
add("(n, k) tuple bare", "\n".join((f"({w}, {n}, {k})" for w, n, k in zip(W, N, K))), "a.txt")
add("python list", "[\n" + "\n".join((f"[{w}, {n}, {k}]," for w, n, k in zip(W, N, K))) + "\n]", "a.txt")
add("re im n", "Wavelength(nm),Re(n),Im(n)\n" + rows(W, N, K))
add("real imag", "lambda (nm)  n_real  n_imag\n" + rows(W, N, K, sep=" "), "a.txt")
add("eps_r eps_i", "wavelength_nm eps_r eps_i\n" + rows(W, E1, E2, sep=" "), "a.txt")
add("eps1 eps2 greek", "λ (nm),ε1,ε2\n" + rows(W, E1, E2))
add("epsilon_1", "wavelength (nm),epsilon_1,epsilon_2\n" + rows(W, E1, E2))
add("bare eps", rows(W, E1, E2, sep=" "), "a.txt")
add("eps2 neg", "nm,e1,e2\n" + rows(W, E1, -E2))
add("title 2 lines", "Gold\nMeasured 2019 by A. Author\n\nWavelength (nm),n,k\n" + rows(W, N, K))
add("title comma", "Au, evaporated, 200 nm\nWavelength (nm),n,k\n" + rows(W, N, K))
add("title starts digit", "200 nm gold film\nWavelength (nm)\tn\tk\n" + rows(W, N, K, sep="\t"), "a.txt")
add("units row brackets", "Wavelength,n,k\n[nm],[],[]\n" + rows(W, N, K))
add("units row um", "lambda\tn\tk\num\t-\t-\n" + rows(W / 1000.0, N, K, sep="\t"), "a.txt")
add("units row %", "Wavelength,Reflectance\nnm,%\n" + rows(W, R * 100))
add("units row first", "nm,,\nwavelength,n,k\n" + rows(W, N, K))
add("index col no head", rows(np.arange(20), W, N, K))
add("index col 1 no head", rows(np.arange(1, 21), W, N, K, sep="\t"), "a.txt")
add("# col", "#,wavelength,n,k\n" + rows(np.arange(20), W, N, K))
add("sd cols", "wavelength_nm,n,n_err,k,k_err\n" + rows(W, N, N * 0.01, K, K * 0.01))
add("wl last", "n,k,wavelength (nm)\n" + rows(N, K, W))
add("wl last um bare", rows(N, K, W / 1000.0, sep=" "), "a.txt")
add("wl,n,wl,k headings", "wl,n,wl,k\n" + rows(W / 1000.0, N, W / 1000.0, K))
add("wl n nm k", "Wavelength (nm),n,Wavelength (nm),k\n" + rows(W, N, W, K))
add("blank k", "wl,n,k\n" + "\n".join(f"{w},1.5," for w in W), want=GLASS)
add("quoted", '"wl","n","k"\n' + "\n".join((f'"{w}","{n}","{k}"' for w, n, k in zip(W / 1000.0, N, K))))
add(
    "md table",
    "| nm | n | k |\n|---|---|---|\n" + "\n".join((f"| {w} | {n} | {k} |" for w, n, k in zip(W, N, K))),
    "a.md",
)
add("pipes", "nm | n | k\n" + rows(W, N, K, sep=" | "), "a.txt")
add("hash head comma", "#wavelength(nm),n,k\n" + rows(W, N, K))
add("% head", "% lambda(um) n k\n" + rows(W / 1000.0, N, K, sep=" "), "a.txt")
add("! head", "! nm n k\n" + rows(W, N, K, sep=" "), "a.txt")
add("; head um", "; wavelength(um) n k\n" + rows(W / 1000.0, N, K, sep=" "), "a.nk")
add("nk eV bare", rows(EV[::-1], N[::-1], K[::-1], sep=" "), "Au.nk")
add("nk um", rows(W / 1000.0, N, K, sep=" "), "Au.nk")
add("nk A", rows(W * 10, N, K, sep=" "), "Au.nk")
add("ev fallen bare full", rows(EV, N, K, sep=" "), "a.txt")
add("comment unit", "# units: eV\n" + rows(EV, N, K, sep=" "), "a.txt")
add("comment wl in um", "# Johnson & Christy, wavelength in um\n" + rows(W / 1000.0, N, K, sep=" "), "a.txt")
add("comment n k: lambda", "# lambda[nm]\tn\tk\n" + rows(W, N, K, sep="\t"), "a.dat")
add("R th=0", "nm,R(0)\n" + rows(W, R), want=R_GOLD)
add("R 0-1 no head", rows(W, R), want=R_GOLD)
add("R% no head", "Gold\n" + rows(W, R * 100, sep="\t"), "gold.txt", want=R_GOLD)
add(
    "%R cary multi",
    "Sample1,,Sample2,\nWavelength (nm),%R,Wavelength (nm),%R\n" + rows(W, R * 100, W, R * 50),
    want=REFUSED,
)
add("two samples", "Wavelength (nm),gold,silver\n" + rows(W, R * 100, R * 50), want=REFUSED)
add("perkin", "PE UV WinLab\n#DATA\n" + rows(W[::-1], R[::-1] * 100, sep="\t"), "a.asc", want=R_GOLD)
add("french", "longueur d'onde (nm);n;k\n" + rows(W, N, K, sep=";").replace(".", ","))
add(
    "french eps",
    "Longueur d’onde (nm);Indice de réfraction;Coefficient d'extinction\n" + rows(W, N, K, sep=";").replace(".", ","),
)
add(
    "spanish",
    "Longitud de onda (nm);índice de refracción;coeficiente de extinción\n" + rows(W, N, K, sep=";").replace(".", ","),
)
add("chinese", "波长(nm),折射率n,消光系数k\n" + rows(W, N, K))
add("chinese2", "波长（nm）,折射率,消光系数\n" + rows(W, N, K))
add("japanese", "波長[nm]\t屈折率\t消衰係数\n" + rows(W, N, K, sep="\t"), "a.txt")
add("german R", "Wellenlänge [nm];Reflexion [%]\n" + rows(W, R * 100, sep=";").replace(".", ","), want=R_GOLD)
add("russian", "Длина волны, нм;n;k\n" + rows(W, N, K, sep=";").replace(".", ","))
add("gbk", ("波长(nm)\t折射率\t消光系数\n" + rows(W, N, K, sep="\t")).encode("gbk"), "a.txt")
add("cp1251", ("Длина волны (нм);Показатель преломления;k\n" + rows(W, N, K, sep=";")).encode("cp1251"))
add(
    "latin1 german",
    ("Wellenlänge (nm);Brechungsindex n;Extinktionskoeffizient k\n" + rows(W, N, K, sep=";")).encode("latin-1"),
)
add("latin1 µm", ("Wavelength (µm);n;k\n" + rows(W / 1000.0, N, K, sep=";")).encode("latin-1"))
add("big5 ", ("波長(nm),n,k\n" + rows(W, N, K)).encode("big5"))
add("eucjp", ("波長(nm),n,k\n" + rows(W, N, K)).encode("euc_jp"))
add("korean", ("파장(nm),n,k\n" + rows(W, N, K)).encode("cp949"))
add("wvase um", "Gold\num\nNK\n" + rows(W / 1000.0, N, K, sep="\t"), "g.mat")
add("wvase A", "Gold\nAngstroms\nNK\n" + rows(W * 10, N, K, sep="\t"), "g.mat")
add("wvase ev nk", "Au (Palik)\nEV\nNK\n" + rows(EV, N, K, sep="\t"), "g.mat")
add("wvase nm e1e2", "Gold\nnm\nE1E2\n" + rows(W, E1, E2, sep="\t"), "g.mat")
add(
    "completeease",
    "CompleteEASE Exported Optical Constants\nMaterial: Gold\nWavelength (nm)\tn\tk\te1\te2\n"
    + rows(W, N, K, E1, E2, sep="\t"),
    "g.txt",
)
add("scout", "Au\nnm n k\n" + rows(W, N, K, sep=" "), "g.nk")
add(
    "sopra mat",
    "VERSION*1*\nFORMAT*1*\nPOINTS*20*\n"
    + "\n".join((f"DATA1*{i + 1}*{w:.8e}*{n:.8f}*{k:.8f}*" for i, (w, n, k) in enumerate(zip(W, N, K))))
    + "\nCOMMENT*x*\nEOF*\n",
    "AU.MAT",
)
add("json eV", json.dumps({"energy_eV": list(EV), "n": list(N), "k": list(K)}), "a.json")
add(
    "json unit",
    json.dumps({"material": "Au", "unit": "um", "wavelength": list(W / 1000.0), "n": list(N), "k": list(K)}),
    "a.json",
)
add("json nested", json.dumps({"Au": {"wl": list(W), "n": list(N), "k": list(K)}}), "a.json")
add("json records", json.dumps([{"wavelength_nm": w, "n": n, "k": k} for w, n, k in zip(W, N, K)]), "a.json")
add("json rows", json.dumps({"data": [[w, n, k] for w, n, k in zip(W, N, K)]}), "a.json")
add(
    "json pairs",
    json.dumps({"n": [[w, n] for w, n in zip(W / 1000.0, N)], "k": [[w, k] for w, k in zip(W / 1000.0, K)]}),
    "a.json",
)
add(
    "json lambda",
    json.dumps({"lambda": list(W / 1000.0), "epsilon_real": list(E1), "epsilon_imag": list(E2)}),
    "a.json",
)
add(
    "json spectra map",
    json.dumps({"name": "gold", "spectra": {str(int(w)): r for w, r in zip(W, R)}}),
    "a.json",
    want=R_GOLD,
)
add("wide R", "wavelength," + ",".join(f"{w}" for w in W) + "\nR," + ",".join(f"{r}" for r in R), want=R_GOLD)
add(
    "wide nk",
    "nm\t"
    + "\t".join(f"{w}" for w in W)
    + "\nn\t"
    + "\t".join(f"{r}" for r in N)
    + "\nk\t"
    + "\t".join(f"{r}" for r in K),
    "a.txt",
)
add(
    "wide bare",
    " ".join(f"{w}" for w in W) + "\n" + " ".join(f"{r}" for r in N) + "\n" + " ".join(f"{r}" for r in K),
    "a.txt",
)
add(
    "wide two",
    "Name,"
    + ",".join(f"{w:.0f}" for w in W)
    + "\ngold,"
    + ",".join(f"{r}" for r in R)
    + "\nhalf,"
    + ",".join(f"{r / 2}" for r in R),
    want=REFUSED,
)
add(
    "wide id",
    "ID,Name," + ",".join(f"R{w:.0f}" for w in W) + "\n1,gold," + ",".join(f"{r * 100}" for r in R),
    want=R_GOLD,
)
add(
    "cgats i1",
    'CGATS.17\nORIGINATOR "x"\nNUMBER_OF_FIELDS 22\nBEGIN_DATA_FORMAT\nSampleID SAMPLE_NAME '
    + " ".join(f"nm{w:.0f}" for w in W)
    + '\nEND_DATA_FORMAT\nNUMBER_OF_SETS 1\nBEGIN_DATA\n1 "gold a" '
    + " ".join(f"{r:.5f}" for r in R)
    + "\nEND_DATA\n",
    "a.txt",
    want=R_GOLD,
)
add(
    "ti3",
    "CTI3\n\nBEGIN_DATA_FORMAT\nSAMPLE_ID "
    + " ".join(f"SPEC_{w:.0f}" for w in W)
    + "\nEND_DATA_FORMAT\nBEGIN_DATA\n"
    + "A1 "
    + " ".join(f"{r * 100:.5f}" for r in R)
    + "\nEND_DATA\n",
    "a.ti3",
    want=R_GOLD,
)
add("coating", "! c\nMATE AU\n" + rows(W / 1000.0, N, -K, sep=" ") + "\nCOAT X\nAU 0.1\n", "coating.dat")
add(
    "pbrt",
    'Material "conductor" "spectrum eta" [ '
    + " ".join((f"{w} {n}" for w, n in zip(W, N)))
    + ' ] "spectrum k" [ '
    + " ".join((f"{w} {n}" for w, n in zip(W, K)))
    + " ]",
    "a.pbrt",
)
add(
    "mitsuba",
    '<bsdf type="roughconductor"><spectrum name="eta" value="'
    + ", ".join((f"{w}:{n}" for w, n in zip(W, N)))
    + '"/><spectrum name="k" value="'
    + ", ".join((f"{w}:{n}" for w, n in zip(W, K)))
    + '"/></bsdf>',
    "a.xml",
)
add("rii page", "n = 0.43\nk = 2.455\n", "a.txt", want=REFUSED)
add("rii page2", "Wavelength: 0.5876 µm\nn = 0.28\nk = 2.92\nR = 0.89\n", "a.txt", want=REFUSED)
add("trans", "400 0.21\n550 0.44\n700 0.91", "trans.txt", want=REFUSED)
add("T head", "nm,Transmittance\n400,.21\n550,.44\n700,.91", "x.csv", want=REFUSED)
add("k only", "nm,k\n" + rows(W, K), "x.csv", want=REFUSED)
add("k spd", "# Au.k\n" + rows(W, K, sep=" "), "Au.k.spd", want=REFUSED)
add("eta spd", rows(W, N + 3, sep=" "), "Au.eta.spd", want=REFUSED)
add("n only desc", "wl,n\n" + rows(W / 1000.0, N), "a.csv", want=REFUSED)
add("e1 only", "nm,e1\n" + rows(W, E1), "a.csv", want=REFUSED)
add("alpha only", "nm,absorption coefficient (1/cm)\n" + rows(W, K), "a.csv", want=REFUSED)
add("absorb comment", "# absorbance\n400 0.21\n550 0.44\n700 0.91", "x.txt", want=REFUSED)
add("psi delta", "nm,psi,delta\n" + rows(W, N * 10, K * 10), "x.csv", want=REFUSED)
add("R at 45", "nm,R (45°)\n" + rows(W, R), "x.csv", want=REFUSED)
add("trailing ;", rows(W, N, K, sep=";").replace("\n", ";\n"))
add("crcrlf", ("nm,n,k\n" + rows(W, N, K)).replace("\n", "\r\r\n").encode())
add("nbsp", "nm n k\n" + rows(W, N, K, sep=" "), "a.txt")
add("fixed", "   nm      n     k\n" + rows(W, N, K, sep="    "), "a.txt")
add("minus sign", "nm,n,k\n" + rows(W, N, -K).replace("-", "−"))
add(
    "exp D", "nm n k\n" + "\n".join((f"{w:.5e} {n:.5e} {k:.5e}".replace("e", "D") for w, n, k in zip(W, N, K))), "a.txt"
)
add("equals text", "n(λ) table\nλ=331.5 nm", "a.txt", want=REFUSED)
add("footer", "nm,n,k\n" + rows(W, N, K) + "\nNotes,,\nmade by me,,\n")
add("footer #", "nm,n,k\n" + rows(W, N, K) + "End of file\n")
add("nan rows", "nm,n,k\n" + rows(W, N, K) + "910,NaN,NaN\n930,,\n")
add("dup", "nm,n,k\n" + rows(W, N, K) + "892,0.17,5.663\n")
add("zero row", "nm,n,k\n0,0,0\n" + rows(W, N, K))
add("IR fault", "nm,n,k\n" + rows(W, N, K) + "2000,abc,3\n2100,-3,5\n")
add("ior head", "wavelength_um,ior,kappa\n" + rows(W / 1000.0, N, K))
add("Index n", "Wavelength (nm),Index n,Index k\n" + rows(W, N, K))
add("refr words", "Wavelength (nm), Refractive Index (n), Extinction Coefficient (k)\n" + rows(W, N, K))
add("n(Au)", "Wavelength (nm),n (Au),k (Au)\n" + rows(W, N, K))
add("Au n", "lambda_nm,Au_n,Au_k\n" + rows(W, N, K))
add("Specular", "Wavelength nm.,Specular Reflectance %\n" + rows(W, R * 100), want=R_GOLD)
add("Reflectance (%)", "Wavelength(nm)\tReflectance(%)\n" + rows(W, R * 100, sep="\t"), "a.txt", want=R_GOLD)
add(
    "jasco",
    "TITLE\tgold\nDATA TYPE\tREFLECTANCE\nXUNITS\tNANOMETERS\nYUNITS\t%R\nFIRSTX\t892\nLASTX\t331.5\n"
    "NPOINTS\t20\nXYDATA\n"
    + rows(W[::-1], R[::-1] * 100, sep="\t"),
    "a.txt",
    want=R_GOLD,
)
add(
    "jcamp",
    "##TITLE=gold\n##XUNITS=NANOMETERS\n##YUNITS=REFLECTANCE\n##XYPOINTS=(XY..XY)\n"
    + rows(W, R, sep=", ")
    + "##END=\n",
    "a.dx",
    want=R_GOLD,
)
add("filmetrics", "Filmetrics\nWavelength(nm), n, k\n" + rows(W, N, K, sep=", "), "a.fil")
add("matlab", "Au = [\n" + rows(W, N, K, sep=" ").replace("\n", ";\n") + "];", "a.m")
add("lum eps", "lambda(nm), Re(eps), Im(eps)\n" + rows(W, E1, E2))
add("csv space sep", "wavelength n k\n" + rows(W, N, K, sep=" "), "a.txt")
add("rii csv", "wl,n\n" + rows(W / 1000.0, N) + "\nwl,k\n" + rows(W / 1000.0, K))
add("rii csv nk", "wl,n\n" + rows(W / 1000.0, N) + "\nwl,k\n" + rows(W / 1000.0, K), "Au.nk")
add(
    "rii csv txt tab", "wl\tn\n" + rows(W / 1000.0, N, sep="\t") + "\nwl\tk\n" + rows(W / 1000.0, K, sep="\t"), "Au.txt"
)

# --- the open cases of the field that the above lacks ---
add("sep= of a spreadsheet", "sep=;\r\n" + comma("wavelength (nm);n;k\r\n" + rows(W, N, K, sep=";", end="\r\n")))
add("falling", "wavelength_nm,n,k\n" + rows(W[::-1], N[::-1], K[::-1]))
add("a double tab", "wavelength_nm\t\tn\t\tk\n" + rows(W, N, K, sep="\t\t"), "a.txt")
add("double slashes", "// gold\n// nm n k\n" + rows(W, N, K, sep=" "), "a.txt")
add("pandas wrote it", ",wavelength,n,k\n" + rows(np.arange(20.0), W, N, K))
add("trailing commas", "wavelength_nm,n,k,,\n" + rows(W, N, K, end=",,\n"))
add(
    "decimal commas in quotes",
    '"Wavelength (nm)","n","k"\n'
    + lines('"{}","{}","{}"', *([comma(f"{x:g}") for x in column] for column in (W, N, K))),
)
add("curly quotes", "“Wavelength (nm)”\t“n”\t“k”\n" + rows(W, N, K, sep="\t"), "a.txt")
add("Shift JIS", ("波長(nm),n,k\n" + rows(W, N, K)).encode("shift_jis"))
add("GBK", ("波长(nm),n,k\n" + rows(W, N, K)).encode("gbk"))
add("µ decoded twice", "Wavelength (Âµm),Index n,Index k\n".encode() + rows(W / 1e3, N, K).encode())
add("x, n, k", "x,n,k\n" + rows(W / 1e3, N, K))
add(
    "Ocean Optics",
    "Data from Gold.txt Node\n\nDate: Tue Jan 02 10:00:00 CET 2024\nNumber of Pixels in Spectrum: 20\n"
    ">>>>>Begin Spectral Data<<<<<\n" + rows(W, 100 * R, sep="\t") + ">>>>>End Spectral Data<<<<<\n",
    "a.txt",
    R_GOLD,
)
add("Shimadzu", '"File: a.spc"\n"Wavelength nm.","R%"\n' + rows(W[::-1], 100 * R[::-1]), "a.txt", R_GOLD)
add(
    "Cary",
    "gold mirror,\nWavelength (nm),%R\n"
    + rows(W[::-1], 100 * R[::-1])
    + "\ngold mirror\nCollection Time: 1/2/2024 10:00:00 AM\nInstrument                 Cary 5000\n",
    want=R_GOLD,
)
add("R and nk", "wavelength_nm n k R\n" + rows(W, N, K, R, sep=" "), "a.txt")
add("R and nk, bare", rows(W, N, K, R, sep=" "), "a.txt")
add("R above 1", "wavelength_nm,Reflectance\n400,0.9995\n500,1.0002\n700,1.0001\n", want=(1.0001, 1.0, 0.9995))
add("noise of k", "wavelength_nm,n,k\n400,1.5,-0.00002\n500,1.5,0.00001\n700,1.5,0\n", want=GLASS)
add("permittivity in a remark", "# wavelength_nm  eps1  eps2\n400 2.25 0\n500 2.25 0\n700 2.25 0\n", "a.txt", GLASS)
add("nk in nm to 20 µm", rows(W, N, K, sep=" ") + "2000 0.85 12.6\n5000 3.3 33\n10000 12 67\n20000 36 112\n", "a.nk")
add(
    "a table of a web page",
    "<table><tr><td>nm</td><td>n</td><td>k</td></tr>"
    + lines("<tr><td>{}</td><td>{}</td><td>{}</td></tr>", W, N, K, end="")
    + "</table>",
    "a.html",
)
add("half of an interleaved pair", '"spectrum eta" [ ' + lines("{} {}", W, N, end=" ") + "]", "a.txt", REFUSED)
add(
    "a glass",
    "CC a test\nNM TESTGLASS 2 517642 1.5168 64.17 0 1\nGC \nCD 1.03961212E+00 6.00069867E-03 2.31792344E-01 "
    "2.00179144E-02 1.01046945E+00 1.03560653E+02 0 0\nTD 0 0 0 0 0 0 20\nLD 3.1E-01 2.5E+00\n",
    "a.agf",
    (0.0419, 0.0424, 0.0433),
)
