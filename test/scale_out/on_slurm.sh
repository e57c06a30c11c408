#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# on_slurm.sh PROGRAM EXAMPLES: an array of Slurm on a cluster that is this machine alone, with daemons, ports and folders of its own; a
# task is taken from its node and queued again.
set -u
export REEBQUAD=$1
. "$(dirname "$0")/common.sh"
[ "$(id -u)" -eq 0 ] || { rm -rf "$work"; skip "slurmd needs root"; }
for daemon in munged slurmctld slurmd sbatch; do
  command -v "$daemon" >/dev/null || { rm -rf "$work"; skip "$daemon is not installed (munge, slurmctld, slurmd, slurm-client)"; }
done
daemons=""
# shellcheck disable=SC2086
trap '[ -z "$daemons" ] || kill $daemons 2>/dev/null; wait; rm -rf "$work"' EXIT
chmod 755 "$work"
mkdir -m 700 "$work/munge"
head -c 1024 /dev/urandom >"$work/munge/key"
chmod 600 "$work/munge/key"
port=$((20000 + $$ % 10000))
export SLURM_CONF=$work/slurm.conf
cat >"$SLURM_CONF" <<CONF
ClusterName=reebquad_test
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket,cred_expire=5
CredType=cred/munge
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=1,batch_sched_delay=0
MinJobAge=300
KillWait=2
ReturnToService=2
NodeName=$(hostname -s) NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
mkdir "$work/state" "$work/spool"
make_meshes
munged --foreground --force --socket="$work/munge/socket" --key-file="$work/munge/key" --pid-file="$work/munge/pid" \
  --log-file="$work/munge/log" --seed-file="$work/munge/seed" >"$work/munged.out" 2>&1 &
daemons="$!"
slurmctld -D -i >"$work/slurmctld.out" 2>&1 &
daemons="$daemons $!"
slurmd -D >"$work/slurmd.out" 2>&1 &
daemons="$daemons $!"
for _ in $(seq 1 100); do
  sinfo -h -o %T 2>/dev/null | grep -q idle && break
  sleep 0.2
done
sinfo -h -o %T 2>/dev/null | grep -q idle ||
  { tail -n 5 "$work"/*.log "$work"/*.out; skip "the daemons of Slurm do not start here"; }

job=$(sbatch --parsable --array=1-4 --output="$work/task-%a.log" "$2/slurm_array.sh" "$work/in" "$results" \
  "${options[@]}") || fail "sbatch"
wait_for_a_record
running=$(squeue -h -r -j "$job" -t RUNNING -o %i | head -n 1)
[ -n "$running" ] || fail "no task is running any more"
scontrol requeue "$running" || fail "scontrol requeue"
tables=$(sbatch --parsable --dependency="afterany:$job" --output="$work/tables.log" "$2/slurm_array.sh" "$work/in" \
  "$results" --table "${options[@]}") || fail "sbatch of the tables"
for _ in $(seq 1 600); do
  scontrol show job "$running" | grep -q "BeginTime=.*" && scontrol update jobid="$running" StartTime=now 2>/dev/null
  squeue -h -j "$tables" 2>/dev/null | grep -q . || break
  sleep 0.2
done
[ -f "$results/batch.jsonl" ] || { tail -n 20 "$work"/task-*.log "$work"/tables.log "$work/slurmctld.log"; fail "no tables"; }
echo "task $running was queued again"
check_results
