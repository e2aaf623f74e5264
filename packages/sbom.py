# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the SBOM of a release, in SPDX 2.3 as JSON: its files with their hashes, what the Debian
packages and wheels need, and the packages whose headers are compiled in.

Usage: sbom.py <folder of the release> <version> <folder of the builds>

Headers are the ones that ninja has recorded for the builds, libraries the ones that dpkg-shlibdeps
found, that the wheels contain, or that they ask pip for. Versions are dpkg's, and those that the
unpacked ParaView and VTK SDK have in their own documents; a package that is needed and not
installed has the version that is asked for. Licences alone are listed by hand.
"""

import datetime
import email
import gzip
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import zipfile

BUILDS = ("package", "package-paraview", "wheel", "wheel-native")
# Headers of the compiler and of the system, which every program has.
SYSTEM = re.compile(r"(libc6-dev|linux-libc-dev|libstdc\+\+-.*|libgcc-.*|gcc-.*|libcrypt-dev)$")
LICENCES = {
    "cli11": "BSD-3-Clause", "eigen3": "MPL-2.0", "highway": "Apache-2.0 OR BSD-3-Clause",
    "libzip": "BSD-3-Clause", "nanoflann": "BSD-2-Clause", "nlohmann-json3": "MIT",
    "tinygltf": "MIT", "vtk": "BSD-3-Clause", "vtk9": "BSD-3-Clause", "zlib": "Zlib"}


def output_of(*command):
    return subprocess.run([str(word) for word in command], stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, text=True).stdout


def included_by(build):
    """The headers that the objects of a build were made of, by their whole paths."""
    lines = output_of("ninja", "-C", build, "-t", "deps").splitlines()
    return {os.path.normpath(build / line.strip()) for line in lines if line.startswith("    ")}


def unpacked_paraview(sdk):
    """The name, the version and the reference of the Debian package with ParaView's headers."""
    with gzip.open(sdk / "usr/share/doc/paraview-dev/changelog.Debian.gz", "rt") as changes:
        version = re.search(r"\((\S+)\)", changes.readline())[1]
    return "paraview-dev", version, reference_of_debian("paraview-dev", version)


def unpacked_vtk(sdk):
    """The name, the version and the reference of the wheel with VTK's headers."""
    metadata = email.message_from_string(next(sdk.glob("*.dist-info/METADATA")).read_text())
    name, version = metadata["Name"], metadata["Version"]
    return name, version, f"pkg:pypi/{name}@{version}"


UNPACKED = {"paraview-sdk": unpacked_paraview, "vtk-sdk": unpacked_vtk}


def owners_of(files):
    """The Debian packages of files, without architectures."""
    lines = output_of("dpkg-query", "--search", *sorted(files)).splitlines() if files else []
    return {name.split(":")[0] for line in lines for name in line.partition(": /")[0].split(", ")}


def dpkg(name, field):
    return output_of("dpkg-query", "--show", "--showformat", "${%s}" % field, name).strip()


def reference_of_debian(name, version):
    return f"pkg:deb/debian/{name}@{version.replace(':', '%3A').replace('+', '%2B')}"


def hashes_of(path):
    content = path.read_bytes()
    return [{"algorithm": "SHA1", "checksumValue": hashlib.sha1(content).hexdigest()},
            {"algorithm": "SHA256", "checksumValue": hashlib.sha256(content).hexdigest()}]


def identifier(name):
    return "SPDXRef-" + re.sub(r"[^A-Za-z0-9.-]", "-", name)


class Bill:
    def __init__(self, version):
        self.packages, self.files, self.relations = {}, [], set()
        self.add("winding", version, "BSD-3-Clause", None)

    def add(self, name, version, licence, reference):
        """Adds a package, if it is not there, and returns its identifier."""
        package = {"SPDXID": identifier(name), "name": name, "versionInfo": version,
                   "downloadLocation": "NOASSERTION", "filesAnalyzed": False,
                   "licenseConcluded": "NOASSERTION", "licenseDeclared": licence,
                   "copyrightText": "NOASSERTION"}
        if reference:
            package["externalRefs"] = [{"referenceCategory": "PACKAGE-MANAGER",
                                        "referenceType": "purl", "referenceLocator": reference}]
        self.packages.setdefault(package["SPDXID"], package)
        return package["SPDXID"]

    def add_debian(self, name):
        source = dpkg(name, "source:Package")
        version = dpkg(name, "Version")
        return self.add(name, version, LICENCES.get(source, "NOASSERTION"),
                        reference_of_debian(name, version))

    def add_headers(self, builds, build):
        """Adds the packages whose headers a build has read."""
        headers = included_by(builds / build)
        packages = {self.add_debian(name) for name in owners_of(
            {os.path.realpath(header) for header in headers if header.startswith("/usr/include/")})
            if not SYSTEM.match(name)}
        for folder, describe in UNPACKED.items():
            if any(f"/build/{folder}/" in header for header in headers):
                name, version, reference = describe(builds / folder)
                packages.add(self.add(name, version, "BSD-3-Clause", reference))
        for package in packages:
            self.relate(package, "BUILD_DEPENDENCY_OF", identifier("winding"))

    def relate(self, first, relation, second):
        self.relations.add((first, relation, second))

    def add_file(self, path, root):
        name = f"./{path.relative_to(root)}"
        self.files.append({"SPDXID": identifier("file" + name[1:]), "fileName": name,
                           "checksums": hashes_of(path), "licenseConcluded": "NOASSERTION",
                           "licenseInfoInFiles": ["NOASSERTION"], "copyrightText": "NOASSERTION"})
        self.relate(self.files[-1]["SPDXID"], "GENERATED_FROM", identifier("winding"))
        return self.files[-1]["SPDXID"]

    def add_dependencies_of_deb(self, path, file):
        for choice in output_of("dpkg-deb", "--field", path, "Depends").split(","):
            name, _, version = choice.partition("|")[0].strip().partition(" ")
            name = name.split(":")[0]
            needed = self.add_debian(name) if dpkg(name, "Version") else self.add(
                name, version.strip("()") or "NOASSERTION", "NOASSERTION", f"pkg:deb/debian/{name}")
            self.relate(file, "DEPENDS_ON", needed)

    def add_dependencies_of_wheel(self, path, file):
        with zipfile.ZipFile(path) as wheel:
            names = wheel.namelist()
            metadata = next(name for name in names if name.endswith(".dist-info/METADATA"))
            needs = email.message_from_bytes(wheel.read(metadata)).get_all("Requires-Dist", [])
        for need in needs:
            if "extra ==" not in need:
                name, version = re.match(r"([\w-]+)\s*(.*?)\s*(;|$)", need).groups()[:2]
                if "win32" in need and "!=" not in need:
                    continue
                package = self.add(f"{name}-of-pip", version or "NOASSERTION",
                                   LICENCES.get(name, "NOASSERTION"), f"pkg:pypi/{name}")
                self.relate(file, "DEPENDS_ON", package)
        for name in names:
            library = re.search(r"\.libs/(lib[\w+]+)-[0-9a-f]+\.(so[.\d]*)$", name)
            for owner in owners_of({f"*/{library[1]}.{library[2]}"}) if library else ():
                self.relate(file, "CONTAINS", self.add_debian(owner))


def main(root, version, builds):
    seconds = int(os.environ["SOURCE_DATE_EPOCH"])
    time = datetime.datetime.fromtimestamp(seconds, datetime.timezone.utc)
    bill = Bill(version)
    for build in BUILDS:
        bill.add_headers(builds, build)
    for path in sorted(root.rglob("*")):
        if path.is_file() and not path.name.endswith((".spdx.json", "SHA256SUMS")):
            file = bill.add_file(path, root)
            if path.suffix == ".deb":
                bill.add_dependencies_of_deb(path, file)
            elif path.suffix == ".whl":
                bill.add_dependencies_of_wheel(path, file)
    sources = next(root.glob("winding-*.tar.gz"))
    document = {
        "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT",
        "name": f"winding-{version}",
        "documentNamespace": f"urn:sha256:{hashlib.sha256(sources.read_bytes()).hexdigest()}",
        "creationInfo": {"created": time.strftime("%Y-%m-%dT%H:%M:%SZ"),
                         "creators": ["Tool: packages/sbom.py"]},
        "documentDescribes": [identifier("winding")],
        "packages": [bill.packages[key] for key in sorted(bill.packages)],
        "files": bill.files,
        "relationships": [
            {"spdxElementId": first, "relationshipType": relation, "relatedSpdxElement": second}
            for first, relation, second in sorted(bill.relations)]}
    print(json.dumps(document, indent=2))


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), sys.argv[2], pathlib.Path(sys.argv[3]))
