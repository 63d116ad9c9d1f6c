#!/usr/bin/env bash
# Prints the value table of POV-Ray's noise as the C++ fragment tracer/noise/noise_value_table.inc (see README.md).
# usage: tools/measure_noise/measure.sh > tracer/noise/noise_value_table.inc
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$here/value_table.pov" "$work/"
(cd "$work" && HOME="$work" timeout 300 povray +Ivalue_table.pov +Oignored.png +W1 +H1 -D -GA +WT1 -F >povray.log 2>&1) || true
[ "$(wc -l < "$work/table.txt")" -eq 267 ] || { cat "$work/povray.log" >&2; echo "measurement failed" >&2; exit 1; }
echo "// Measured from POV-Ray 3.7.0.10 by tools/measure_noise; every entry is a decimal number of at most six significant digits."
awk '{ printf "%s%.6g,", (NR % 12 == 1 ? (NR > 1 ? "\n" : "") : " "), $1 } END { print "" }' "$work/table.txt"
