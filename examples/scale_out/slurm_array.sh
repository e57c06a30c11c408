#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A collection as an array of Slurm: each task of the array is one share of the meshes.
#   sbatch --array=1-1000 slurm_array.sh MESHES RESULTS [options of run]
#   sbatch --dependency=afterany:JOB slurm_array.sh MESHES RESULTS --table [options of run]      (the tables, when all are through)
# MESHES and RESULTS lie on a file system that all nodes see. REEBQUAD names the program. A task that is preempted, or whose node is
# lost, is queued again and goes on where it was: what has a record is done. Memory for each mesh: that of a core of the task.
#SBATCH --job-name=reebquad
#SBATCH --cpus-per-task=1
#SBATCH --requeue
#SBATCH --open-mode=append
set -u
meshes=$1 results=$2
shift 2
: "${REEBQUAD:=reebquad}"
if [ "${1:-}" = --table ]; then
  shift
  exec "$REEBQUAD" batch "$meshes" -o "$results" --table -- "$@"
fi
first=${SLURM_ARRAY_TASK_MIN:-1}
share=$((SLURM_ARRAY_TASK_ID - first + 1)) shares=${SLURM_ARRAY_TASK_COUNT:-1}
"$REEBQUAD" batch "$meshes" -o "$results" --shard "$share/$shares" --jobs "${SLURM_CPUS_PER_TASK:-1}" \
  --memory "${SLURM_MEM_PER_CPU:-0}" -- "$@"
status=$?
# 6 tells that meshes failed: they have a record, and a share with such meshes is no task that failed.
[ "$status" -eq 6 ] || exit "$status"
