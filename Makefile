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
RUN = $(VENV)/bin/python

.DEFAULT_GOAL := help
.PHONY: help setup demo test package

help:
	@echo "make demo      bake copper, gold and vinyl, render the two vases into out/"
	@echo "make test      run the tests; make test BPY=5.2 (or 4.5, 5.0, 5.1) for another Blender"
	@echo "make package   build and validate dist/facet_film-<version>.zip"
	@echo "make setup     only make the environment that the others use ($(VENV))"

setup:
	@python=$$(PYTHON="$(PYTHON)" VENV="$(VENV)" sh tools/find_python.sh $(BPY)) \
	&& "$$python" tools/setup_venv.py --venv "$(VENV)" $(BPY:%=--bpy %)

demo: setup
	$(RUN) -m demo_blend.vases --out out

test: setup
	$(RUN) -m pytest $(TESTS)

package: setup
	$(RUN) tools/package.py --out dist
