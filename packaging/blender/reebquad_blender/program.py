# SPDX-License-Identifier: GPL-3.0-or-later
"""The program as a process: where it is, what it is asked for, how far it is. Knows nothing of Blender."""

import functools
import json
import os
import queue
import re
import shutil
import signal
import subprocess
import threading

STAGE = re.compile(r"^(?P<stage>.*) \([0-9.]+ s\)$")
EXIT_IN_PART, EXIT_INTERRUPTED = 6, 130


def find(path=""):
    """The program's path: the one that is given, else the first on PATH; empty where there is none."""
    path = os.path.expanduser(path)
    if path:
        return path if os.path.isfile(path) and os.access(path, os.X_OK) else ""
    return shutil.which("reebquad") or ""


@functools.lru_cache(maxsize=4)
def options_of(path):
    """The options that `run` of this program has."""
    shown = subprocess.run([path, "run", "--help"], capture_output=True, text=True, check=False).stdout
    return frozenset(re.findall(r"--[a-z-]+", shown))


class Run:
    """`reebquad run` under way in a folder of files. `poll()` tells whether it has ended."""

    def __init__(self, path, folder, arguments):
        self.quads = os.path.join(folder, "quads.obj")
        self.report_file = os.path.join(folder, "report.json")
        self.stage = ""
        self.sentences = []
        self._lines = queue.Queue()
        command = [
            path,
            "run",
            os.path.join(folder, "surface.obj"),
            "-o",
            self.quads,
            "--report",
            self.report_file,
        ]
        self._process = subprocess.Popen(
            command + arguments,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
            errors="replace",
        )
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self):
        for line in self._process.stderr:
            self._lines.put(line.rstrip("\n"))

    def poll(self):
        """True once the program has ended and all that it said is read."""
        ended = self._process.poll() is not None and not self._reader.is_alive()
        while not self._lines.empty():
            line = self._lines.get()
            stage = STAGE.match(line)
            if stage:
                self.stage = stage["stage"]
            elif line:
                self.sentences.append(re.sub(r"^reebquad: (\S*surface\.obj: )?", "", line))
        return ended

    def wait(self):
        self._process.wait()
        self._reader.join()
        self.poll()

    def cancel(self):
        """Ends the program as Ctrl-C does; nothing is written."""
        if self._process.poll() is None:
            self._process.send_signal(signal.SIGINT if os.name == "posix" else signal.SIGTERM)
            try:
                self._process.wait(timeout=10)
            except subprocess.TimeoutExpired:
                self._process.kill()

    def has_quads(self):
        return self._process.returncode in (0, EXIT_IN_PART) and os.path.isfile(self.quads)

    def failure(self):
        """Why there are no quads, in a sentence."""
        if self._process.returncode == EXIT_INTERRUPTED:
            return "cancelled"
        return self.sentences[0] if self.sentences else f"reebquad ended with {self._process.returncode}"

    def report(self):
        with open(self.report_file, encoding="utf-8") as file:
            return json.load(file)

    def warnings(self):
        """Sentences of the certificate."""
        certificate = self.report()["certificate"] or {}
        return [warning["text"] for warning in certificate.get("warnings", [])]
