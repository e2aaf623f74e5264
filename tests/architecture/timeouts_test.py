# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every test has a time limit, so that one that hangs fails instead of holding up all others.

Usage: timeouts_test.py <ctest> <build folder> <configuration>. Prints the tests without a limit,
and fails if there is any.
"""

import json
import subprocess
import sys

LONGEST = 1800  # seconds, for the slowest of the sanitizers


def main(ctest, build, configuration):
    listed = subprocess.run(
        [ctest, "--test-dir", build, "--build-config", configuration, "--show-only=json-v1"],
        check=True, capture_output=True, text=True).stdout
    tests = json.loads(listed)["tests"]
    faults = []
    for test in tests:
        properties = {entry["name"]: entry["value"] for entry in test.get("properties", [])}
        limit = properties.get("TIMEOUT")
        if not limit or not 0 < float(limit) <= LONGEST:
            faults.append(f"{test['name']} has the time limit {limit}, not 1 to {LONGEST} s")
    print(f"{len(tests)} tests")
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults or not tests else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
