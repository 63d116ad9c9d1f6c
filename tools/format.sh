#!/usr/bin/env bash
# Formats all code with clang-format 14 (.clang-format: 120 columns); `tools/format.sh --check` only says which files are not formatted.
# Files ending in .inc below scenes/ and tests/differential/idioms are SDL; those of tables are written by the programs that measure them.
set -euo pipefail
cd "$(dirname "$0")/.."
clang-format --version 2>/dev/null | grep -q 'version 14\.' ||
  { echo "clang-format 14 is not installed (other versions format otherwise): apt-get install clang-format-14"; exit 77; }
mapfile -t files < <(find tracer parser compare cli python tests bench tools -name '*.cpp' -o -name '*.h' -o -name '*.inc' |
  grep -v -e '^tests/differential/idioms/' -e '^bench/scenes/' -e 'noise_value_table.inc$' -e 'pavement_flags.inc$')
if [ "${1:-}" = --check ]; then
  clang-format --dry-run -Werror "${files[@]}"
else
  clang-format -i "${files[@]}"
fi
