#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# on_parallel.sh PROGRAM EXAMPLES: shares by GNU parallel; a share's process is killed.
set -u
export REEBQUAD=$1 PARALLEL_HOME=/nonexistent PARALLEL_OPTIONS="--will-cite -j 2"
. "$(dirname "$0")/common.sh"
trap 'rm -rf "$work"' EXIT
parallel --version 2>/dev/null | grep -q GNU || skip "GNU parallel is not installed"
make_meshes
"$2/gnu_parallel.sh" "$work/in" "$results" 4 "${options[@]}" >"$work/log" 2>&1 &
run=$!
wait_for_a_record
victim=$(pgrep -f -- "batch $work/in .*--shard" | while read -r pid; do
  [ "$(readlink "/proc/$pid/exe")" = "$(readlink -f "$REEBQUAD")" ] && echo "$pid"
done | head -n 1)
[ -n "$victim" ] && kill -9 "$victim" || fail "no process to kill"
wait "$run" || { cat "$work/log"; fail "parallel ended with $?"; }
check_results
