"""The includes of filters/core respect the floors that docs/architecture.md states.

Usage: arrows_test.py <root of the repository>. Prints a table of all arrows between rooms, then one
line for each fault, and fails if there is any.
"""

import pathlib
import re
import sys

INCLUDE = re.compile(r'^\s*#\s*include\s+(["<])([^">]+)[">]', re.MULTILINE)
FLOOR_ROW = re.compile(r"^\| (\d+) \| `(\w+)` \|", re.MULTILINE)


def sources(folder):
    return sorted(path for path in folder.rglob("*") if path.suffix in (".h", ".cxx"))


def floors_of_rooms(page):
    return {room: int(floor) for floor, room in FLOOR_ROW.findall(page.read_text())}


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


def main(root):
    core = root / "filters" / "core"
    floors = floors_of_rooms(root / "docs" / "architecture.md")
    faults, arrows, needs = [], {}, {}

    rooms = {path.name for path in core.iterdir() if path.is_dir()}
    for room in sorted(rooms ^ set(floors)):
        faults.append(f"{room}: a folder of filters/core and a row of the table should have this name")
    files = sources(core)
    if not files:
        faults.append("filters/core has no sources")

    for path in files:
        name = path.relative_to(core)
        if len(name.parts) != 2:
            faults.append(f"{name}: a file of the core lies in a room")
            continue
        room, unit = name.parts[0], str(name.with_suffix(""))
        for bracket, included in INCLUDE.findall(path.read_text()):
            if re.match(r"vtk\w*\.h", included):
                faults.append(f"{name} includes {included}: the core knows no VTK")
            if bracket == "<":
                continue
            if not (core / included).is_file():
                faults.append(f'{name} includes "{included}", which is no file below filters/core')
                continue
            other = pathlib.PurePath(included)
            if other.parts[0] != room:
                arrows.setdefault((room, other.parts[0]), []).append(f"{name} -> {included}")
            if str(other.with_suffix("")) != unit:
                needs.setdefault(unit, set()).add(str(other.with_suffix("")))

    print("includes  from room  to room")
    for (room, other), names in sorted(arrows.items()):
        print(f"{len(names):8}  {room:9}  {other}")
        if floors.get(other, 99) >= floors.get(room, 0):
            faults.extend(f"{name}: this arrow does not go down" for name in names)
    faults.extend(f"{circle}: these need each other" for circle in circles(needs))

    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
