# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Python of docs/python.md and of README.md runs, on inputs made for that."""

import contextlib
import os
import pathlib
import sys
import tempfile
import unittest
import warnings

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))

import inputs  # noqa: E402
from pages import Page  # noqa: E402


@contextlib.contextmanager
def folder_of_inputs():
    before = os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        inputs.main(pathlib.Path(folder))
        os.chdir(folder)
        try:
            yield pathlib.Path(folder)
        finally:
            os.chdir(before)


class PagesTest(unittest.TestCase):
    def run_page(self, name, files):
        blocks = Page(ROOT, ROOT / name).blocks("python")
        self.assertTrue(blocks)
        names = {}
        with folder_of_inputs() as folder, warnings.catch_warnings():
            warnings.simplefilter("error", RuntimeWarning)
            for block in blocks:
                with self.subTest(block.where):
                    exec(compile(block.code, block.where, "exec"), names)
            for file in files:
                self.assertGreater((folder / file).stat().st_size, 1000, file)

    def test_python(self):
        self.run_page("docs/python.md", ["solid.stl", "pipeline.stl"])

    def test_readme(self):
        self.run_page("README.md", ["solid.stl"])


if __name__ == "__main__":
    unittest.main()
