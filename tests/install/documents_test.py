# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The C++ of the documents builds against the installed package, runs, and writes the files that it
says.

A block of code becomes a function of a program that has all blocks of its page, on inputs made for
that.
"""

import re

from consumers import ROOT, arguments, build, emptied, require_files, run

import inputs
from pages import pages_of

VTK_CLASS = re.compile(r"\bvtk[A-Z]\w+")
WRITTEN_FILE = re.compile(r'writer->SetFileName\("([^"]+)"\)')


def program_of(blocks):
    """A source with a function for each block, and a main() that calls them all."""
    code = "\n".join(block.code for block in blocks)
    headers = {name.partition("::")[0] for name in VTK_CLASS.findall(code)}
    # Results and inputs that a block only passes on are incomplete without these.
    headers |= {"vtkDataObject", "vtkImageData", "vtkPolyData", "vtkUnstructuredGrid"}
    lines = [f"#include <{name}.h>" for name in sorted(headers)]
    lines.append("#include <iostream>")
    for number, block in enumerate(blocks):
        page, line = block.where.split(":")
        lines += [f"static void block{number}()", "{", f'#line {line} "{page}"', block.code, "}"]
    calls = " ".join(f"block{number}();" for number in range(len(blocks)))
    lines.append(f"int main() {{ {calls} }}")
    return "\n".join(lines) + "\n"


def main():
    settings = arguments()
    code, files = emptied(settings.folder / "code"), emptied(settings.folder / "files")
    inputs.main(files)
    programs = {}
    for page in pages_of(ROOT):
        blocks = page.blocks("c++")
        if blocks:
            (code / f"{page.path.stem}.cxx").write_text(program_of(blocks), encoding="utf-8")
            name = "program" if page.path.stem == "README" else f"page_{page.path.stem}"
            programs[name] = blocks
        if page.name == "README.md":
            lines = "".join(block.code for block in page.blocks("cmake"))
            (code / "README.cmake").write_text(lines, encoding="utf-8")

    target = emptied(settings.folder / "build")
    build(settings, ROOT / "tests" / "install" / "consumer", target, f"-DCODE_DIR={code}")
    for name, blocks in programs.items():
        written = [WRITTEN_FILE.findall(block.code) for block in blocks]
        for block, names in zip(blocks, written):
            if not names:
                raise SystemExit(f"{block.where}: nothing here writes a file that would show that "
                                 "it works")
        names = {name for names in written for name in names}
        for file_name in names:
            (files / file_name).unlink(missing_ok=True)
        run(target / name, folder=files)
        require_files(files, names)


main()
