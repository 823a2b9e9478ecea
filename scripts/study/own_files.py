# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""What a study may read, and what it may replace.

It reads regular files alone, up to a size: a pipe would block, a device never ends. It replaces its own files alone, told by their content: no
links, nor what these lead to, nor files of the same name that no study wrote. Whatever else is there raises StudyError, which names it.
"""
import contextlib
import csv
import io
import json
import os
import pathlib
import re
import stat

LARGEST = 16 * 2**20  # bytes of a study file, as of a case file
LARGEST_TABLE = 2**30
HEAD = 2**18  # bytes of a file that tell what it is
GENERATOR = '<meta name="generator" content="voussoir study">'
OLD_PAGE = re.compile(r"<p>\d+ of \d+ runs done.*core-hours\.")  # of a page without GENERATOR
OF_A_RUN = (".job", "identity", "version", "sessions.json", "done.json", "program.log", "run.h5", "stills.png", "report.html")


class StudyError(Exception):
    pass


def bytes_of(path, wanted, most=LARGEST):
    """The bytes of a regular file. wanted: what it should be, for the message."""
    try:
        refuse_irregular(path, os.stat(path).st_mode, wanted)  # before it is opened, which a device may notice
        number = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)
        with open(number, "rb") as file:
            is_now = os.fstat(number)
            refuse_irregular(path, is_now.st_mode, wanted)
            if is_now.st_size > most:
                raise StudyError(f"{path}: has {is_now.st_size} bytes; {wanted} may have {most // 2**20} MB")
            data = file.read(most + 1)
    except OSError as error:
        raise StudyError(f"{path}: {error.strerror}; wanted {wanted}") from error
    if len(data) > most:
        raise StudyError(f"{path}: does not end; {wanted} may have {most // 2**20} MB")
    return data


def refuse_irregular(path, mode, wanted):
    if not stat.S_ISREG(mode):
        raise StudyError(f"{path}: is {'a folder' if stat.S_ISDIR(mode) else 'not a regular file'}; wanted {wanted}")


def text_of(path, wanted, most=LARGEST):
    """The text of a regular file, its lines ended by "\\n"."""
    try:
        return io.TextIOWrapper(io.BytesIO(bytes_of(path, wanted, most)), encoding="utf-8").read()
    except ValueError as error:  # of UTF-8
        raise StudyError(f"{path}: {error}; wanted {wanted}") from error


def kind_of(path):
    """What is there, itself and not what a link leads to: "", "a file", "a folder", or what is neither."""
    try:
        mode = os.lstat(path).st_mode
    except FileNotFoundError:
        return ""
    except OSError as error:
        raise StudyError(f"{path}: {error.strerror}") from error
    kinds = {stat.S_IFREG: "a file", stat.S_IFDIR: "a folder", stat.S_IFLNK: "a symbolic link", stat.S_IFIFO: "a pipe", stat.S_IFSOCK: "a socket"}
    return kinds.get(stat.S_IFMT(mode), "a device")


def refuse_other(path, wanted="a file"):
    """Refuses whatever is there already, unless it is a file, or a folder where one is wanted."""
    found = kind_of(path)
    if found not in ("", wanted):
        raise StudyError(f"{path}: is {found}, which a study neither replaces nor follows; remove it, or give another folder by -o")


def head_of(path):
    with open(path, "rb") as file:
        return file.read(HEAD).decode("utf-8-sig", "replace")


def is_plan(path):
    text = path.read_text(encoding="utf-8", errors="replace")
    try:
        found = json.loads(text)
    except RecursionError:
        return False
    except ValueError:  # an earlier version did not write it at once: a kill may have left a part
        return text.startswith('{\n "title": ')
    return isinstance(found, dict) and all(key in found for key in ("voussoir", "threads", "runs"))


def is_table(path):
    try:
        names = next(csv.reader(io.StringIO(head_of(path), newline="")), [])
    except csv.Error:
        return False
    return names[:2] == ["run", "case"] and "status" in names


def is_main_table(path):
    names = head_of(path).partition("\n")[0].rstrip("\r").split(",")
    return names[0] == "run" and "status" in names


def is_page(path):
    head = head_of(path)
    return GENERATOR in head or OLD_PAGE.search(head) is not None


def is_drawing(path):
    return "<svg" in head_of(path)


OWN = {"plan.json": (is_plan, "plan"), "table.csv": (is_table, "table"), "main.csv": (is_main_table, "table"), "index.html": (is_page, "page")}


def check_outputs(folder, plots, runs=()):
    """Refuses a folder in which the study would replace what is not its own. plots: their paths in the folder. runs: their names."""
    nearest = next(path for path in (folder, *folder.parents) if os.path.lexists(path))
    if not nearest.is_dir():
        raise StudyError(f"{nearest}: is no folder; give another folder by -o")
    refuse_other(folder / ".study")
    for name, (is_own, what) in {**OWN, **{name: (is_drawing, "drawing") for name in plots}}.items():
        path = folder / name
        if path.parent != folder:
            refuse_other(path.parent, "a folder")
        refuse_other(path)
        try:
            others = path.exists() and path.stat().st_size > 0 and not is_own(path)
        except OSError as error:
            raise StudyError(f"{path}: {error.strerror}, so it is not replaced; give another folder by -o") from error
        if others:
            raise StudyError(f"{path}: is no {what} of a study, so it is not replaced; give another folder by -o")
    for name in ("runs", ".snakemake"):
        refuse_other(folder / name, "a folder")
    there = set(os.listdir(folder / "runs")) if (folder / "runs").is_dir() else set()
    for name in runs:
        if name in there:
            check_run(folder / "runs" / name)


def check_run(folder):
    """The same of the folder of a run."""
    refuse_other(folder, "a folder")
    for name in OF_A_RUN:
        refuse_other(folder / name)
    if (folder / "run.h5").exists() and not any((folder / name).exists() for name in OF_A_RUN[:4]):
        raise StudyError(f"{folder}: holds a run that no study made, so it is not replaced; give another folder by -o")


def opened(path, flags):
    """Opens a regular file, which is made if there is none; never what a link leads to. Returns its number."""
    try:
        number = os.open(path, flags | os.O_CREAT | os.O_NOFOLLOW | os.O_NONBLOCK, 0o666)
    except OSError as error:
        refuse_other(path)
        raise StudyError(f"{path}: {error.strerror}") from error
    if not stat.S_ISREG(os.fstat(number).st_mode):
        os.close(number)
        refuse_other(path)
    return number


@contextlib.contextmanager
def replacing(path, ending=None):
    """A file to write, which takes the place of `path` at the end: complete, or not at all. ending: of its name until then; default: one of this
    process."""
    path = pathlib.Path(path)
    temporary = path.with_name(path.name + (ending or f".{os.getpid()}.tmp"))
    refuse_other(path)
    refuse_other(temporary)
    temporary.unlink(missing_ok=True)
    try:
        with open(os.open(temporary, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o666), "w", newline="", encoding="utf-8") as file:
            yield file
        refuse_other(path)
        temporary.replace(path)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise
