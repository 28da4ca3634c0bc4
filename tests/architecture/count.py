#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Counts lines, names and options of the sources at some commits, or of the working tree.

Reads the files that git tracks: C++ (.h, .cpp), TypeScript (.ts), Python (.py, .pyi). Rows that
name no other folder count reconstruct, io, evaluate and apps.
- A line with code and a comment counts as both. Docstrings are comments. Blank lines count as none.
- Types: definitions of struct, class, union and enum, also in functions and unnamed namespaces, by
  their last name; no specialisations. Aliases: `using NAME =` at namespace or class scope.
- Functions: bodies at namespace or class scope, so neither lambdas nor `= default`.
- Options: entries `Field{"name", ...}`. Fields: data members of structs called *Options. Those in
  no test and no document have a name that is neither a word nor a flag (--sun-step-deg) of a file
  in tests, README.md or docs/*.md.
- Lines of these documents: without tables, blocks of code and targets of links.
"""
import argparse
import io
import re
import subprocess
import tarfile
import tokenize
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping
from itertools import accumulate
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]
ROOMS = ("reconstruct", "io", "evaluate", "apps")
WIDTH = 100
COMMENT, LITERAL = "\1", '"'  # stand for each character of a comment or literal in Source.mask

Span = tuple[int, int, str]  # start, end, COMMENT or LITERAL
Places = dict[str, list[str]]  # of a name, as file:line

C_COMMENT = r"(?P<comment>//(?:\\\n|[^\n])*|/\*.*?\*/)"
QUOTED = r'"(?:\\.|[^"\\\n])*"' + r"|(?<![\da-fA-F])'(?:\\.|[^'\\\n])*'"  # no part of 1'000
RAW = r'(?<!\w)(?:u8|[uUL])?R"(?P<tag>[^()\s\\]*)\(.*?\)(?P=tag)"'
CPP = re.compile(f"{C_COMMENT}|{RAW}|{QUOTED}", re.S)
TEMPLATE = r"`(?:\\.|[^`\\])*`"
for _ in range(3):  # templates in ${} of templates
    INSIDE = rf"[^{{}}`\"']|{QUOTED}|{TEMPLATE}"
    TEMPLATE = rf"`(?:\\.|\$\{{(?:{INSIDE}|\{{(?:{INSIDE})*\}})*\}}|\$(?!\{{)|[^`\\$])*`"
REGEX = r"(?:(?<=[(,=:\[!&|?{;])|(?<=return))[ ]?/(?:\\.|\[(?:\\.|[^\]\\\n])*\]|[^/\\\n\[])+/"
TYPESCRIPT = re.compile(f"{C_COMMENT}|{QUOTED}|{TEMPLATE}|{REGEX}", re.S)

# Before a brace: a namespace, a type, a function, the value of a variable
NAMESPACE = re.compile(r'(?:\bnamespace\b[\w\s:]*|\bextern\s*""\s*)$')
TYPE = re.compile(r"\b(?:struct|class|union|enum(?:\s+(?:class|struct))?)\s+"
                  r"(?:\[\[.*?\]\]\s*)?(?:[\w<>, ]*::)?(\w+)\s*(?:final\s*)?(?::[^;{}()]*)?$")
FUNCTION = re.compile(r"\)\s*(?:(?:const|noexcept|override|final|&&?)\s*)*"
                      r"(?:->[^=]*|:\s.*[)}>])?\s*$", re.S)
VALUE = re.compile(r"^(?!.*\boperator\b)[^()]*=", re.S)
ALIAS = re.compile(r"\busing\s+(\w+)\s*=")
NO_FIELD = re.compile(r"\b(?:using|static|friend|operator)\b|^\s*$")
SUPERLATIVE = re.compile(r"\bk(?:Most|Least|Fewest|Farthest|Widest|Narrowest|Largest|Smallest"
                         r"|Longest|Shortest|Highest|Lowest)(?![a-z])\w*")
OPTION = re.compile(r'\bField\{\s*"(\w+)"')
FLAG = re.compile(r"(?<![\w-])--[a-z]")


class Source(NamedTuple):
    path: str
    text: str
    spans: list[Span]
    mask: str

    def place(self, offset: int) -> str:
        return f"{self.path}:{self.text.count(chr(10), 0, offset) + 1}"


def python_spans(text: str) -> Iterator[Span]:
    starts = list(accumulate((len(line) + 1 for line in text.split("\n")), initial=0))
    begin = (tokenize.ENCODING, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT)
    before = tokenize.ENCODING
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type in (tokenize.COMMENT, tokenize.STRING):
            start, end = (starts[row - 1] + column for row, column in (token.start, token.end))
            is_comment = token.type == tokenize.COMMENT or before in begin
            yield start, end, COMMENT if is_comment else LITERAL
        if token.type not in (tokenize.COMMENT, tokenize.NL):
            before = token.type


def read_source(path: str, text: str) -> Source:
    if path.endswith((".py", ".pyi")):
        spans = list(python_spans(text))
    else:
        tokens = (TYPESCRIPT if path.endswith(".ts") else CPP).finditer(text)
        spans = [(*token.span(), COMMENT if token["comment"] else LITERAL) for token in tokens]
    mask = list(text)
    for start, end, fill in spans:
        mask[start:end] = re.sub(r"\S", fill, text[start:end])
    return Source(path, text, spans, "".join(mask))


def contents(commit: str | None) -> Iterator[tuple[str, bytes]]:
    git = ["git", "-C", str(ROOT)]
    if commit is None:
        paths = subprocess.check_output([*git, "ls-files", "-z"]).decode().split("\0")
        yield from ((path, (ROOT / path).read_bytes()) for path in paths if (ROOT / path).is_file())
        return
    packed = subprocess.check_output([*git, "archive", commit])
    with tarfile.open(fileobj=io.BytesIO(packed)) as archive:
        for member in archive:
            if file := archive.extractfile(member):
                yield member.name, file.read()


def scope_of(head: str, outer: str) -> tuple[str, str]:
    """Kind and name of what the brace after `head` opens in a scope of kind `outer`."""
    if NAMESPACE.search(head):
        return "namespace", ""
    if named := TYPE.search(head):
        return "type", named[1]
    is_whole = outer in ("namespace", "type") and head.count("(") == head.count(")")
    is_value = VALUE.search(re.sub(r"\btemplate\s*<.*?>\s", "", head, flags=re.S))
    return "function" if is_whole and not is_value and FUNCTION.search(head) else "braces", ""


def stated(statement: str, kind: str, scope: str) -> tuple[str, str]:
    """Kind and name of what ends at a semicolon in a scope of this kind and name."""
    if kind in ("namespace", "type") and (alias := ALIAS.search(statement)):
        return "alias", alias[1]
    declared = re.sub(r"<.*>", "", re.split(r"[={\[]", statement)[0], flags=re.S)
    if not scope.endswith("Options") or NO_FIELD.search(statement) or "(" in declared:
        return "other", ""
    return "field", re.findall(r"\w+", declared)[-1]


def definitions(source: Source) -> Iterator[tuple[str, str, int]]:
    """Kind (type, function, alias, field ...), name and offset of what a C++ file defines."""
    code = re.sub(r"(?m)^[ \t]*#(?:\\\n|.)*", lambda directive: " " * len(directive[0]),
                  source.mask.replace(COMMENT, " "))
    scopes, head, at = [("namespace", "", "")], "", 0  # kind, name, what stands before the brace
    for mark in re.finditer("[{};]", code):
        head += code[at:mark.start()]
        at = mark.end()
        kind, name, before = scopes.pop() if mark[0] == "}" else scopes[-1]
        if mark[0] == "}":
            head = before + "{}" if kind == "braces" else ""
            continue
        found = scope_of(head, kind) if mark[0] == "{" else stated(head, kind, name)
        yield *found, mark.start()
        if mark[0] == "{":
            scopes.append((*found, head))
        head = ""


def lines_of(sources: Iterable[Source], fill: str, wider_than: int = 0) -> int:
    """Lines that hold comments (COMMENT) or code (LITERAL)."""
    lines = (line for source in sources for line in source.mask.split("\n"))
    return sum(len(line) > wider_than and
               (COMMENT in line if fill == COMMENT else line.replace(COMMENT, "").strip() != "")
               for line in lines)


def comment_share(sources: list[Source]) -> float:
    comments, code = (lines_of(sources, fill) for fill in (COMMENT, LITERAL))
    return comments / (comments + code)


def wide_lines(document: str) -> int:
    prose = re.sub(r"(?ms)^ *```.*?^ *```|\]\([^)]*\)|https?://\S+", "", document)
    return sum(len(line) > WIDTH and line.lstrip()[:1] != "|" for line in prose.split("\n"))


class Commit:
    def __init__(self, name: str | None) -> None:
        texts = {path: text.decode(errors="replace") for path, text in contents(name)}
        self.sources = [read_source(path, text) for path, text in texts.items()
                        if path.endswith((".h", ".cpp", ".ts", ".py", ".pyi"))]
        self.cpp = [source for source in self.within(*ROOMS) if source.path.endswith(("h", "cpp"))]
        self.documents = [texts[path] for path in texts if re.match(r"(README|docs/.*)\.md", path)]
        tests = [texts[path] for path in texts if path.startswith("tests/")]
        read = "\n".join(tests + self.documents)
        flags = {flag.replace("-", "_") for flag in re.findall(r"(?<![\w-])--([a-z][\w-]*)", read)}
        self.known = set(re.findall(r"\w+", read)) | flags
        self.defined: dict[str, Places] = defaultdict(lambda: defaultdict(list))
        for source in self.cpp:
            for kind, defined, offset in definitions(source):
                self.defined[kind][defined].append(source.place(offset))
            for option in OPTION.finditer(source.text):
                self.defined["option"][option[1]].append(source.place(option.start()))
        for source in self.within("io", "evaluate"):
            for start, end, fill in source.spans:
                if fill == LITERAL and FLAG.search(source.text, start, end):
                    self.defined["flag"][source.text[start:end]].append(source.place(start))

    def within(self, *folders: str) -> list[Source]:
        starts = tuple(folder + "/" for folder in folders)
        return [source for source in self.sources if source.path.startswith(starts)]

    def lists(self) -> dict[str, Places]:
        found = {"strings of io and evaluate with a flag": self.defined["flag"]}
        for kind, what in (("type", "types"), ("alias", "aliases")):
            found[f"names of {what} defined twice or more"] = {
                name: at for name, at in self.defined[kind].items() if len(at) > 1}
        for kind, what in (("option", "options"), ("field", "fields")):
            found[f"names of {what} in no test and no document"] = {
                name: at for name, at in self.defined[kind].items() if name not in self.known}
        return found

    def rows(self) -> dict[str, int]:
        ours, tests = self.within(*ROOMS), self.within("tests")
        n = Counter({kind: sum(map(len, found.values())) for kind, found in self.defined.items()})
        superlatives = set(SUPERLATIVE.findall("".join(source.mask for source in self.cpp)))
        return {"files": len(ours), "files of tests": len(tests),
                "lines of code": lines_of(ours, LITERAL),
                **{f"  {room}": lines_of(self.within(room), LITERAL) for room in ROOMS},
                "lines of code of tests": lines_of(tests, LITERAL),
                "lines of comments": lines_of(ours, COMMENT), "functions of C++": n["function"],
                "names of types": len(self.defined["type"]),
                "names of aliases": len(self.defined["alias"]),
                "options": n["option"], "fields of *Options": n["field"],
                **{what: len(names) for what, names in self.lists().items()},
                "names such as kMost, kLeast": len(superlatives),
                "comment lines over 100 columns": lines_of(ours, COMMENT, WIDTH),
                "comment lines of tests over 100 columns": lines_of(tests, COMMENT, WIDTH),
                "lines of documents over 100 columns": sum(map(wide_lines, self.documents))}

    def comment_shares(self) -> dict[str, str]:
        parts = [source.path.split("/")[:-1] for source in self.sources]
        folders = sorted({"/".join(part[:n]) for part in parts for n in (1, 2) if part})
        return {folder: f"{100 * comment_share(self.within(folder)):.2f} %" for folder in folders}


def print_table(title: str, columns: Mapping[str, Mapping[str, object]]) -> None:
    print(f"{title:44}", *(f"{head[:12]:>12}" for head in columns))
    for what in dict.fromkeys(what for column in columns.values() for what in column):
        print(f"{what:44}", *(f"{column.get(what, '-'):>12}" for column in columns.values()))


def main() -> None:
    parser = argparse.ArgumentParser(description="Counts lines, names and options of the sources.")
    parser.add_argument("commits", nargs="*", metavar="COMMIT", help="default: the working tree")
    parser.add_argument("--by-folder", action="store_true", help="the share of comments by folder")
    parser.add_argument("--list", action="store_true", help="names that are to be mended")
    given = parser.parse_args()
    commits = {name or "working tree": Commit(name) for name in given.commits or [None]}
    print_table("", {name: commit.rows() for name, commit in commits.items()})
    if given.by_folder:
        print_table("\ncomments, of lines of code and comments",
                    {name: commit.comment_shares() for name, commit in commits.items()})
    for name, commit in commits.items() if given.list else ():
        for what, names in commit.lists().items():
            print(f"\n{name}: {what}")
            for one, at in sorted(names.items()):
                print(f"  {' '.join(one.split())}: {', '.join(at)}")


if __name__ == "__main__":
    main()
