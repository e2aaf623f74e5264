# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Man pages and completions have every command and option of the program's own help, man and mandoc
have nothing to say against the pages, and each shell that is installed completes what users type.

Usage: manual_test.py <program> <folder of pages>. Exits with 77 where no shell and no man is there.
"""

import os
import pathlib
import pty
import re
import select
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

SKIPPED = 77
TOOLS = ("bash", "zsh", "fish", "man", "mandoc")
ESCAPES = re.compile(r"\x1b(\[[0-9;?>=]*[A-Za-z]|\][^\x07]*\x07|[()][A-Z0-9]|[=>])|[\r\x07]")


def output_of(*command, **options):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True,
                          timeout=60, **options).stdout


def options_of(command):
    """The options in the help of a command, or of the program."""
    names = set()
    for line in output_of(PROGRAM, *command, "--help").splitlines():
        found = re.match(r"  (-[-\w,]+)", line)
        names |= set(found[1].split(",")) if found else set()
    return names


def commands():
    text = output_of(PROGRAM, "--help").partition("Subcommands:")[2]
    return re.findall(r"^  (\w+) ", text, re.MULTILINE)


def page_of(command):
    return PAGES / "man1" / ("-".join(["winding"] + command) + ".1")


def completions_of(shell):
    name = {"bash": "winding", "zsh": "_winding", "fish": "winding.fish"}[shell]
    return PAGES / shell / name


class TestPages(unittest.TestCase):
    def test_every_option_is_in_its_page(self):
        self.assertEqual(len(list((PAGES / "man1").iterdir())), len(commands()) + 1)
        for command in [[]] + [[name] for name in commands()]:
            page = page_of(command).read_text()
            found = set(re.findall(r"\\fB(--?[\w-]+)\\fR", page.replace("\\-", "-")))
            self.assertEqual(options_of(command) - found, set(), command)
            self.assertGreaterEqual(len(options_of(command)), 2)

    def test_every_command_is_in_the_first_page(self):
        page = page_of([]).read_text()
        for name in commands():
            self.assertIn(f"\\fB{name}\\fR", page)

    def test_words_of_options_are_in_their_pages(self):
        page = page_of(["surface"]).read_text()
        for word in ("hierarchical", "outward", "\\fB\\-\\-offset\\fR \\fILENGTH\\fR"):
            self.assertIn(word, page)

    @unittest.skipUnless(shutil.which("mandoc"), "no mandoc here")
    def test_mandoc_has_no_warnings(self):
        for page in sorted((PAGES / "man1").iterdir()):
            found = output_of("mandoc", "-T", "lint", "-W", "style,stop", page)
            # Other pages need not be installed.
            found = [line for line in found.splitlines() if "manual not found" not in line]
            self.assertEqual(found, [])

    @unittest.skipUnless(shutil.which("man"), "no man here")
    def test_man_has_no_warnings(self):
        for page in sorted((PAGES / "man1").iterdir()):
            run = subprocess.run(["man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", page],
                                 capture_output=True, text=True, timeout=60,
                                 env={**os.environ, "MANROFFSEQ": "", "MANWIDTH": "80"})
            self.assertEqual((run.returncode, run.stderr), (0, ""), page)


def part_of(shell, name):
    """What the completions of a shell have for one command, with options as one writes them."""
    text = completions_of(shell).read_text()
    if shell == "fish":
        lines = [line for line in text.splitlines() if f"_from {name}'" in line]
        return re.sub(r" -s (\w)", r" -\1", re.sub(r" -l (\w)", r" --\1", "\n".join(lines)))
    return re.search(rf"^    {name}\)$(.*?)^      ;;$", text, re.MULTILINE | re.DOTALL)[1]


class TestCompletions(unittest.TestCase):
    def test_every_option_is_in_every_shell(self):
        for shell in ("bash", "zsh", "fish"):
            for name in commands():
                part = part_of(shell, name)
                for option in options_of([name]):
                    self.assertRegex(part, rf"(?<![\w-]){option}(?![\w-])", (shell, name))


class Terminal:
    """An interactive shell in a terminal of its own."""

    def __init__(self, command, folder, start):
        environment = {"PATH": f"{PROGRAM.parent}:{os.environ['PATH']}", "HOME": str(folder),
                       "TERM": "xterm", "LC_ALL": "C.UTF-8"}
        self.process, self.file = pty.fork()
        if self.process == 0:
            os.chdir(folder)
            os.execvpe(command[0], command, environment)
        subprocess.run(["stty", "cols", "200", "rows", "60"], stdin=self.file, check=True)
        self.type(f"{start}; echo rea''dy\n")
        self.read(60, ["ready\n"])

    def read(self, seconds, awaited):
        """What the shell shows until it has shown all that is awaited, or time is over."""
        text, end = "", time.monotonic() + seconds
        while time.monotonic() < end and not all(word in text for word in awaited):
            if select.select([self.file], [], [], 0.05)[0]:
                text += ESCAPES.sub("", os.read(self.file, 65536).decode(errors="replace"))
        return text

    def type(self, text):
        os.write(self.file, text.encode())

    def clear(self):
        """Waits for a new, empty line."""
        self.type("\x15echo cle''ar\n")
        self.read(30, ["clear\n"])

    def complete(self, text, awaited):
        """What the shell shows while the tabulator key is pressed, until all that is awaited."""
        shown, end = "", time.monotonic() + 20
        self.type(text)
        while time.monotonic() < end and not all(word in shown for word in awaited):
            self.type("\t")
            shown += self.read(1, awaited)
        shown += self.read(0.2, ["nothing"])
        self.clear()
        return shown

    def close(self):
        os.kill(self.process, signal.SIGKILL)
        os.waitpid(self.process, 0)
        os.close(self.file)


class Shell:
    """The cases, for each shell. Words that are awaited are no part of what is typed."""

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder, True)
        for name in ("scan.obj", "packed scan.off.gz", "notes.txt", "result.stl", "table.csv",
                     "head.mhd", "ct.nhdr"):
            (cls.folder / name).touch()
        (cls.folder / "meshes").mkdir()
        cls.start()

    def check(self, text, awaited, absent=()):
        shown = self.complete(text, awaited)
        for word in awaited:
            self.assertIn(word, shown)
        for word in absent:
            self.assertNotIn(word, shown)

    def test_commands(self):
        self.check("winding ", commands(), ["notes.txt"])
        self.check("winding surf", ["surface"])
        self.check("winding --ver", ["--version"])

    def test_options(self):
        self.check("winding surface --off", ["--offset"], ["--threads"])
        self.check("winding surface --sh", ["--shell", "--shell-side"], ["--overlap"])

    def test_words_of_an_option(self):
        methods = ["auto", "rows", "hierarchical", "direct", "parity"]
        self.check("winding surface --method ", methods, ["notes.txt"])
        self.check("winding surface --method=", methods, ["notes.txt"])
        self.check("winding surface --method hi", ["hierarchical"])
        self.check("winding surface scan.obj --shell-side out", ["outward"])

    def test_files(self):
        sources = ["scan.obj", "scan.off.gz", "table.csv", "meshes"]
        self.check("winding check ", sources, ["notes.txt"])
        self.check("winding surface -o ", ["result.stl", "meshes"], ["table.csv", "notes.txt"])
        self.check("winding surface --output=res", ["result.stl"])
        self.check("winding field --like ", ["head.mhd", "ct.nhdr"], ["result.stl"])


class TerminalShell(Shell):
    @classmethod
    def start(cls):
        cls.terminal = Terminal(cls.command, cls.folder, cls.settings())
        cls.addClassCleanup(cls.terminal.close)

    def complete(self, text, awaited):
        return self.terminal.complete(text, awaited)


@unittest.skipUnless(shutil.which("bash"), "no bash here")
class TestBash(TerminalShell, unittest.TestCase):
    command = ["bash", "--norc", "--noprofile", "-i"]

    @staticmethod
    def settings():
        return f"PS1='> '; source '{completions_of('bash')}'"


@unittest.skipUnless(shutil.which("zsh"), "no zsh here")
class TestZsh(TerminalShell, unittest.TestCase):
    command = ["zsh", "-f", "-i"]

    @staticmethod
    def settings():
        return (f"PS1='> '; fpath=('{PAGES / 'zsh'}' $fpath); LISTMAX=1000; "
                "autoload -U compinit; compinit -D -u")


@unittest.skipUnless(shutil.which("fish"), "no fish here")
class TestFish(Shell, unittest.TestCase):
    """fish prints completions without a terminal."""

    @classmethod
    def start(cls):
        pass

    def complete(self, text, awaited):
        return output_of("fish", "--no-config", "-c",
                         "set -p PATH $argv[1]; source $argv[2]; complete -C $argv[3]",
                         PROGRAM.parent, completions_of("fish"), text, cwd=self.folder,
                         env={**os.environ, "HOME": str(self.folder)})


if __name__ == "__main__":
    PROGRAM, PAGES = (pathlib.Path(path).resolve() for path in sys.argv[1:3])
    if not any(shutil.which(tool) for tool in TOOLS):
        print("none of", *TOOLS)
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1], verbosity=2)
