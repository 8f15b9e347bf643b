"""``python -m addon``: the door for shells."""

import sys

from .cli import main

sys.exit(main(sys.argv[1:]))
