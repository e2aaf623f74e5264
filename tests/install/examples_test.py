"""The programs of data/examples build against the installed package, and the commands of the page there
make what they say."""

import shlex

from consumers import ROOT, arguments, build, emptied, require_files, run

import inputs
from pages import Page


def main():
    settings = arguments()
    files, target = emptied(settings.folder / "files"), emptied(settings.folder / "build")
    inputs.main(files)
    examples = ROOT / "data" / "examples"
    build(settings, examples, target)

    programs = {path.stem for path in examples.glob("*.cxx")}
    for block in Page(ROOT, examples / "README.md").blocks("sh"):
        for line in block.code.splitlines():
            words = shlex.split(line, comments=True)
            if words and words[0].startswith("build/examples/"):
                name = words[0].rpartition("/")[2]
                output = next(word for word in words[2:] if word not in ("scan.obj", "mesh.vtu"))
                run(target / name, *words[1:], folder=files)
                require_files(files, [output])
                programs.discard(name)
    if programs:
        raise SystemExit(f"no command in {examples / 'README.md'} runs {', '.join(sorted(programs))}")


main()
