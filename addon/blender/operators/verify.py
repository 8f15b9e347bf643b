"""The verification, run in a second Blender so that the open file and the window stay free."""

from pathlib import Path

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

from ...errors import FacetFilmError

__all__ = ["CLASSES", "progress"]

EXTENSION = __package__.rsplit(".", 3)[0]
REPORT = "verification.html"
LOOK_EVERY = 0.3
_state = {"process": None, "line": ""}


def progress():
    """What the verification says at the moment, or "" where none runs."""
    return _state["line"] if _state["process"] is not None else ""


def command(path, device):
    """The command line of the second Blender."""
    return [bpy.app.binary_path, "--background", "--addons", EXTENSION, "--command", "facet_film", "verify",
            "--output", str(path), "--device", device]


def report_path():
    """Where the report is kept: in the extension's own folder of the user's profile."""
    try:
        folder = bpy.utils.extension_path_user(EXTENSION, create=True)
    except ValueError:  # a checkout that is not installed has no such folder
        folder = bpy.app.tempdir
    return Path(folder) / REPORT


class Log:
    """The file that the second Blender writes what it says into: the timer reads it, and no thread has to wait."""

    def __init__(self, path):
        self.path = path

    def lines(self):
        """What was said so far; a line that is not whole yet is left for later."""
        whole, _, _ = self.path.read_text(encoding="utf-8", errors="replace").rpartition("\n")
        return [line.strip() for line in whole.splitlines() if line.strip()]


class FACET_FILM_OT_verify(bpy.types.Operator):
    """Render every model and realisation in a second Blender, compare the pixels with the published formulas, \
and open the report. Takes one to five minutes; Esc stops it"""

    bl_idname = "facet_film.verify"
    bl_label = "Verify Against the Formulas"
    bl_options = {"REGISTER"}

    device: bpy.props.EnumProperty(
        name="Device", description="What to render the probes on",
        items=(("CPU", "CPU", "The processor"),
               ("GPU", "GPU", "The devices that are switched on under System, Cycles Render Devices")))

    @classmethod
    def poll(cls, _context):
        """Only in an installed Blender, and one at a time."""
        if not bpy.app.binary_path:
            cls.poll_message_set(rpt_("Runs in a second Blender, which Blender as a Python module lacks: "
                                      "run python -m addon verify"))
            return False
        if _state["process"] is not None:
            cls.poll_message_set(rpt_("A verification is running"))
            return False
        return True

    def execute(self, _context):
        """From a script: wait for the result."""
        try:
            self._process, self._path, self._log = self._start()
        except FacetFilmError as error:
            self.report({"ERROR"}, error.said(rpt_))
            return {"CANCELLED"}
        self._process.wait()
        return self._tell(self._process.returncode, self._log.lines(), self._path)

    def invoke(self, context, _event):
        """From a button: watch the second Blender while the user goes on."""
        try:
            self._process, self._path, self._log = self._start()
        except FacetFilmError as error:
            self.report({"ERROR"}, error.said(rpt_))
            return {"CANCELLED"}
        _state.update(process=self._process, line=rpt_("Verifying: starting a second Blender …"))
        self._timer = context.window_manager.event_timer_add(LOOK_EVERY, window=context.window)
        context.window_manager.modal_handler_add(self)
        self._show(context)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        """Show how far it is; Esc stops it."""
        if event.type == "ESC":
            self._process.terminate()
            self._process.wait()
            self._end(context)
            self.report({"WARNING"}, rpt_("The verification was stopped; there is no report"))
            return {"CANCELLED"}
        if event.type != "TIMER":
            return {"PASS_THROUGH"}
        finished = self._process.poll() is not None
        said = self._log.lines()
        if said:
            _state["line"] = rpt_("Verifying {:s}").format(said[-1])
        self._show(context)
        if not finished:
            return {"PASS_THROUGH"}
        self._end(context)
        return self._tell(self._process.returncode, self._log.lines(), self._path)

    def cancel(self, context):
        """Blender closes the window or file: end the second one too."""
        self._process.terminate()
        self._end(context)

    def _start(self):
        import subprocess  # here, as enabling the extension waits for what stands at the top
        path, log = report_path(), Log(Path(bpy.app.tempdir) / "facet_film_verification.txt")
        try:
            with open(log.path, "wb") as said:
                return subprocess.Popen(command(path, self.device), stdin=subprocess.DEVNULL, stdout=said,
                                        stderr=subprocess.STDOUT), path, log
        except OSError as error:
            raise FacetFilmError("A second Blender could not be started: {why}", why=error.strerror or error) from None

    def _show(self, context):
        context.workspace.status_text_set(progress() + rpt_("   (Esc stops)"))
        for window in context.window_manager.windows:
            for area in window.screen.areas:
                if area.type == "PREFERENCES":
                    area.tag_redraw()

    def _end(self, context):
        _state.update(process=None, line="")
        context.window_manager.event_timer_remove(self._timer)
        context.workspace.status_text_set(None)

    def _tell(self, status, said, path):
        """Report the first line of the report, and open it."""
        verdict = next((line for line in reversed(said) if line.startswith(("Green", "Not green"))), None)
        if verdict is None:
            reason = said[-1] if said else rpt_("it said nothing")
            self.report({"ERROR"}, rpt_("The second Blender ended with status {:d}: {:s}").format(status, reason))
            return {"CANCELLED"}
        self.report({"INFO"} if status == 0 else {"ERROR"}, verdict)
        if not bpy.app.background:
            bpy.ops.wm.url_open(url=path.as_uri())
        return {"FINISHED"}


CLASSES = (FACET_FILM_OT_verify,)
