#!/bin/bash
# Runs a planned study as a job array of a real single-node Slurm, started for this test alone, and compares the merged
# data with those of a plain run. Where Slurm cannot be started, says why and runs the chunks with the variables that an
# array sets.
#
#   tests/cluster/slurm.sh PROGRAM
set -euo pipefail
program=$(realpath "$1")
study=$(realpath "$(dirname "$0")/study.toml")
work=$(mktemp -d)
keep=${KEEP:-}
pids=()

finish() {
    for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null || true; done
    wait 2>/dev/null || true
    [ -n "$keep" ] && echo "kept in $work" || rm -rf "$work"
}
trap finish EXIT

# Says why Slurm cannot run here; nothing if it could be started.
start_slurm() {
    local needed
    for needed in slurmctld slurmd munged sbatch scontrol; do
        command -v $needed >/dev/null || { echo "there is no $needed (Debian: slurm-wlm, munge)"; return; }
    done
    [ "$(id -u)" = 0 ] || { echo "only root can start slurmd"; return; }
    local host cpus
    host=$(hostname -s)
    cpus=$(nproc)
    mkdir -p "$work/munge" "$work/state" "$work/spool"
    chmod 755 "$work"
    chown munge "$work/munge"
    head -c 1024 /dev/urandom > "$work/munge/key"
    chown munge "$work/munge/key"
    chmod 400 "$work/munge/key"
    # The socket's folder must be open to all, its key to nobody else.
    setpriv --reuid=munge --regid=munge --clear-groups \
        munged --foreground --force --socket="$work/munge/socket" --key-file="$work/munge/key" --seed-file="$work/munge/seed" \
        --log-file="$work/munge/log" --pid-file="$work/munge/pid" >"$work/munged.out" 2>&1 &
    pids+=($!)
    cat > "$work/slurm.conf" <<CONFIG
ClusterName=test
SlurmctldHost=$host
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldPort=${SLURM_TEST_PORT:-16817}
SlurmdPort=$((${SLURM_TEST_PORT:-16817} + 1))
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
MpiDefault=none
SchedulerParameters=bf_interval=1,sched_interval=1
NodeName=$host CPUs=$cpus State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONFIG
    export SLURM_CONF="$work/slurm.conf"
    slurmctld -D >"$work/slurmctld.log" 2>&1 &
    pids+=($!)
    slurmd -D >"$work/slurmd.log" 2>&1 &
    pids+=($!)
    local i
    for i in $(seq 60); do
        sinfo -h -o %t 2>/dev/null | grep -q idle && return
        sleep 0.5
    done
    echo "its node does not become idle: $(tail -n 2 "$work/slurmctld.log" "$work/slurmd.log" "$work/munged.out" 2>/dev/null | tr '\n' ' ')"
}

"$program" study "$study" --out "$work/whole" --quiet
"$program" study plan "$study" --out "$work/cut" --chunks 6 --quiet
lines=$("$program" study status "$work/cut")
grep -q "sbatch --array=1-6 --wrap 'mechwright study run $work/cut --jobs 1'" <<<"$lines"

start_slurm > "$work/why"
if [ ! -s "$work/why" ]; then
    mkdir "$work/bin"
    ln -s "$program" "$work/bin/mechwright"
    array=$(grep -o 'sbatch --array=.*' <<<"$lines")
    (cd "$work" && PATH="$work/bin:$PATH" bash -c "${array/sbatch/sbatch --wait --output=$work/job-%a.log}")
    echo "ran as a job array of Slurm: $array"
else
    echo "Slurm cannot be started here: $(cat "$work/why")"
    for task in 4 1 6 3 2 5; do
        SLURM_ARRAY_TASK_ID=$task SLURM_CPUS_PER_TASK=1 "$program" study run "$work/cut" --quiet
    done
    echo "ran with the variables of an array instead"
fi
"$program" study merge "$work/cut" --quiet
cmp <("$program" study export "$work/whole" --csv) <("$program" study export "$work/cut" --csv)
echo "the merged data are those of a plain run"
