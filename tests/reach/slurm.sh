#!/usr/bin/env bash
# A cluster of one node, this machine, that no other program sees: starts Slurm (slurm-wlm), lets it run the job scripts
# that `fumon sweep --slurm` and `fumon render --slurm` print, and compares table, frames and movie with those of one
# program. Where Slurm is not there or does not start it says so and ends with status 77, which CTest counts as skipped.
#
#     tests/reach/slurm.sh build/release/fumon
set -euo pipefail
export PATH=$PATH:/usr/sbin
FUMON=$(realpath "$1")
export FUMON

skip() { echo "skipped: $*"; exit 77; }
for program in slurmctld slurmd sbatch scontrol squeue; do
    command -v $program > /dev/null || skip "$program is not installed (slurm-wlm)"
done

place=$(mktemp -d)
daemons=()
end() {
    for daemon in "${daemons[@]}"; do kill "$daemon" 2> /dev/null || true; done
    wait 2> /dev/null || true
    rm -rf "$place"
}
trap end EXIT

host=$(hostname -s)
port=$((20000 + RANDOM % 20000))
cat > "$place/slurm.conf" <<CONF
ClusterName=fumon
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
AuthType=auth/none
CredType=cred/none
ProctrackType=proctrack/pgid
TaskPlugin=task/none
MpiDefault=none
SwitchType=switch/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
SlurmdParameters=config_overrides
SchedulerParameters=batch_sched_delay=1,sched_interval=2,sched_min_interval=100000,defer_batch
StateSaveLocation=$place/state
SlurmdSpoolDir=$place/spool
SlurmctldPidFile=$place/slurmctld.pid
SlurmdPidFile=$place/slurmd.pid
SlurmctldLogFile=$place/slurmctld.log
SlurmdLogFile=$place/slurmd.log
NodeName=$host NodeAddr=127.0.0.1 CPUs=8 State=UNKNOWN
PartitionName=main Nodes=$host Default=YES State=UP
CONF
export SLURM_CONF=$place/slurm.conf
mkdir "$place/state" "$place/spool"
slurmctld -D > "$place/ctld.out" 2>&1 & daemons+=($!)
slurmd -D > "$place/d.out" 2>&1 & daemons+=($!)
for _ in $(seq 60); do
    if sinfo -h -o %T 2> /dev/null | grep -q idle; then started=yes; break; fi
    sleep 0.5
done
if [ -z "${started:-}" ]; then
    tail -n 3 "$place"/*.log "$place"/*.out || true
    skip "Slurm does not start here"
fi

# until_empty: waits for the end of all jobs.
until_empty() {
    for _ in $(seq 240); do
        [ -n "$(squeue -h 2> /dev/null)" ] || return 0
        sleep 0.5
    done
    squeue
    echo "the jobs do not end"; exit 1
}

same() {
    if [ "$(sha256sum < "$1")" != "$(sha256sum < "$2")" ]; then
        echo "$1 and $2 differ"; cat ./*.log; exit 1
    fi
    echo "same: $1"
}

mkdir "$place/work"
cd "$place/work"
cat > scene.toml <<SCENE
seed = 5
[model]
name = "sand"
[grid]
nx = 24
ny = 20
[run]
steps = 20
[frames]
every = 5
[image]
width = 64
height = 48
SCENE

sweep=(sweep scene.toml --over run.steps=10,40,20 --seeds 2)
"$FUMON" "${sweep[@]}" -o one -q
"$FUMON" "${sweep[@]}" -o many --slurm 3 | sbatch > /dev/null
until_empty
same one/sweep.csv many/sweep.csv

# One shard is lost; the same script does it again, and the merge follows.
"$FUMON" "${sweep[@]}" -o lost --slurm 3 > job.sh
sbatch --array=1,3 job.sh > /dev/null
until_empty
[ ! -e lost/sweep.csv ] || { echo "a table was made without shard 2"; exit 1; }
grep -hq "shard 2/3 is missing" fumon-sweep-merge-*.log || { echo "shard 2 is not named"; cat ./*.log; exit 1; }
sbatch --array=2 job.sh > /dev/null
until_empty
same one/sweep.csv lost/sweep.csv

"$FUMON" run scene.toml -o whole -q --set output.fields_every=5
"$FUMON" run scene.toml -o beds -q --set output.fields_every=5 --set output.frames=false --set output.movie=false
"$FUMON" render beds -o drawn --slurm 2 | sbatch > /dev/null
until_empty
same whole/movie.mp4 drawn/movie.mp4
for frame in whole/frames/*.png; do same "$frame" "drawn/frames/$(basename "$frame")"; done
echo "all as one program makes it"
