#!/usr/bin/env bash
# Nanoseconds per evaluation of patterns in POV-Ray, to set beside bench/textures_bench: the CPU time of ten million evaluations inside a user function,
# minus that of as many evaluations of the cheapest pattern (`planar`), which stands for the cost of the function itself.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
count=10000000
cpu_seconds() {
  cat > "$work/speed.pov" <<SCENE
#version 3.7;
#declare P = function { pattern { $1 } };
#declare Sum = function(n) { sum(i, 1, n, P(i*0.37 - 50, i*0.11 + 3, i*0.23 - 20)) };
#debug str(Sum($count), 0, 6)
SCENE
  (cd "$work" && TIMEFORMAT=%U && time HOME="$work" povray +Ispeed.pov +Oignored.png +W1 +H1 -D -GA +WT1 -F >/dev/null 2>&1) 2>&1
}
base=$(cpu_seconds planar)
for pattern in bozo "bozo noise_generator 3" "bozo turbulence 0.5" agate granite crackle wrinkles waves "wood turbulence 0.1"; do
  awk -v name="$pattern" -v t="$(cpu_seconds "$pattern")" -v b="$base" -v n=$count 'BEGIN { printf "%-28s %8.1f ns\n", name, (t - b) / n * 1e9 }'
done
