#!/usr/bin/env bash
# run.sh PROGRAMS READER SECONDS [SEED]: the reader's target, from what it tried before and from the seeds.
# PROGRAMS holds the targets; work (corpus, logs, finds) lies in PROGRAMS/work. With a seed it tries
# the same inputs in the same order as far as the seconds go, and starts from the seeds alone.
set -euo pipefail
programs=$(realpath "$1") reader=$2 seconds=$3
cd "$(dirname "$0")"
work=$programs/work
corpus=$work/corpus/$reader
if [ -n "${4:-}" ]; then
    corpus=$work/seeded/$reader
    rm -rf "$corpus"
fi
mkdir -p "$work/finds" "$corpus"
options=(-max_total_time="$seconds" -timeout=60 -rss_limit_mb=4096 -max_len=65536
    -artifact_prefix="$work/finds/$reader-" -print_final_stats=1 -seed="${4:-0}")
[ ! -f "dictionaries/$reader.dict" ] || options+=(-dict="dictionaries/$reader.dict")
export ASAN_OPTIONS=detect_container_overflow=0:allocator_may_return_null=1
if "$programs/fuzz_$reader" "${options[@]}" "$corpus" "$work/seeds/$reader" >"$work/$reader.log" 2>&1; then
    echo "$reader: $(sed -n "s/^stat::number_of_executed_units: */inputs tried: /p" "$work/$reader.log")"
else
    echo "$reader: FOUND SOMETHING"
    tail -n 60 "$work/$reader.log"
    exit 1
fi
