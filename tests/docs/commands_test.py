# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every command of the pages does what it says: commands of `winding` are run, on inputs made for
that, and the ones that build are checked against the presets, options and commands that there are.

Usage: commands_test.py <root of the repository> <the program winding>. Prints each command and its
faults, and fails if there is any.
"""

import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import inputs  # noqa: E402
from pages import pages_of  # noqa: E402

# Options of other programs that sentences speak of: of CMake, of ParaView and its examples, of
# mpirun.
FOREIGN_OPTIONS = {"--preset", "--install", "--build", "--prefix", "--target", "--picture",
                   "--state", "--plugin", "--plugins", "--plugin-search-paths", "--bind-to"}

# Open MPI starts more ranks than there are cores, and starts them for the superuser, who runs tests
# in containers. Its plugins leak, and are gone when LeakSanitizer would name them.
OF_MPIRUN = {"OMPI_MCA_rmaps_base_oversubscribe": "1",  # Open MPI 4
             "PRTE_MCA_rmaps_default_mapping_policy": ":oversubscribe",  # Open MPI 5 and newer
             "OMPI_ALLOW_RUN_AS_ROOT": "1",
             "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "LSAN_OPTIONS": "detect_leaks=0"}


class Checker:
    def __init__(self, root, program):
        self.root, self.program = root, program
        presets = json.loads((root / "CMakePresets.json").read_text())
        self.presets = {
            kind: {preset["name"] for preset in presets[kind + "Presets"]}
            for kind in ("configure", "build", "test")}
        lists = [root / "CMakeLists.txt"]
        for folder in ("apps", "filters", "tests"):
            lists += (root / folder).rglob("CMakeLists.txt")
        self.lists = "\n".join(path.read_text() for path in lists)
        self.dev_commands = {"help"} | self.listed([root / "dev", "help"], r"^  (\w+)")
        self.winding_commands = {
            name: self.listed([program, name, "--help"], r"(--?[a-z][\w-]*)")
            for name in self.listed([program, "--help"], r"^  ([a-z]+) ")}
        self.winding_options = set().union(*self.winding_commands.values())

    @staticmethod
    def listed(command, pattern):
        text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
        return set(re.findall(pattern, text, re.MULTILINE))

    def faults(self, words, folder):
        """What is wrong with a command; runs it in a folder if it is one of `winding`, with or
        without mpirun."""
        program = words[0]
        if program in ("winding", "mpirun"):
            return self.faults_of_run(words, folder)
        if program == "./dev":
            return self.unless(words[1] in self.dev_commands, f"./dev has no command {words[1]}")
        if program in ("cmake", "ctest"):
            return self.faults_of_build(program, words[1:])
        if program == "xvfb-run":
            return self.faults(words[2:], folder)
        if program.endswith("/pvpython"):
            return self.faults_of_file(words[1])
        if program.startswith("build/examples/"):  # tests/install runs it
            return self.faults_of_file("data/examples/" + program.rpartition("/")[2] + ".cxx")
        if program.startswith("data/"):
            return self.faults_of_file(program)
        if program == "python3":
            return self.faults_of_file(words[1])
        if program in ("auditwheel", "clang-format", "docker", "pip"):
            return []
        return [f"{program} is a program that this test does not know"]

    @staticmethod
    def unless(is_right, fault):
        return [] if is_right else [fault]

    def faults_of_file(self, name):
        return self.unless((self.root / name).is_file(), f"there is no {name}")

    def faults_of_build(self, program, words):
        faults = []
        for index, word in enumerate(words):
            following = words[index + 1] if index + 1 < len(words) else ""
            if word == "--preset":
                kind = ("test" if program == "ctest" else
                        "build" if "--build" in words else "configure")
                faults += self.unless(following in self.presets[kind],
                                      f"no {kind} preset {following}")
            elif word == "-L":
                labels = re.findall(r"LABELS\s+(\w+)|winding_add_tests\((\w+)", self.lists)
                known = {label for pair in labels for label in pair}
                faults += self.unless(following in known, f"no test has the label {following}")
            elif word == "-S":
                faults += self.unless((self.root / following).is_dir(), f"there is no {following}")
            elif word.startswith("-DWINDING_"):
                option = word[2:].partition("=")[0]
                is_option = re.search(rf"(option|set)\({option}\b", self.lists)
                faults += self.unless(is_option, f"there is no option {option}")
            elif word == "--target":
                is_target = re.search(rf"add_\w+\({following}\b", self.lists)
                faults += self.unless(is_target, f"there is no target {following}")
        return faults

    def faults_of_run(self, words, folder):
        outputs = [folder / words[index + 1] for index, word in enumerate(words)
                   if word in ("-o", "--blocks")]
        for output in outputs:
            output.unlink(missing_ok=True)
        place = words.index("winding")
        if place > 0 and not shutil.which("mpirun"):
            return []
        run = subprocess.run([*words[:place], self.program, *words[place + 1:]], cwd=folder,
                             capture_output=True, text=True, env={**os.environ, **OF_MPIRUN})
        if run.returncode != 0:
            return [f"exit status {run.returncode}: {run.stderr.strip()}"]
        faults = [f"{output.name} was not written" for output in outputs
                  if not output.is_file() or not output.stat().st_size]
        if "--json" in words:
            json.loads(run.stdout)
        return faults

    def faults_of_span(self, code):
        """What is wrong with a command or an option within a sentence."""
        words = code.split()
        if words[0] == "winding" and len(words) > 1 and words[1] in self.winding_commands:
            known = self.winding_commands[words[1]]
            return [f"winding {words[1]} has no {word}" for word in words
                    if word.startswith("-") and word not in known]
        if words[0] == "winding" and len(words) > 1 and not re.match(r"[<`-]", words[1]):
            return [f"winding has no command {words[1]}"]
        if words[0] == "./dev":
            return self.faults(words, None) if len(words) > 1 else []
        if words[0] in ("cmake", "ctest"):
            return self.faults(words, None)
        if re.match(r"--[a-z]", words[0]):
            option = words[0].partition("=")[0]
            is_known = option in self.winding_options | FOREIGN_OPTIONS
            return self.unless(is_known, f"winding has no {option}")
        return []


def main(root, program):
    root = pathlib.Path(root).resolve()
    checker = Checker(root, pathlib.Path(program).resolve())
    faults = []
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        inputs.main(folder)
        for page in pages_of(root):
            for block in page.blocks("sh"):
                for line in block.code.splitlines():
                    words = shlex.split(line, comments=True)
                    if not words:
                        continue
                    print(f"{block.where}: {shlex.join(words)}", flush=True)
                    faults += [f"{block.where}: {shlex.join(words)}: {fault}"
                               for fault in checker.faults(words, folder)]
            for where, code in page.code_spans():
                faults += [f"{where}: {fault}" for fault in checker.faults_of_span(code)]
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
