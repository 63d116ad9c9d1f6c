#!/usr/bin/env python3
"""Lines of at most 120 columns and functions of at most 80 lines, in all C++ code of the repository: check.py ROOT.

A function is a body in braces at the level of namespaces and classes; its lines are counted from the brace that opens it to the one
that closes it, lambdas and local classes within it included. Tests' tables of measured values are no functions that somebody has to
follow: in *_test.cpp only columns count. Files that programs write are left out. Exits 1 and lists what is longer."""
import pathlib
import re
import subprocess
import sys

COLUMNS = 120
LINES = 80
MADE_BY_PROGRAMS = ("noise_value_table.inc", "pavement_flags.inc")
FOLDERS = ("tracer", "parser", "compare", "cli", "python", "tests", "bench", "tools", "include")
NOT_CPP = ("tests/differential/idioms/", "bench/scenes/")  # .inc files of SDL

TOKENS = re.compile(
    r'(?P<raw>\bR"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)")|(?P<string>"(?:\\.|[^"\\\n])*")|(?P<char>(?<![0-9A-Fa-f])\'(?:\\.|[^\'\\\n])+\')'
    r"|(?P<comment>//[^\n]*|/\*.*?\*/)|(?P<directive>^[ \t]*#(?:\\\n|[^\n])*)",
    re.DOTALL | re.MULTILINE)


def code_of(text):
    """The text with literals emptied, and comments and directives of the preprocessor blanked; lines stay where they are.
    Of branches of #if only the first is kept, so that braces match."""
    ways = []  # of each open #if: whether its first branch is being read

    def blank(match):
        found = match[0]
        if match["directive"]:
            word = re.match(r"[ \t]*#[ \t]*(\w*)", found)[1]
            if word in ("if", "ifdef", "ifndef"):
                return "\x01" + "\n" * found.count("\n")
            if word in ("else", "elif"):
                return "\x02" + "\n" * found.count("\n")
            if word == "endif":
                return "\x03" + "\n" * found.count("\n")
            return "\n" * found.count("\n")
        literal = '""' if match["raw"] or match["string"] or match["char"] else " "
        return literal + "\n" * found.count("\n")

    result = []
    for piece in re.split("([\x01\x02\x03])", TOKENS.sub(blank, text)):
        if piece == "\x01":
            ways.append(True)
        elif piece == "\x02" and ways:
            ways[-1] = False
        elif piece == "\x03" and ways:
            ways.pop()
        elif all(ways):
            result.append(piece)
        else:
            result.append("\n" * piece.count("\n"))
    return "".join(result)


def closing_brace(code, start):
    depth = 0
    for match in re.compile(r"[{}]").finditer(code, start):
        depth += 1 if match[0] == "{" else -1
        if depth == 0:
            return match.start()
    return len(code)


def without_brackets(statement):
    """A statement without what stands in parentheses (as `()`)."""
    while True:
        shorter = re.sub(r"\([^()]+\)", "()", statement)
        if shorter == statement:
            return statement
        statement = shorter


def opens_scope(statement):
    return bool(re.search(r"\b(namespace|class|struct|union|enum)\b|\bextern \"\"", re.sub(r"template\s*<.*?>", "", statement))
                and not statement.rstrip().endswith(")") or re.fullmatch(r'\s*extern ""\s*', statement))


def opens_function(statement):
    """Whether a brace behind this, at the level of namespaces and classes, opens a body."""
    plain = without_brackets(statement)
    plain = re.sub(r"operator\s*\(\)", "operator", plain)
    if "()" not in plain or re.search(r"(?<![=<>!])=(?!=)", re.sub(r"operator\s*[=<>!+*/&|^%-]+|template\s*<[^>]*>", "", plain)):
        return False
    # In a constructor's list a brace behind a name is a member's value; behind the last member's it is the body.
    members = re.search(r"\)\s*(noexcept\s*)?:(?!:)", plain)
    return not (members and re.search(r"[\w>]\s*$", plain) and not re.search(r"[})]\s*$", plain))


def functions(text):
    """(line, lines, head) of each function."""
    code = code_of(text)
    place, start = 0, 0
    while match := re.compile(r"[{};]").search(code, place):
        place = match.end()
        if match[0] != "{":
            start = place
            continue
        statement = code[start:match.start()]
        if opens_scope(statement):
            start = place
            continue
        end = closing_brace(code, match.start())
        if opens_function(statement):
            line = code.count("\n", 0, match.start()) + 1
            yield line, code.count("\n", match.start(), end) + 1, " ".join(statement.split())
            start = end + 1
        else:
            code = code[:match.start()] + " " * 1 + re.sub(r"[^\n]", " ", code[match.start() + 1:end]) + ")" + code[end + 1:]
        place = end + 1


def too_long(name, text):
    """What is too long in a file, as messages."""
    for number, line in enumerate(text.split("\n"), 1):
        if len(line) > COLUMNS:
            yield f"{name}:{number}: {len(line)} columns"
    if not name.endswith("_test.cpp"):
        for line, lines, head in functions(text):
            if lines > LINES:
                yield f"{name}:{line}: {lines} lines: {head[-80:]}"


def main():
    root = pathlib.Path(sys.argv[1])
    files = sorted(f for folder in FOLDERS for f in (root / folder).rglob("*") if f.suffix in (".cpp", ".h", ".inc"))
    names = [f.relative_to(root).as_posix() for f in files]
    found = 0
    for name, file in zip(names, files):
        if name.startswith(NOT_CPP) or name.endswith(MADE_BY_PROGRAMS):
            continue
        for message in too_long(name, file.read_text(encoding="utf-8")):
            print(message)
            found += 1
    if not any(names):
        sys.exit("no code found")
    print(f"{len(names)} files: {found} too long" if found else f"{len(names)} files, nothing too long")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
