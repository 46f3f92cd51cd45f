#!/usr/bin/env bash
# Coverage-guided fuzzing of every own reader, SECONDS each; new finds go to build/fuzz/found, crashes beside them.
set -euo pipefail
cd "$(dirname "$0")/../.."
seconds=${1:-60}
for reader in nrrd_specimen nrrd_image metaimage binvox scenario; do
  mkdir -p "build/fuzz/found/$reader"
  echo "== $reader"
  "build/fuzz/fuzz_$reader" -max_total_time="$seconds" -max_len=4096 -rss_limit_mb=1024 -timeout=10 -print_final_stats=1 \
    -artifact_prefix="build/fuzz/found/$reader-" "build/fuzz/found/$reader" "tests/fuzz/corpora/$reader" 2>&1 | tail -n 12
done
