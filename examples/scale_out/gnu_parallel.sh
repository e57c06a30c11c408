#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A collection in shares by GNU parallel, on this machine or, with `--sshloginfile hosts`, on several that see the same folders.
#   gnu_parallel.sh MESHES RESULTS SHARES [options of run]
# REEBQUAD names the program, PARALLEL_OPTIONS has more options of parallel. Start it again after whatever ended it: what is done is
# done. Shares are tried again (--retries) where a machine or a process was lost.
set -eu
meshes=$1 results=$2 shares=$3
shift 3
: "${REEBQUAD:=reebquad}"
# 6 tells that meshes failed: they have a record, and a share with such meshes is no share that failed.
share='"$0" batch "$1" -o "$2" --shard "$3" --jobs 1 --quiet -- "${@:4}" || [ $? -eq 6 ]'
# shellcheck disable=SC2086
seq 1 "$shares" | parallel --quote --retries 3 ${PARALLEL_OPTIONS:-} \
  bash -c "$share" "$REEBQUAD" "$meshes" "$results" "{}/$shares" "$@"
"$REEBQUAD" batch "$meshes" -o "$results" --quiet -- "$@"
