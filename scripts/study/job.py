# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""One run of a study, from wherever it is to its end. usage: job.py PLAN RUN   (in the study's folder)

Starting it again is harmless at any time: a run that has ended is left alone, one with a checkpoint is resumed, and one that is still at
work, because only the study was killed, is waited for. Ends with runs/RUN/done.json, or with the exit code of the program.
"""
import datetime
import fcntl
import json
import os
import pathlib
import signal
import subprocess
import sys
import time

import h5py

import own_files

RENDER = pathlib.Path(__file__).resolve().parent.parent / "render.py"
DONE, NUMERICAL_FAILURE = 0, 1  # exit codes of the program


def write(path, text):
    """Writes a complete file, or none."""
    with own_files.replacing(path, ".tmp") as file:  # one name, since one process alone works on a run
        file.write(text)


def take_turn(folder):
    """Waits until no other process works on the run. The program inherits the lock, which therefore outlasts this script."""
    lock = own_files.opened(folder / ".job", os.O_RDWR)
    fcntl.flock(lock, fcntl.LOCK_EX)
    return lock


def attributes(folder, group):
    """Attributes of a run's results; empty if these are missing or unreadable."""
    try:
        with h5py.File(folder / "run.h5") as file:
            return dict(file[group].attrs)
    except (OSError, KeyError):
        return {}


def finished(folder):
    return bool(attributes(folder, "summary").get("finished"))


class Sessions:
    """sessions.json: when the program worked on the run, for how long, with how many threads; including killed sessions."""

    def __init__(self, folder):
        self.folder, self.path = folder, folder / "sessions.json"
        self.all = json.loads(self.path.read_text()) if self.path.exists() else []

    def close(self, wall_clock, code):
        self.all[-1].update(wall_clock=wall_clock, exit=code)
        write(self.path, json.dumps(self.all))

    def close_killed(self):
        """Closes a killed session with the duration recorded in its last results, a lower bound."""
        if self.all and self.all[-1]["wall_clock"] is None:
            self.close(self.known_time(self.all[-1]["started"]), None)

    def known_time(self, started):
        there = attributes(self.folder, "provenance")
        return float(there["wall_clock"]) if there.get("started", "") >= started else 0.0

    def open(self, threads):
        started = datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")  # as in /provenance
        self.all.append({"started": started, "threads": threads, "wall_clock": None, "exit": None})
        write(self.path, json.dumps(self.all))


def command(plan, run, folder):
    rest = ["-j", str(plan["threads"]), "--checkpoint-every", str(plan["checkpoint_every"]), "--quiet"]
    if any(folder.glob("checkpoint-[0-9]*.h5")):
        return [plan["voussoir"], "resume", str(folder), *rest]
    overrides = [word for o in run["set"] for word in ("--set", o)]
    return [plan["voussoir"], "run", run["case"], *overrides, "-o", str(folder), "--overwrite", *rest]


def go_on(words, folder, sessions, threads, lock):
    """Starts or resumes the program; returns its exit code."""
    sessions.close_killed()
    sessions.open(threads)
    start = time.monotonic()
    with open(own_files.opened(folder / "program.log", os.O_WRONLY | os.O_APPEND), "a") as log:
        program = subprocess.Popen(words, stdout=log, stderr=log, pass_fds=[lock])
        for number in (signal.SIGINT, signal.SIGTERM):  # the program saves a checkpoint and stops; this script must outlive it
            signal.signal(number, lambda n, _: program.send_signal(n))
        code = program.wait()
    sessions.close(time.monotonic() - start, code)
    return code


def draw(plan, folder):
    """Draws pictures and page of a run. Failure to draw does not invalidate the run."""
    if plan["stills"]:
        words = [sys.executable, str(RENDER), str(folder), "-o", str(folder / "stills.png"), "--time", *map(str, plan["stills"])]
        subprocess.run(words, stdout=subprocess.DEVNULL, check=False)
    if plan["report"]:
        subprocess.run([plan["voussoir"], "report", str(folder), "--overwrite"], stdout=subprocess.DEVNULL, check=False)


def status_of(code, folder):
    """Status of a finished run; None if unfinished. Without results, the run failed for other reasons than numerical ones."""
    if code == NUMERICAL_FAILURE and (folder / "run.h5").exists():
        return "numerical failure"
    return "done" if code == DONE else None


def main():
    plan = json.loads(pathlib.Path(sys.argv[1]).read_text())
    run = next(r for r in plan["runs"] if r["name"] == sys.argv[2])
    folder = pathlib.Path("runs") / run["name"]
    folder.mkdir(parents=True, exist_ok=True)
    lock = take_turn(folder)
    if (folder / "done.json").exists():
        return DONE
    write(folder / "identity", run["identity"] + "\n")
    write(folder / "version", plan["version"] + "\n")
    sessions = Sessions(folder)
    code = DONE if finished(folder) else go_on(command(plan, run, folder), folder, sessions, plan["threads"], lock)
    status = status_of(code, folder)
    if status is None:
        log = (folder / "program.log").read_text().splitlines()
        print(f"{run['name']}: {log[-1] if log else 'no message'} (exit code {code}; {folder}/program.log)", file=sys.stderr)
        return code if code > 0 else 128 - code
    sessions.close_killed()
    if code == DONE:
        draw(plan, folder)
    write(folder / "done.json", json.dumps({"status": status}) + "\n")
    print(f"{run['name']}: {status}", file=sys.stderr)
    return DONE


if __name__ == "__main__":
    try:
        sys.exit(main())
    except own_files.StudyError as error:
        sys.exit(str(error))
