#!/bin/sh
# Prints the Python to set up with: find_python.sh [BPY]
#
# BPY is a Blender version such as 5.2 or 5.2.3, and names the Python that its bpy is built for; without
# it 3.11 and 3.13 both do. PYTHON, where set, is taken or refused. Otherwise the first that runs and can
# make a virtual environment: the one in VENV, python3, python3.13, python3.11, those of pyenv.

here=$(dirname "$0")
wanted="3.13 3.11"
if [ -n "$1" ]; then
    wanted=$(sed -n 's/^-r python-\(.*\)\.txt$/\1/p' "$here"/../requirements/bpy-"$1"*.txt 2>/dev/null | sort -u)
    if [ -z "$wanted" ]; then
        known=$(cd "$here/../requirements" && ls bpy-*.txt | sed 's/^bpy-\(.*\)\.txt$/\1/' | tr '\n' ' ')
        echo "BPY=$1 is not a Blender that this checkout pins; choose one of: $known" >&2
        exit 1
    fi
fi

# A name on the PATH proves nothing (pyenv leaves stubs that only fail), so each candidate is run.
usable() {
    "$1" -c 'if True:
        import sys, ensurepip, venv
        if "%d.%d" % sys.version_info[:2] not in sys.argv[1:]:
            sys.exit(1)
        print(sys.executable)' $wanted 2>/dev/null
}

if [ -n "$PYTHON" ]; then
    usable "$PYTHON" && exit 0
    echo "PYTHON=$PYTHON does not do: it must run, be Python $(echo $wanted | sed 's/ / or /g')" \
         "and have the modules venv and ensurepip." >&2
    exit 1
fi

[ -n "$VENV" ] && [ -x "$VENV/bin/python" ] && usable "$VENV/bin/python" && exit 0
for name in python3 python3.13 python3.11; do
    usable "$name" && exit 0
done
if command -v pyenv >/dev/null 2>&1; then
    for version in $wanted; do
        for path in "$(pyenv root)"/versions/"$version"*/bin/python"$version"; do
            usable "$path" && exit 0
        done
    done
fi

echo "No Python $(echo $wanted | sed 's/ / or /g') with the modules venv and ensurepip was found:" \
     "install one (on Debian also its -venv package) or name it with PYTHON=/path/to/python." >&2
exit 1
