# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Includes respect what docs/architecture.md states: the floors of filters/core, of the helpers in
filters/vtk/private and of apps/winding, and who may know whom in filters.

Usage: arrows_test.py <root of the repository>. Prints a table of all arrows between rooms, then one
line for each fault, and fails if there is any.
"""

import pathlib
import re
import sys

INCLUDE = re.compile(r'^\s*#\s*include\s+(["<])([^">]+)[">]', re.MULTILINE)
SECTION = re.compile(r"^The rooms of `([\w/]+)`", re.MULTILINE)
FLOOR_ROW = re.compile(r"^\| (\d+) \| `(\w+)` \|", re.MULTILINE)
VTK_HEADER = re.compile(r"vtk\w*\.h")

CORE = "filters/core"
PROGRAM = "apps/winding"
# Headers without a class.
MACROS = {"vtkWindingABINamespace.h"}
CLASSES = ("filters/vtk", "filters/io")
HELPERS = "filters/vtk/private"
# Helpers without rooms, and the folders of filters that each may include.
SMALL_HELPERS = {"filters/io/private": {"private", "files", "messages", "pipeline"},
                 "filters/pipeline": {"pipeline", "messages"}}
# Folders of filters that are plain C++, besides the core, each with the ones that it includes.
PLAIN = {"files": (), "messages": (), "c": ("files", "messages")}
LIST_OF_OPTIONS = "Options.def"  # lies in filters, for helpers and the program


def floors_of_rooms(page):
    """For each folder that the page divides into rooms, the floor of each of its rooms."""
    pieces = SECTION.split(page.read_text())
    return {
        folder: {room: int(floor) for floor, room in FLOOR_ROW.findall(text)}
        for folder, text in zip(pieces[1::2], pieces[2::2])
    }


def includes_of(path):
    """Pairs of a bracket and a name."""
    return INCLUDE.findall(path.read_text())


def circles(needs):
    """Groups of units that need each other; a unit is a header together with its source."""
    faults, done, path = [], set(), []

    def visit(unit):
        if unit in path:
            faults.append(" -> ".join(path[path.index(unit) :] + [unit]))
            return
        if unit in done:
            return
        path.append(unit)
        for needed in sorted(needs.get(unit, ())):
            visit(needed)
        path.pop()
        done.add(unit)

    for unit in sorted(needs):
        visit(unit)
    return faults


class Rooms:
    """A folder whose subfolders are rooms, the arrows between them, and the faults."""

    def __init__(self, root, folder, floors, at_the_top=()):
        self.folder, self.floors = root / folder, floors
        self.faults, self.arrows, self.needs = [], {}, {}
        found = {path.name for path in self.folder.iterdir() if path.is_dir()}
        for room in sorted(found ^ set(floors)):
            self.fault(f"a folder {room} and a row of the table should have this name")
        self.files = []  # pairs of a path and its room; None above all rooms
        for path in sorted(self.folder.rglob("*")):
            if path.suffix in (".h", ".cxx"):
                name = path.relative_to(self.folder)
                if len(name.parts) == 2:
                    self.files.append((path, name.parts[0]))
                elif str(name) in at_the_top:
                    self.files.append((path, None))
                else:
                    self.fault(f"{name} lies in no room")
        if not self.files:
            self.fault("there are no sources")

    def fault(self, text):
        self.faults.append(f"{self.folder.name}: {text}")

    def has(self, included):
        return (self.folder / included).is_file()

    def add_arrow(self, path, room, included):
        name, other = path.relative_to(self.folder), pathlib.PurePath(included)
        unit, needed = str(name.with_suffix("")), str(other.with_suffix(""))
        if other.parts[0] != room:
            self.arrows.setdefault((room, other.parts[0]), []).append(f"{name} -> {included}")
        if unit != needed:
            self.needs.setdefault(unit, set()).add(needed)

    def check(self):
        print(f"\n{self.folder.name}: includes, from room, to room")
        for (room, other), names in sorted(self.arrows.items(), key=str):
            print(f"{len(names):8}  {room or '(top)':9}  {other}")
            if room and self.floors.get(other, 99) >= self.floors.get(room, 0):
                for name in names:
                    self.fault(f"{name}: this arrow does not go down")
        for circle in circles(self.needs):
            self.fault(f"{circle}: these need each other")
        return self.faults


def check_core(core):
    """The core knows itself only, and no VTK."""
    for path, room in core.files:
        for bracket, included in includes_of(path):
            if VTK_HEADER.match(included):
                core.fault(f"{path.name} includes {included}: the core knows no VTK")
            if core.has(included):
                core.add_arrow(path, room, included)
            elif bracket == '"':
                core.fault(f'{path.name} includes "{included}", which is no file of the core')
    return core.check()


def check_plain(root, core, folder, known):
    """A folder of plain C++ knows the core, itself and the folders in `known`, and no VTK. Files of
    its own are included with the folder's name, or without it in a folder that nobody includes."""
    faults, needs, names = [], {}, set()
    filters = root / "filters"
    for path in sorted((filters / folder).iterdir()):
        if path.suffix not in (".h", ".cxx"):
            continue
        names.add(path.name)
        for bracket, included in includes_of(path):
            name = pathlib.PurePath(included)
            own = (filters / folder / included).is_file() or name.parts[0] == folder
            if VTK_HEADER.match(included):
                faults.append(f"filters/{folder}: {path.name} includes {included}: it knows no VTK")
            elif own:
                if name.stem != path.stem:
                    needs.setdefault(path.stem, set()).add(name.stem)
            elif included == LIST_OF_OPTIONS or name.parts[0] in known:
                continue
            elif bracket == '"' and not core.has(included):
                faults.append(
                    f'filters/{folder}: {path.name} includes "{included}", which it may not')
    faults += [f"filters/{folder}: {circle}: these need each other" for circle in circles(needs)]
    return faults if names else [f"filters/{folder}: there are no sources"]


def check_program(program, core):
    """The program knows itself, VTK and the public headers of the filters."""
    filters = core.folder.parent
    for path, room in program.files:
        for bracket, included in includes_of(path):
            if program.has(included):
                program.add_arrow(path, room, included)
            elif core.has(included):
                program.fault(f"{path.name} includes {included} of the core")
            elif VTK_HEADER.fullmatch(included) or included == LIST_OF_OPTIONS:
                continue
            elif bracket == '"' or (filters / included).is_file():
                program.fault(f"{path.name} includes {included}, which is not for the program")
    return program.check()


def check_helpers(root, helpers, core):
    """Helpers know the core, VTK and lower floors; headers of classes know no helper and no
    core."""
    classes = {path.name: path
               for folder in CLASSES for path in sorted((root / folder).glob("*.h"))}
    for path, room in helpers.files:
        for bracket, included in includes_of(path):
            if included.startswith("private/"):
                helpers.add_arrow(path, room, included[len("private/") :])
            elif included in classes and included not in MACROS:
                helpers.fault(f"{path.name} includes the public class header {included}")
    faults = helpers.check()
    for folder, known in SMALL_HELPERS.items():
        paths = sorted(path for path in (root / folder).iterdir() if path.suffix in (".h", ".cxx"))
        faults += [] if paths else [f"{folder}: there are no sources"]
        for path, (bracket, included) in ((path, pair) for path in paths
                                          for pair in includes_of(path)):
            first = pathlib.PurePath(included).parts[0]
            if included in classes and included not in MACROS:
                faults.append(f"{folder}: {path.name} includes the public class header {included}")
            elif (root / "filters" / first).is_dir() and not (
                    first in known or core.has(included)):
                faults.append(f"{folder}: {path.name} includes {included}, which it may not")
    for path in classes.values():
        for bracket, included in includes_of(path):
            if included.startswith(("private/", "files/", "pipeline/")) or core.has(included):
                faults.append(f"{path.name} is public and includes {included}, which is not")
    return faults


def main(root):
    floors = floors_of_rooms(root / "docs" / "architecture.md")
    core = Rooms(root, CORE, floors.get(CORE, {}))
    helpers = Rooms(root, HELPERS, floors.get(HELPERS, {}))
    program = Rooms(root, PROGRAM, floors.get(PROGRAM, {}), at_the_top=("main.cxx",))
    faults = check_core(core) + check_helpers(root, helpers, core)
    for folder, known in PLAIN.items():
        faults += check_plain(root, core, folder, known)
    faults += check_program(program, core)
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
