#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What polhode is made of, as SPDX 2.3 and as CycloneDX 1.5: sbom.py SOURCE OUT writes OUT/polhode.{spdx,cdx}.json.

Libraries are those that the build links, with the versions that Debian has installed here; packages of the page are those
that the lock file pins. SOURCE_DATE_EPOCH dates it."""
import hashlib
import json
import os
import re
import subprocess
import sys
from datetime import datetime, timezone
from pathlib import Path

LINKED = {  # Debian package: license
    "libeigen3-dev": "MPL-2.0", "libboost-dev": "BSL-1.0", "libgsl-dev": "GPL-3.0-or-later", "libfmt-dev": "MIT",
    "libtomlplusplus-dev": "MIT", "libcli11-dev": "BSD-3-Clause", "nlohmann-json3-dev": "MIT", "libpugixml-dev": "MIT",
    "libpng-dev": "libpng-2.0", "zlib1g-dev": "Zlib", "pybind11-dev": "BSD-3-Clause"}
BUNDLED = ("echarts", "zrender", "tslib")


def components(source):
    """(name, version, license, package URL) of each."""
    for package, license in LINKED.items():
        version = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", package], capture_output=True, text=True)
        if version.returncode:
            sys.exit(f"sbom: the Debian package {package} is not installed")
        yield package, version.stdout, license, f"pkg:deb/debian/{package}@{version.stdout}"
    lock = json.loads((source / "reports/viewer/package-lock.json").read_text())["packages"]
    for package in BUNDLED:
        one = lock[f"node_modules/{package}"]
        yield package, one["version"], one["license"], f"pkg:npm/{package}@{one['version']}"


def spdx(version, when, parts):
    def package(key, name, number, license, url=None):
        out = {"SPDXID": f"SPDXRef-{key}", "name": name, "versionInfo": number, "licenseConcluded": license,
               "licenseDeclared": license, "downloadLocation": "NOASSERTION", "copyrightText": "NOASSERTION",
               "filesAnalyzed": False}
        if url:
            out["externalRefs"] = [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
                                    "referenceLocator": url}]
        return out
    digest = hashlib.sha256(repr((version, when, parts)).encode()).hexdigest()
    relations = [{"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES",
                  "relatedSpdxElement": "SPDXRef-polhode"}]
    relations += [{"spdxElementId": "SPDXRef-polhode", "relationshipType": "DEPENDS_ON",
                   "relatedSpdxElement": f"SPDXRef-{name}"} for name, *_ in parts]
    return {"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": "polhode",
            "documentNamespace": f"urn:polhode:sbom:{digest}",
            "creationInfo": {"created": when, "creators": ["Tool: polhode-sbom"]},
            "packages": [package("polhode", "polhode", version, "Apache-2.0")] +
                        [package(name, name, number, license, url) for name, number, license, url in parts],
            "relationships": relations}


def cyclonedx(version, when, parts):
    return {"bomFormat": "CycloneDX", "specVersion": "1.5", "version": 1,
            "metadata": {"timestamp": when,
                         "component": {"type": "application", "name": "polhode", "version": version, "bom-ref": "polhode",
                                       "licenses": [{"license": {"id": "Apache-2.0"}}]}},
            "components": [{"type": "library", "name": name, "version": number, "purl": url, "bom-ref": url,
                            "licenses": [{"license": {"id": license}}]} for name, number, license, url in parts],
            "dependencies": [{"ref": "polhode", "dependsOn": [url for *_, url in parts]}]}


def main(source, out):
    version = re.search(r"project\(polhode VERSION (\S+)", (source / "CMakeLists.txt").read_text()).group(1)
    when = datetime.fromtimestamp(int(os.environ["SOURCE_DATE_EPOCH"]), timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")
    parts = list(components(source))
    for name, made in (("spdx", spdx), ("cdx", cyclonedx)):
        (out / f"polhode.{name}.json").write_text(json.dumps(made(version, when, parts), indent=1) + "\n")
    print(f"{len(parts)} components")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(Path(sys.argv[1]), Path(sys.argv[2]))
