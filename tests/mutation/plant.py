#!/usr/bin/env python3
"""Plants bugs in fumon, one at a time, and tells which of them its fast tests see.

    tests/mutation/plant.py                 plants the forty bugs of the committed seed and writes results.md anew
    tests/mutation/plant.py --list          only lists them
    tests/mutation/plant.py --only 3 17     only these two, on the terminal

A bug is one change of one line of a room's .cpp file: an operator, a sign, an index, a dropped statement, a unit. Sites are
drawn by a hash of the seed, the file and the line, so that a site stays drawn as long as its line stays. What is drawn is
spread over all rooms, one each before any gets a second. A bug is looked for by the tests of its room; if these pass, by all
fast tests. Sites at which no test could see a change are named, with the reason, in equivalent.txt; the next one of the same
room takes their place, as it does where a changed line does not compile.

Works on a copy in build/mutation (or the folder FUMON_MUTATION), and leaves the sources alone. Mutated programs run without further protection: run it
where nothing can be lost. Takes an hour on two cores.
"""

import argparse
import hashlib
import os
import re
import resource
import shutil
import subprocess
import sys
import time
from collections import namedtuple
from pathlib import Path

SEED = 20261122
COUNT = 40
SECONDS = 400  # of one run of tests: a bug that makes them hang is seen
MEMORY = 6 << 30  # bytes of a mutated program

HERE = Path(__file__).resolve().parent
TOP = HERE.parent.parent
COPY = Path(os.environ.get("FUMON_MUTATION", TOP / "build/mutation"))
BUILD = COPY / "build/dev"

GROUPS = {  # of tests/CMakeLists.txt: the executable that tests a room, by the beginning of its path
    "core": ("base", "numerics", "keys", "files", "measure", "scene"),
    "models": ("vectors", "models"),
    "render": ("gl", "render"),
    "pictures": ("picture", "figure"),
    "runs": ("outputs", "run", "hop_law", "sweep", "paper", "verify", "cli"),
}

# Each kind of bug: a name and the changes that it makes, as (pattern, replacement) on a line whose texts are blanked.
SWAPS = [("nx", "ny"), ("dx", "dy"), ("row", "column"), ("width", "height"), ("minimum", "maximum"), ("min", "max"),
         ("front", "back"), ("begin", "end"), ("sin", "cos"), ("floor", "ceil"), ("left", "right"), ("x", "y"),
         ("first", "last"), ("low", "high"), ("lowest", "highest"), ("metres", "sites")]
KINDS = {
    "operator": [(rf" {re.escape(a)} ", f" {b} ") for a, b in
                 [("+", "-"), ("-", "+"), ("*", "/"), ("/", "*"), ("&&", "||"), ("||", "&&"), ("+=", "-="), ("-=", "+="), ("%", "/")]],
    "comparison": [(rf" {re.escape(a)} ", f" {b} ") for a, b in
                   [("<", "<="), ("<=", "<"), (">", ">="), (">=", ">"), ("==", "!="), ("!=", "=="), ("<", ">"), (">", "<")]],
    "sign": [(r"(?<=[(=,] )-(?=[\w(])|(?<=return )-(?=[\w(])|(?<=\()-(?=[\w(])", ""), (r"(?<![\w)])!(?=[\w(])", "")],
    "index": [(r" \+ 1\b(?![.\w])", ""), (r" - 1\b(?![.\w])", ""), (r"\[0\]", "[1]"), (r"(?<= = )0(?=; )", "1"),
              (r"(?<= )1(?=[;,)])", "2"), (r"(?<=[(, ])0\.5(?=[ ;,)])", "0.25"), (r"(?<=[(, ])2\.0(?=[ ;,)])", "1.0")],
    "name": [(rf"\b{a}\b", b) for pair in SWAPS for a, b in (pair, pair[::-1])] + [(r"\btrue\b", "false"), (r"\bfalse\b", "true")],
    "dropped": [(r"^\s+(?!return|throw|const|auto|using|case|if|else|for|while|\+\+)[\w.\[\]()>*-]+ [-+*|&]?= [^;{}]+;$", ";"),
                (r"^\s+(?!return|throw|if|for|while|switch|else)[\w.:>-]+\([^;{}]*\);$", ";"), (r"^\s+(continue|break);$", ";")],
    "unit": [(r"\b1000(\.0)?\b", r"100\1"), (r"\b100(\.0)?\b", r"1000\1"), (r"\b60(\.0)?\b", r"3600\1"), (r"\b180(\.0)?\b", r"360\1"),
             (r"\b1e-3\b", "1e-2"), (r"\b1024\b", "1000")],
}

Site = namedtuple("Site", "room file line kind before after order")


def without_texts(line):
    """A line with its string and character texts and its comment blanked, of the same length."""
    line = re.sub(r'"(\\.|[^"\\])*"|\'(\\.|[^\'\\])*\'', lambda found: "\0" * len(found.group()), line)
    return re.sub(r"//.*", lambda found: "\0" * len(found.group()), line)


def number(*what):
    return hashlib.sha256("\n".join(map(str, what)).encode()).hexdigest()


def sites_of(file, seed):
    """Every place of a file where a bug can be planted."""
    room = str(file.parent.relative_to(TOP / "src"))
    lines = file.read_text().splitlines()
    seen = {}
    inside_comment = raw = False
    for index, line in enumerate(lines):
        code = without_texts(line)
        if raw or re.search(r'\bR"\w*\(', line):
            raw = not re.search(r'\)\w*"', line.split('R"')[-1])
            continue
        if line.lstrip().startswith(("#", "static_assert", "using ", "namespace", "template", "FUMON_")):
            continue
        inside_comment = inside_comment or code.lstrip().startswith("/*")
        if inside_comment or not code.strip("\0 "):
            inside_comment = inside_comment and "*/" not in code
            continue
        for kind, changes in KINDS.items():
            for pattern, replacement in changes:
                for found in re.finditer(pattern, code):
                    if "\0" in found.group() and kind != "dropped":
                        continue
                    after = line[: found.start()] + found.expand(replacement) + line[found.end():]
                    nth = seen[(line, after)] = seen.get((line, after), 0) + 1
                    name = file.relative_to(TOP)
                    yield Site(room, name, index, kind, line, after, number(seed, name, line, after, nth))


def drawn(seed, count):
    """For every room its sites in the order in which they are drawn, kinds in turn, and how many it gives."""
    rooms = {}
    for file in sorted((TOP / "src").rglob("*.cpp")):
        if file.parent != TOP / "src":
            for site in sites_of(file, seed):
                rooms.setdefault(site.room, []).append(site)
    for room, sites in rooms.items():
        turns = {}
        for site in sorted(sites, key=lambda site: site.order):
            turns.setdefault(site.kind, []).append(site)
        kinds = sorted(turns, key=lambda kind: number(seed, room, kind))
        rooms[room] = [turns[kind][turn] for turn in range(len(sites)) for kind in kinds if turn < len(turns[kind])]
    by_size = sorted(rooms, key=lambda room: (-len(rooms[room]), room))
    shares = {room: 0 for room in rooms}
    for turn in range(count):
        shares[by_size[turn % len(by_size)]] += 1
    return rooms, shares


def named_equivalent():
    """The changes of equivalent.txt: "file | line before | line after | why", with spaces around them left out."""
    file = HERE / "equivalent.txt"
    names = {}
    for line in file.read_text().splitlines() if file.exists() else []:
        if line.strip() and not line.startswith("#"):
            name, before, after, why = (part.strip() for part in line.split(" ¦ "))
            names[(name, before, after)] = why
    return names


def run(command, seconds=None, **more):
    def limit():
        os.setsid()
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                          preexec_fn=limit if seconds else None, **more) as process:
        try:
            output, _ = process.communicate(timeout=seconds)
            return process.returncode, output
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, 9)
            process.communicate()
            return None, f"did not end within {seconds} s"


def build(*targets):
    return run(["cmake", "--build", str(BUILD), "--target", *targets])


def group_of(room):
    return next(group for group, rooms in GROUPS.items() if room.split("/")[0] in rooms)


def suites_of(room):
    """The suites of the tests of a room; of the room around it, where it has none."""
    folder = COPY / "tests" / room
    while not list(folder.glob("*_test.cpp")):
        folder = folder.parent
    text = "".join(file.read_text() for file in folder.glob("*_test.cpp"))
    return sorted(set(re.findall(r"^TEST(?:_F|_P)?\((\w+),", text, re.M)))


def failed_tests(output):
    found = re.findall(r"^\[  FAILED  \] ([\w/.]+)", output, re.M) or re.findall(r"- ([\w.]+) \((?:Failed|Timeout|SEGFAULT|.*)\)", output)
    return sorted(set(found))


def look_for(site):
    """What sees a planted bug: ("does not compile" | "caught" | "SURVIVED", by what)."""
    file = COPY / site.file
    lines = file.read_text().splitlines(keepends=True)
    lines[site.line] = site.after + "\n"
    whole = file.read_text()
    try:
        file.write_text("".join(lines))
        group = group_of(site.room)
        status, output = build(f"fumon_{group}_tests")
        if status != 0:
            return "does not compile", ""
        suites = ":".join(f"{suite}.*:*/{suite}.*" for suite in suites_of(site.room))
        status, output = run([str(BUILD / f"tests/fumon_{group}_tests"), f"--gtest_filter={suites}", "--gtest_brief=1"], SECONDS)
        if status != 0:
            names = failed_tests(output)
            return "caught", f"{group}: {names[0]}{f' and {len(names) - 1} more' if len(names) > 1 else ''}" if names else f"{group}: a crash or hang"
        build("all")
        status, output = run(["ctest", "--test-dir", str(BUILD), "-LE", "slow", "-j2", "--stop-on-failure"], 4 * SECONDS)
        names = failed_tests(output)
        return ("SURVIVED", "") if status == 0 else ("caught", "all fast tests: " + (names[0] if names else "a crash or hang"))
    finally:
        file.write_text(whole)


def prepare():
    shutil.rmtree(COPY, ignore_errors=True)
    COPY.mkdir(parents=True)
    files = subprocess.run(["git", "ls-files"], cwd=TOP, capture_output=True, text=True, check=True).stdout.splitlines()
    for name in files:
        (COPY / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(TOP / name, COPY / name)
    configure = ["cmake", "-S", str(COPY), "-B", str(BUILD), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                 "-DCMAKE_CXX_FLAGS_RELEASE=-O1", *os.environ.get("FUMON_CMAKE_OPTIONS", "").split()]
    for command in (configure, ["cmake", "--build", str(BUILD)]):
        status, output = run(command)
        if status != 0:
            sys.exit(output)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seed", type=int, default=SEED)
    parser.add_argument("--count", type=int, default=COUNT)
    parser.add_argument("--list", action="store_true", help="only list what would be planted")
    parser.add_argument("--only", type=int, nargs="+", metavar="N", help="plant these alone, and write no results.md")
    given = parser.parse_args()

    rooms, shares = drawn(given.seed, given.count)
    equivalent = named_equivalent()
    if not given.list:
        prepare()
    rows, planted = [], 0
    for room in sorted(rooms):
        left = shares[room]
        for site in rooms[room]:
            if left == 0:
                break
            change = (str(site.file), site.before.strip(), site.after.strip())
            if change in equivalent:
                continue
            if given.only and planted + 1 not in given.only:
                planted, left = planted + 1, left - 1
                continue
            began = time.monotonic()
            verdict, by = ("", "") if given.list else look_for(site)
            if verdict == "does not compile":
                continue
            planted, left = planted + 1, left - 1
            rows.append((planted, *change, f"{site.file}:{site.line + 1}", site.kind, verdict, by))
            print(f"{planted:3} {site.file}:{site.line + 1} [{site.kind}] {verdict} {by} ({time.monotonic() - began:.0f} s)\n"
                  f"      - {change[1]}\n      + {change[2]}", flush=True)
    if given.list or given.only:
        return
    caught = sum(row[6] == "caught" for row in rows)
    with open(HERE / "results.md", "w") as file:
        file.write(f"# Planted bugs, seed {given.seed}\n\nWritten by plant.py: **{caught} of {len(rows)} caught by the fast tests.**\n\n"
                   "| | where | before | after | seen by |\n|---|---|---|---|---|\n")
        code = lambda text: "`" + text.replace("|", "\\|") + "`"
        for n, name, before, after, where, kind, verdict, by in rows:
            file.write(f"| {n} | {name} | {code(before)} | {code(after) if after != ';' else 'dropped'} | {by or verdict} |\n")
    print(f"{caught} of {len(rows)} caught")


if __name__ == "__main__":
    main()
