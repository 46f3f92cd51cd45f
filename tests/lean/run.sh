#!/bin/sh
# tests/lean/run.sh [BUILD_FOLDER]: what a scene without phenomena costs, against a step that lacks them. Needs valgrind.
# Fails beyond 1 % of instructions, or when one block of memory more is taken.
set -e
build=${1:-build/release}
cmake --build "$build" --target lean lean_without >&2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
ticks=3000
instructions() {
  valgrind --tool=callgrind --callgrind-out-file="$work/out" --toggle-collect='cusp::test::run_ticks*' "$@" 2>"$work/log" >"$work/said"
  sed -n 's/^summary: *\([0-9]*\).*/\1/p' "$work/out"
}
program() { find "$build" -name "$1" -type f -perm -u+x | head -1; }
status=0
for method in surface occupancy; do
  with=$(instructions "$(program lean)" $method $ticks)
  cp "$work/said" "$work/with"
  without=$(instructions "$(program lean_without)" $method $ticks)
  cp "$work/said" "$work/without"
  all=$(instructions "$(program lean)" $method $ticks all)
  awk -v m=$method -v a="$with" -v b="$without" -v c="$all" -v n=$ticks 'BEGIN {
    printf "%s: %.1f instructions a tick, %.1f in a step that lacks phenomena: %+.4f %%; %.1f with all of them\n", m, a/n, b/n, 100*(a-b)/b, c/n
    exit (a-b)/b > 0.01 || (b-a)/b > 0.01 }' || status=1
  echo "  $(cat "$work/with")"
  cmp -s "$work/with" "$work/without" || { echo "  $(cat "$work/without") (lacking them)"; status=1; }
  echo "  $(cat "$work/said") (with all of them)"
done
exit $status
