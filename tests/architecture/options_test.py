# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Properties, PrintSelf(), the program, Python and ParaView's panels agree with Options.def.

Usage: options_test.py <root of the repository>. Reads filters/Options.def and the sources, prints
one line for each fault, and fails if there is any.
"""

import ast
import math
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from options import options_in  # noqa: E402

# Panels may begin with another value than a property, where a picture is what their users want.
OTHER_DEFAULTS = {("WindingNumberReport", "FaultThickness"),
                  ("WindingNumberAlgorithm", "LongestExpectedTime"),
                  ("WindingNumberSurface", "Resolution"),
                  ("WindingNumberBoolean", "Resolution"),
                  ("WindingNumberAlgorithm", "EstimateNormals"),
                  ("WindingNumberNormals", "EstimateNormals")}
# Several classes have properties of these names, which mean different things.
AMBIGUOUS = {"ResultArrayName", "PointAreaMethod"}
# Each rank may have its own of these: they change no result (docs/scale.md).
NOT_HASHED = {"NumberOfThreads", "LongestExpectedTime", "VerifySamples"}
# What these classes refuse.
NOT_CHOSEN = {("vtkWindingNumberNormals", "ARRAY")}
# What the hash of a filter's properties is made of.
HASHED = "HashProperties|GetSourceOptions|GetResultOptions|WantsDistances|SamplesCells|KeepsPart"


def numbers(text):
    return [float(number) for number in text.split()]


def same(kind, a, b):
    return a == b if kind == "text" else numbers(a) == numbers(b)


def check_classes(root, options):
    """Every property can be set, is printed, and has its default in a header."""
    headers = {path: path.read_text() for folder in ("vtk", "io")
               for path in sorted((root / "filters" / folder).glob("*.h"))}
    sources = "".join(path.read_text() for folder in ("vtk", "io")
                      for path in sorted((root / "filters" / folder).rglob("*.cxx")))
    printed = set(re.findall(r'"(\w+): "', sources))
    printed |= set(re.findall(r'"(\w+): "', "".join(
        path.read_text() for path in (root / "filters/vtk/private").rglob("*.h"))))
    for option in options:
        name = option.property
        owners = [text for text in headers.values()
                  if re.search(rf"\bSet{name}\(|Macro\({name}\b", text)]
        if not owners:
            yield f"{name}: no class has Set{name}()"
        if name not in printed:
            yield f"{name}: no PrintSelf() has it"
        for text in owners:
            found = re.search(rf"^  (?:int|double|vtkTypeBool)\s+{name}(?:\[\d\])? = ([^;]+);",
                              text, re.MULTILINE)
            if found is None or name in AMBIGUOUS:
                continue
            value = found[1].strip("{} ").replace(",", "")
            value = {"VTK_FLOAT": "10", "VTK_DOUBLE": "11", "vtkAlgorithm::DEFAULT_PRECISION": "2",
                     "DEFAULT_PRECISION": "2"}.get(value, value)
            by_name = {names[0]: number for number, names in option.choices.items()}
            value = by_name.get(value, value)
            try:
                right = same(option.kind, value, option.default)
            except ValueError:
                continue  # a default that another constant gives
            if not right:
                yield f"{name}: a header has {value}, the list {option.default}"


def in_setter(constant):
    """SpanningTree for SPANNING_TREE, without what tells it from a constant of another option."""
    constant = re.sub("^(DISTRIBUTION|ESTIMATION|LABELS|VTK)_", "", constant)
    return "".join(word.capitalize() for word in constant.split("_"))


def check_choices(root, options):
    """Every choice has a setter without an argument, and every property gives its name."""
    found = 0
    for path in sorted((root / "filters/vtk").glob("*.h")):
        text = path.read_text()
        for option in options:
            name = option.property
            if (not option.choices or name == "OutputPointsPrecision" or
                    not re.search(rf"^  vtkSet\w*Macro\({name}\b", text, re.MULTILINE)):
                continue  # precisions have VTK's own constants
            if f"const char* Get{name}AsString() const;" not in text:
                yield f"{path.stem}: there is no Get{name}AsString()"
            for names in option.choices.values():
                found += f"  void Set{name}To{in_setter(names[0])}()" in text
                if (f"  void Set{name}To{in_setter(names[0])}()" not in text and
                        (path.stem, names[0]) not in NOT_CHOSEN):
                    yield f"{path.stem}: there is no Set{name}To{in_setter(names[0])}()"
    if found < 60:
        yield f"only {found} choices have setters"


def check_hash(root, options):
    """Every property that may change a result is in the hash that ranks compare."""
    of_source = "".join(path.read_text() for path in
                        (root / "filters/vtk/private/source").glob("SourceProperties.*"))
    hashed = 0
    for header in sorted((root / "filters/vtk").glob("vtkWindingNumber*.h")):
        text, source = header.read_text(), header.with_suffix(".cxx").read_text()
        if "HashProperties" not in text and "HashProperties" not in source:
            continue  # it takes an image, and no source
        bodies = re.findall(rf"::(?:{HASHED})\([^{{}};]*\{{.*?^\}}", source,
                            re.MULTILINE | re.DOTALL)
        bodies += re.findall(rf"(?:{HASHED})\(\) const override \{{[^}}]*\}}", text)
        for option in options:
            name = option.property
            if not re.search(rf"^  (?:vtkSet\w*Macro\({name}\b|(?:virtual )?void Set{name}\()",
                             text, re.MULTILINE):
                continue
            is_found = re.search(rf"this->{name}\b", "".join(bodies)) or re.search(
                rf"\bGet{name}\(\)", of_source)
            hashed += bool(is_found)
            if bool(is_found) == (name in NOT_HASHED):
                yield f"{header.stem}: {name} is {'' if is_found else 'not '}hashed"
    if hashed < 40:
        yield f"only {hashed} properties are hashed"


def check_panels(root, options):
    by_setter = {"Set" + option.property: option for option in options}
    for path in sorted((root / "paraview-plugin").glob("*.xml")):
        for proxy in ElementTree.parse(path).iter("SourceProxy"):
            for element in proxy:
                option = by_setter.get(element.get("command", ""))
                if option is None or element.get("default_values") is None:
                    continue
                where = f"{path.name}: {proxy.get('name')}.{element.get('name')}"
                label = element.get("label") or re.sub(
                    r"(?<=[a-z])(?=[A-Z])", " ", element.get("name"))
                label = re.sub("^Source As", "Input As", label)  # filters with a Source say so
                if element.get("panel_visibility") == "advanced":
                    label += "*"
                if option.property not in AMBIGUOUS and option.label != label:
                    yield f"{where}: the label is {label}, in the list {option.label}"
                value = element.get("default_values")
                value = "" if value in ("None", "Active Normals") else value  # names of no array
                other = (proxy.get("name"), option.property) in OTHER_DEFAULTS
                if not other and option.property not in AMBIGUOUS and not same(
                        option.kind, value, option.default):
                    yield f"{where}: the default is {value}, in the list {option.default}"
                for entry in element.iter("Entry"):
                    names = option.choices.get(entry.get("value"))
                    if option.property not in AMBIGUOUS and names and names[1] != entry.get("text"):
                        yield f"{where}: {entry.get('text')} is {names[1]} in the list"


def check_plugin_in_python(root, options):
    """The plugin in Python, which reads lowest values from the panels, has the highest ones."""
    text = (root / "paraview-plugin/python/winding_paraview/declarations.py").read_text()
    has = ast.literal_eval(re.search(r"^_HIGHEST = (\{.*?\})$", text, re.MULTILINE | re.DOTALL)[1])
    bounded = {option.property: option.highest for option in options
               if option.kind in ("number", "integer") and option.highest < math.inf}
    for name, highest in {**has, **bounded}.items():
        if has.get(name) != bounded.get(name):
            yield f"{name}: the plugin in Python takes up to {has.get(name)}, the list {highest}"


def check_front_ends(root, options):
    program = "".join(path.read_text() for path in (root / "apps/winding/options").glob("*.cxx"))
    python = "".join(path.read_text() for path in (root / "python/vtkwinding").glob("*.py"))
    for option in options:
        if option.option and not re.search(rf'"{option.option}\b', program):
            yield f"{option.property}: the program has no {option.option}"
        if option.keyword and not re.search(rf"\b{option.keyword}\b", python):
            yield f"{option.property}: Python has no keyword {option.keyword}"
        for names in option.choices.values():
            word = names[2]
            takes_words = option.option and f'add_flag("{option.option}"' not in program
            if word and takes_words and f'"{word}"' not in program:
                yield f"{option.property}: the program does not have the word {word}"


def main(root):
    options = options_in(root / "filters" / "Options.def")
    faults = [*check_classes(root, options), *check_choices(root, options),
              *check_hash(root, options), *check_panels(root, options),
              *check_plugin_in_python(root, options), *check_front_ends(root, options)]
    print(f"{len(options)} options")
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults or len(options) < 50 else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
