# Facet & Film. "make help" lists what there is; every command may be repeated.
#
# PYTHON=  the Python to set up with (default: found by tools/find_python.sh)
# BPY=     the Blender to run on, 4.5 and 5.0 on Python 3.11, 5.1 and 5.2 on Python 3.13 (default: by Python)
# VENV=    the virtual environment (default: .venv, with BPY=5.2 .venv-5.2)
# TESTS=   what "make test" runs

PYTHON ?=
BPY ?=
empty :=
space := $(empty) $(empty)
series := $(subst $(space),.,$(wordlist 1,2,$(subst ., ,$(BPY))))
VENV ?= .venv$(series:%=-%)
TESTS ?= tests/unit tests/render tests/package
# The site needs no Blender and has an environment of its own.
SITE ?= .venv-site
RUN = $(VENV)/bin/python
# The oldest Blender supported builds the assets: a newer one opens its files, it opens no newer one's.
OLDEST ?= .venv-4.5
# A Blender with a display, for "make test-window": a path or a command.
BLENDER ?=
# What "make smoke" runs: the zip, every preset and realisation, the groups.
SMOKE = tests/package tests/render/test_every_preset.py tests/render/test_groups.py tests/render/test_materials.py
SUPPORTED = 4.5 5.0 5.1 5.2

.DEFAULT_GOAL := help
.PHONY: help setup lint groups library demo figures test verify smoke matrix bench package assets test-window \
	setup-site site test-site release

help:
	@echo "make demo      bake copper, gold and vinyl, render the two vases into out/"
	@echo "make figures   every picture and plot of the documents; FIGURES=\"vases_6 watch\" makes only these"
	@echo "make test      run the tests; make test BPY=5.2 (or 4.5, 5.0, 5.1) for another Blender"
	@echo "make test-window BLENDER=/path/to/blender   click through the extension in a real window"
	@echo "make matrix    run the tests and the verification on Blender 4.5, 5.0, 5.1 and 5.2"
	@echo "make verify    render every model and realisation, hold them against the formulas, write out/verification.html"
	@echo "make bench     measure time, noise and sizes, write out/bench.json and docs/benchmarks.md"
	@echo "make package   build and validate dist/facet_film-<version>.zip"
	@echo "make site      build the documents and the catalogue as pages that need no server, dist/site/; make test-site tests it"
	@echo "make release   build all that a release holds, for a static host, into dist/release/"
	@echo "make lint      hold the sources to the rules in pyproject.toml"
	@echo "make groups    build the node groups, where their sources have changed; make library the assets too"
	@echo "make assets    build everything that is made of data and sources: search index, groups, previews, documents"
	@echo "make setup     only make the environment that the others use ($(VENV))"

setup:
	@python=$$(PYTHON="$(PYTHON)" VENV="$(VENV)" sh tools/find_python.sh $(BPY)) \
	&& "$$python" tools/setup_venv.py --venv "$(VENV)" $(BPY:%=--bpy %)

lint: setup
	$(RUN) -m ruff check .

# Built with the first command that needs them, and again where a stamp says that their sources have changed.
groups: setup
	@$(RUN) tools/build_groups.py

library: groups
	@$(RUN) tools/build_assets.py

demo: groups
	$(RUN) -m demo_blend.vases --out out

# The comparison of two Blenders runs on the newest one beside the default; without its Python it is left out and said so.
figures: groups
	-@$(MAKE) --no-print-directory setup BPY=5.2 VENV=.venv-5.2
	$(RUN) -m demo_blend.figures --scenes out $$([ -x .venv-5.2/bin/python ] && echo --other .venv-5.2/bin/python) $(FIGURES)

test: library
	$(RUN) -m pytest $(TESTS)

test-window:
	@[ -n "$(BLENDER)" ] || { echo "Say which Blender to open a window of: make test-window BLENDER=/path/to/blender"; exit 2; }
	@$(MAKE) --no-print-directory setup
	$(RUN) tests/window/run.py --blender "$(BLENDER)"

smoke: library
	$(RUN) -m pytest $(SMOKE)

matrix:
	@for blender in $(SUPPORTED); do $(MAKE) test verify BPY=$$blender || exit 1; done

verify: groups
	@mkdir -p out
	$(RUN) -m addon verify -o out/verification$(series:%=-%).html --json out/verification$(series:%=-%).json

bench: library
	$(RUN) -m tests.bench.bench $$([ -x $(OLDEST)/bin/python ] && echo --other $(OLDEST)/bin/python)

package: library
	$(RUN) tools/package.py --out dist

setup-site:
	@python=$$(PYTHON="$(PYTHON)" VENV="$(SITE)" sh tools/find_python.sh) \
	&& "$$python" tools/setup_venv.py --venv "$(SITE)" --site

site: setup-site
	$(SITE)/bin/python tools/build_data.py
	$(SITE)/bin/python tools/build_site.py --data dist/catalogue.json

# In Chromium; on Debian: apt-get install chromium chromium-driver. What all tests share is Blender's, and not theirs.
test-site: setup-site
	$(SITE)/bin/python -m pytest tests/site --confcutdir=tests/site

release: package site
	$(RUN) tools/release.py

assets:
	$(MAKE) setup BPY=4.5 VENV=$(OLDEST)
	$(OLDEST)/bin/python tools/build_search.py
	$(OLDEST)/bin/python tools/build_clear_facts.py
	$(OLDEST)/bin/python tools/build_film_facts.py
	$(OLDEST)/bin/python tools/build_groups.py --again --record
	$(OLDEST)/bin/python tools/render_previews.py
	$(OLDEST)/bin/python tools/build_assets.py --again
	$(OLDEST)/bin/python tools/build_catalogue.py
	$(OLDEST)/bin/python tools/build_parameters.py
