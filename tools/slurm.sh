#!/usr/bin/env bash
# Runs a sweep on a Slurm cluster of one machine, which it starts and ends, and compares the folder with that of a sweep
# without Slurm, byte for byte: one task of the array is killed, one gets TERM, and one is queued again. Needs root and
# the packages of `tools/setup.sh test`.
#   tools/slurm.sh TUMBLE   the program to run
set -euo pipefail

project=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
(($# == 1)) || { echo "usage: ${0##*/} TUMBLE" >&2; exit 2; }
tumble=$(realpath -- "$1")

say() { printf 'slurm: %s (%d s)\n' "$*" "$SECONDS" >&2; }
die() { say "$@"; tail -n 20 "$work"/*.log >&2 || true; exit 1; }

work=$(mktemp -d)
chmod 755 "$work"
export SLURM_CONF=$work/slurm.conf
daemons=()

# Ends the jobs, then the daemons, the last one first.
clean_up() {
    [[ -z ${cluster_is_up-} ]] || scancel --signal=KILL --full --user=root 2> /dev/null || true
    local i
    for ((i = ${#daemons[@]} - 1; i >= 0; --i)); do
        kill "${daemons[i]}" 2> /dev/null || true
        wait "${daemons[i]}" 2> /dev/null || true
    done
    rm -rf -- "$work"
}
trap clean_up EXIT

# wait_until SECONDS COMMAND...: the command succeeds within the time.
wait_until() {
    local end=$((SECONDS + $1))
    shift
    until "$@" 2> /dev/null; do
        ((SECONDS < end)) || return 1
        sleep 0.1
    done
}

write_configuration() {
    local host
    host=$(hostname -s)
    mkdir -p "$work"/{state,spool}
    cat > "$SLURM_CONF" << EOF
ClusterName=sweep
SlurmctldHost=$host(127.0.0.1)
AuthInfo=socket=$work/munge.socket
SlurmUser=root
SlurmctldPort=$1
SlurmdPort=$2
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
MailProg=/bin/true
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=0
KillWait=5
NodeName=$host NodeAddr=127.0.0.1 CPUs=2
PartitionName=main Nodes=ALL Default=YES MaxTime=10
EOF
}

start_cluster() {
    dd if=/dev/urandom of="$work/munge.key" bs=1024 count=1 2> /dev/null
    chmod 400 "$work/munge.key"
    munged --foreground --force --key-file="$work/munge.key" --socket="$work/munge.socket" \
        --pid-file="$work/munge.pid" --seed-file="$work/munge.seed" --log-file="$work/munge.log" \
        > "$work/munged.log" 2>&1 &
    daemons+=($!)
    wait_until 10 test -S "$work/munge.socket" || die "munged does not start"
    slurmctld -D > "$work/slurmctld.log" 2>&1 &
    daemons+=($!)
    slurmd -D > "$work/slurmd.log" 2>&1 &
    daemons+=($!)
    wait_until 20 node_is_idle || die "the node does not come up"
    cluster_is_up=1
}

node_is_idle() { [[ $(sinfo --noheader --format=%T) == idle ]]; }

# Each run takes some 10 ms, so that a task is at work for seconds.
write_plan() {
    cat > "$work/plan.json" << 'EOF'
{"format": 1, "scene": "tower_and_ball.json", "runs": 400, "shard_runs": 4, "set": {"/world/duration": 30},
 "parameters": [{"name": "x", "set": "/bodies/ball/position/0", "range": [-6, 1]}],
 "write": {"trajectory": {"every": 30}, "summary": true}}
EOF
    cp -- "$project/scenes/plans/tower_and_ball.json" "$work"
}

# submit: prints the numbers of the array and of the job after it, and its tasks.
submit() {
    "$tumble" sweep submit "$work/plan.json" -o "$work/cluster" --slurm --tasks 4 --program "$tumble" --json |
        python3 -c 'import json, sys; answer = json.load(sys.stdin); print(answer["job"], answer["merge_job"], answer["array"])'
}

is_delayed() { [[ $(squeue --noheader --format=%r --jobs="$1") == BeginTime ]]; }
has_ended() { [[ -z $(squeue --noheader --jobs="$1") ]]; }
has_shard() { [[ -s $work/cluster/shard-$(printf %06d "$1").csv ]]; }

write_configuration $((20000 + $$ % 20000)) $((40000 + $$ % 20000))
start_cluster
write_plan
say "the cluster is up"
"$tumble" sweep "$work/plan.json" -o "$work/local" > /dev/null
say "the sweep without Slurm is complete"

read -r job merge tasks < <(submit)
[[ $tasks == 0-3 ]] || die "expected the tasks 0-3, got $tasks"
wait_until 30 has_shard 0 || die "task 0 has not written a shard"
scancel --signal=KILL --batch "${job}_0"
wait_until 30 has_shard 1 || die "task 1 has not written a shard"
scontrol requeue "${job}_1"
wait_until 30 is_delayed "${job}_1" || die "task 1 is not queued again"
scontrol update "JobId=${job}_1" StartTime=now+3seconds  # in place of two minutes; a node refuses it at once
say "task 0 is killed, task 1 is queued again"
wait_until 30 has_shard 2 || die "task 2 has not written a shard"
scancel --signal=TERM --batch "${job}_2"
say "task 2 has got TERM"
wait_until 60 has_ended "$merge" || die "the sweep does not end"
grep -q 'missing: \|missing shards' "$work/cluster.slurm/merge.log" || die "no shard is missing after a kill"

read -r job merge tasks < <(submit)
say "submitted again: the tasks $tasks"
[[ $tasks == 0,2 ]] || die "expected the tasks 0,2, got $tasks"
wait_until 60 has_ended "$merge" || die "the sweep does not end"
diff -r "$work/local" "$work/cluster" >&2 || die "the two folders differ"
say "the folders have the same bytes"
