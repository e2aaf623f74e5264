# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin in Python as users get it. Needs no ParaView."""
import os
import zipfile

# ParaView up to 5.11 wants what Python has no more since 3.11, and cannot load any plugin without.
SHIM = """import inspect
if not hasattr(inspect, "getargspec"):
    inspect.getargspec = inspect.getfullargspec
"""


def unpack_python_plugin(folder):
    """Unpacks the zip of the plugin in Python into a folder, as users do it, with a "shim" that is
    to be in Python's path. Returns the file that ParaView loads."""
    with zipfile.ZipFile(os.environ["WINDING_ZIP"]) as archive:
        archive.extractall(folder)
    (folder / "shim").mkdir()
    (folder / "shim" / "sitecustomize.py").write_text(SHIM)
    return folder / "WindingNumbers" / "WindingNumbers.py"
