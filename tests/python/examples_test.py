# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The scripts of data/examples/python run, and draw their pictures without a window."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "data" / "examples" / "python"


class ExamplesTest(unittest.TestCase):
    def test_each_draws_a_picture(self):
        scripts = sorted(FOLDER.glob("*.py"))
        self.assertEqual(len(scripts), 4)
        for script in scripts:
            with self.subTest(script.name), tempfile.TemporaryDirectory() as folder:
                picture = pathlib.Path(folder, "picture.png")
                run = subprocess.run(
                    [sys.executable, "-W", "error::RuntimeWarning", script, "--picture", picture],
                    capture_output=True, text=True)
                self.assertEqual(run.returncode, 0, run.stderr)
                self.assertGreater(picture.stat().st_size, 20_000)


if __name__ == "__main__":
    unittest.main()
