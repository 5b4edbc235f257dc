#!/usr/bin/env python3
"""tests/bench/table.py: the benchmarks' results, one CSV file a machine in results/, as the tables of README.md.

    tests/bench/table.py            writes them into README.md, between its two marks
    tests/bench/table.py --check    exits with 1 where README.md has others
    tests/bench/table.py --add FILE TARGET MACHINE < ROWS
                                    puts the CSV rows of one vector target into a machine's file, in the place of its former ones
"""
import csv
import pathlib
import re
import sys

here = pathlib.Path(__file__).parent
columns = ["target", "row", "unit", "fumon", "plain", "ratio"]
marks = "<!-- tables of results/ -->", "<!-- end of the tables -->"


def read(file):
    """What the file says of its machine, and its rows."""
    lines = file.read_text(encoding="utf-8").splitlines()
    machine = [line[2:] for line in lines if line.startswith("# ")]
    return machine, list(csv.DictReader(line for line in lines if not line.startswith("#")))


def add(file, target, machine):
    said, rows = read(file) if file.exists() else ([], [])
    said = [line for line in said if not line.startswith(f"{target}: ")] + [f"{target}: {machine}"]
    rows = [row for row in rows if row["target"] != target] + list(csv.DictReader(sys.stdin, columns))
    file.parent.mkdir(exist_ok=True)
    with file.open("w", encoding="utf-8", newline="") as out:
        out.writelines(f"# {line}\n" for line in said)
        writer = csv.DictWriter(out, columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def table(file):
    machine, rows = read(file)
    targets = list(dict.fromkeys(row["target"] for row in rows))
    found = {(row["row"], row["target"]): row for row in rows}
    names = dict.fromkeys((row["row"], row["unit"]) for row in rows)
    lines = [f"### {file.stem}", "", *(f"* {line}" for line in machine), ""]
    lines.append("| row | unit | " + " | ".join(f"fumon, {t} | plain, {t} | ratio" for t in targets) + " |")
    lines.append("|---|---" + "|---" * 3 * len(targets) + "|")
    for name, unit in names:
        cells = (found.get((name, target), {}).get(column, "") for target in targets for column in columns[3:])
        lines.append(f"| {name} | {unit} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def main():
    if sys.argv[1:2] == ["--add"]:
        add(pathlib.Path(sys.argv[2]), sys.argv[3], sys.argv[4])
        return 0
    page = here / "README.md"
    text = page.read_text(encoding="utf-8")
    tables = "\n\n".join(table(file) for file in sorted((here / "results").glob("*.csv")))
    new = re.sub(f"{marks[0]}.*?{marks[1]}", lambda _: f"{marks[0]}\n{tables}\n{marks[1]}", text, flags=re.S)
    if "--check" not in sys.argv:
        page.write_text(new, encoding="utf-8")
        return 0
    if new != text:
        print("tests/bench/README.md has other tables than tests/bench/results; tests/bench/table.py writes them", file=sys.stderr)
    return int(new != text)


sys.exit(main())
