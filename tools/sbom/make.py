"""Writes what verisim is made of as SPDX 2.3 (JSON): make.py SOURCE_FOLDER VERSION OUTPUT. Run by the build.

components.tsv has one line a library: name, Debian's package with the files that the build takes, licence (SPDX), how it
is used, what for. Versions are those of the packages on this machine. The same packages give the same bytes: the
date is that of debian/changelog.
"""
import email.utils
import hashlib
import json
import os
import subprocess
import sys
import uuid
from datetime import timezone


def versions(packages):
    """By package; empty where there is no dpkg or no such package."""
    try:
        shown = subprocess.run(["dpkg-query", "-W", "-f=${Package}\t${Version}\n", *packages], capture_output=True, text=True, check=False).stdout
    except FileNotFoundError:
        return {}
    return dict(line.split("\t") for line in shown.splitlines() if "\t" in line)


def components(folder):
    with open(os.path.join(folder, "tools/sbom/components.tsv"), encoding="utf-8") as table:
        rows = [line.rstrip("\n").split("\t") for line in table if line.strip() and not line.startswith("#")]
    return [dict(zip(("name", "package", "licence", "use", "purpose"), row)) for row in rows]


def date_of_release(folder):
    with open(os.path.join(folder, "debian/changelog"), encoding="utf-8") as log:
        line = next(line for line in log if line.startswith(" -- "))
    date = email.utils.parsedate_to_datetime(line.split(">", 1)[1].strip())
    return date.astimezone(timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")


def document(folder, version):
    parts = components(folder)
    known = versions([part["package"] for part in parts])
    packages = [{"SPDXID": "SPDXRef-verisim", "name": "verisim", "versionInfo": version, "downloadLocation": "NOASSERTION",
                 "filesAnalyzed": False, "licenseConcluded": "Apache-2.0", "licenseDeclared": "Apache-2.0", "copyrightText": "NOASSERTION",
                 "primaryPackagePurpose": "APPLICATION"}]
    relations = [{"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES", "relatedSpdxElement": "SPDXRef-verisim"}]
    kinds = {"static": "STATIC_LINK", "dynamic": "DYNAMIC_LINK", "headers": "CONTAINS", "plug-in": "OPTIONAL_COMPONENT_OF", "build": "BUILD_TOOL_OF", "program": "RUNTIME_DEPENDENCY_OF"}
    for part in parts:
        identity = "SPDXRef-" + "".join(c if c.isalnum() else "-" for c in part["name"])
        there = known.get(part["package"])
        entry = {"SPDXID": identity, "name": part["name"], "versionInfo": there or "NOASSERTION", "downloadLocation": "NOASSERTION", "filesAnalyzed": False,
                 "licenseConcluded": part["licence"], "licenseDeclared": part["licence"], "copyrightText": "NOASSERTION", "comment": f"{part['use']}: {part['purpose']}"}
        if there:
            entry["externalRefs"] = [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
                                      "referenceLocator": f"pkg:deb/debian/{part['package']}@{there.replace(':', '%3A').replace('+', '%2B')}"}]
        packages.append(entry)
        kind = kinds[part["use"]]
        ends = (identity, "SPDXRef-verisim") if kind.endswith("_OF") else ("SPDXRef-verisim", identity)
        relations.append({"spdxElementId": ends[0], "relationshipType": kind, "relatedSpdxElement": ends[1]})
    digest = hashlib.sha256(json.dumps(packages, sort_keys=True).encode()).digest()
    return {"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"verisim-{version}",
            "documentNamespace": f"urn:uuid:{uuid.UUID(bytes=digest[:16], version=5)}",
            "creationInfo": {"created": date_of_release(folder), "creators": ["Tool: verisim-tools-sbom"]}, "packages": packages, "relationships": relations}


def main():
    folder, version, output = sys.argv[1:]
    with open(output, "w", encoding="utf-8") as file:
        json.dump(document(folder, version), file, indent=1)
        file.write("\n")


if __name__ == "__main__":
    main()
