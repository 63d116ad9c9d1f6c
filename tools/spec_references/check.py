#!/usr/bin/env python3
"""Follows every reference from the code to the specification in docs/spec: "spec 05 section 8", "spec 03 5.3, 5.4; 06 6.1", "spec 08 A".

usage: check.py [ROOT]
Fails (exit status 1) with file:line for a reference to a section that no document has, and for a section without its anchor.
A section is a heading that begins with its number (or letter); it has the anchor `s` + number (`<a id="s4.2"></a>`), so that
docs/spec/05-textures-patterns.md#s4.2 stays when the heading is worded otherwise. "4.2.5" may also be item 5 of the list in section 4.2.
"""
import pathlib
import re
import sys

CODE = ("tracer", "parser", "compare", "cli", "tests", "bench", "tools", "docs", "python")
SUFFIXES = (".h", ".cpp", ".inc", ".py", ".md", ".txt", ".cmake")
HEADING = re.compile(r'#{2,} (?:<a id="(?P<anchor>[^"]*)"></a>)?(?P<number>\d+(?:\.\d+)*|[A-Z])(?:[. ]|$)')
ITEM = re.compile(r"(?P<number>\d+)\. |[-*] \*\*(?P<letter>[A-Z])\*\* ")
REFERENCE = re.compile(r"\b[Ss]pec(?:ification)?s? (?=0[1-9]\b)")
GAP = re.compile(r"[ \t]*(?:\n\s*(?:(?://+|#)\s*)?)?")  # a comment may break a reference over lines
TOKEN = re.compile(
    r"(?P<document>0[1-9]\b)|(?P<section>\d+(?:\.\d+)*)|(?P<letter>[A-Z]\b)|(?:sections?|and|to|or)\b|[,;]"
)


def sections(text):
    """The sections of a document, and (line, number) of those whose heading lacks its anchor."""
    found, bare, code, heading = set(), [], False, ""
    for line_number, line in enumerate(text.splitlines(), 1):
        code ^= line.startswith("```")
        if code:
            continue
        if match := HEADING.match(line):
            heading = match["number"]
            found.add(heading)
            if match["anchor"] != "s" + heading:
                bare.append((line_number, heading))
        elif match := ITEM.match(line):
            found.add(match["letter"] or f"{heading}.{match['number']}")
    return found, bare


def references(text):
    """(offset, document, section) of each section that a text names; section is None where it names a whole document."""
    for start in REFERENCE.finditer(text):
        place, document = start.end(), None
        while token := TOKEN.match(text, GAP.match(text, place).end()):
            if token["document"]:
                document = token["document"]
                yield start.start(), document, None
            elif token["section"] or (token["letter"] and document == "08"):
                yield start.start(), document, token[0]
            elif token["letter"]:
                break
            place = token.end()


def check(root):
    """The faults of the tree below `root`, as lines of text."""
    known, faults = {}, []
    for path in sorted((root / "docs/spec").glob("0*.md")):
        known[path.name[:2]], bare = sections(path.read_text(encoding="utf-8"))
        faults += [f"docs/spec/{path.name}:{line}: section {section} lacks its anchor s{section}" for line, section in bare]
    for path in sorted(p for folder in CODE for p in (root / folder).rglob("*") if p.suffix in SUFFIXES):
        if path.parent.name == "spec_references":
            continue  # examples of faults
        text = path.read_text(encoding="utf-8", errors="replace")
        for offset, document, section in references(text):
            if document not in known or (section and section not in known[document]):
                line = text.count("\n", 0, offset) + 1
                what = f"section {section} in specification" if section else "specification"
                faults.append(f"{path.relative_to(root).as_posix()}:{line}: there is no {what} {document}")
    return faults


if __name__ == "__main__":
    found = check(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "."))
    print("\n".join(found) or "Every reference to docs/spec leads somewhere.")
    sys.exit(bool(found))
