"""Khronos' glTF validator, by Node: what it says of a file."""

import json
import shutil
import subprocess
from pathlib import Path

__all__ = ["why_not", "validated"]

VERSION = "2.0.0-dev.3.10"
FOLDER = Path(__file__).resolve().parents[1] / "out" / "gltf-validator"
SCRIPT = """
const fs = require("fs"), validator = require(process.argv[1]);
validator.validateBytes(new Uint8Array(fs.readFileSync(process.argv[2])), {maxIssues: 100})
  .then(report => console.log(JSON.stringify(report.issues)));
"""


def why_not():
    """Why there is no validator here, or an empty text; it is installed by npm where that is to be had."""
    if shutil.which("node") is None or shutil.which("npm") is None:
        return "Node and npm are not installed"
    if not (FOLDER / "node_modules" / "gltf-validator").exists():
        FOLDER.mkdir(parents=True, exist_ok=True)
        done = subprocess.run(["npm", "install", "--prefix", str(FOLDER), "--no-save", f"gltf-validator@{VERSION}"],
                              capture_output=True, text=True)
        if done.returncode:
            return f"npm could not install gltf-validator: {done.stderr.strip()[-200:]}"
    return ""


def validated(file):
    """{"numErrors": …, "messages": […]} of a file."""
    done = subprocess.run(["node", "-e", SCRIPT, str(FOLDER / "node_modules" / "gltf-validator"), str(file)],
                          capture_output=True, text=True, check=True)
    return json.loads(done.stdout)
