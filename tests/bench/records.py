#!/usr/bin/env python3
"""tests/bench/records.py FILE TARGET MACHINE < records_bench's JSON: puts what records cost into a machine's CSV file in
results/records/, in the place of the former rows of that vector target, and draws README.md's table of them anew."""
import csv
import json
import pathlib
import re
import sys

here = pathlib.Path(__file__).parent
columns = ["target", "row", "ns a cell", "processor ratio", "clock ratio"]
marks = "<!-- table of results/records/ -->", "<!-- end of the table of records -->"


def rows_of(text, target):
    for row in json.loads(text[text.index("{"):])["benchmarks"]:
        name = re.sub("/(iterations|real_time).*", "", row["name"])
        cell = "%.1f" % (1e9 * row["seconds_a_cell"]) if "seconds_a_cell" in row else ""
        ratios = ("%.2f" % row[key] if key in row else "" for key in ("ratio_of_processor", "ratio_of_clock"))
        yield dict(zip(columns, (target, name, cell, *ratios)))


def main():
    file, target, machine = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3]
    former = file.read_text(encoding="utf-8").splitlines() if file.exists() else []
    said = [line for line in former if line.startswith("# ") and not line.startswith(f"# {target}: ")] + [f"# {target}: {machine}"]
    rows = [row for row in csv.DictReader(line for line in former if not line.startswith("#")) if row["target"] != target]
    rows += rows_of(sys.stdin.read(), target)
    file.parent.mkdir(parents=True, exist_ok=True)
    with file.open("w", encoding="utf-8", newline="") as out:
        out.writelines(f"{line}\n" for line in said)
        writer = csv.DictWriter(out, columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    lines = [f"{line[2:]}." for line in said]
    lines += ["", "| " + " | ".join(columns) + " |", "|---" * len(columns) + "|"]
    lines += ["| " + " | ".join(row.values()) + " |" for row in rows]
    page = here / "README.md"
    text = page.read_text(encoding="utf-8")
    table = "\n".join([marks[0], *lines, marks[1]])
    page.write_text(re.sub(f"{marks[0]}.*?{marks[1]}", lambda _: table, text, flags=re.S), encoding="utf-8")


main()
