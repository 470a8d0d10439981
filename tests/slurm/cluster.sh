#!/bin/bash
# Starts or stops a Slurm of one machine for tests, with its daemons and files in one folder; as root or as any user.
# Usage: cluster.sh start FOLDER [NODES]; cluster.sh stop FOLDER; then SLURM_CONF=FOLDER/slurm.conf sbatch ...
set -euo pipefail

action=$1
mkdir -p "$2"
folder=$(realpath "$2")
readonly action folder
# Debian installs daemons in a folder that may not be in the PATH of a user.
PATH=$PATH:/usr/sbin:/sbin

# Prints a port that is not in use.
free_port() {
    python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'
}

configure() {
    local nodes=$1 cpus
    cpus=$(nproc)
    {
        cat <<CONF
ClusterName=tests
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
CredType=cred/munge
SlurmctldPort=$(free_port)
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool-%n
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd-%n.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=2,batch_sched_delay=0
ReturnToService=2
SlurmdTimeout=15
SlurmctldTimeout=15
MessageTimeout=30
KillWait=2
MinJobAge=300
MaxArraySize=1001
MpiDefault=none
CONF
        for ((node = 0; node < nodes; ++node)); do
            echo "NodeName=node$node NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=$(free_port) CPUs=$cpus RealMemory=1000"
        done
        echo "PartitionName=test Nodes=ALL Default=YES MaxTime=INFINITE State=UP PreemptMode=REQUEUE"
    } >"$folder/slurm.conf"
}

start_munge() {
    (umask 077 && head -c 1024 /dev/urandom >"$folder/munge.key")
    chmod 755 "$folder"
    munged --force --socket="$folder/munge.socket" --key-file="$folder/munge.key" --pid-file="$folder/munged.pid" \
        --log-file="$folder/munged.log" --seed-file="$folder/munged.seed"
}

start_node() {
    mkdir -p "$folder/spool-$1"
    slurmd -N "$1" -f "$folder/slurm.conf"
}

start() {
    mkdir -p "$folder/state"
    configure "$1"
    export SLURM_CONF=$folder/slurm.conf
    start_munge
    slurmctld -f "$folder/slurm.conf"
    for ((node = 0; node < $1; ++node)); do start_node "node$node"; done
    for _ in {1..60}; do
        [[ $(sinfo --noheader --format=%T 2>/dev/null | sort -u) == idle ]] && return
        sleep 0.5
    done
    echo "slurm: the nodes do not come up" >&2
    tail -n 20 "$folder"/*.log >&2
    return 1
}

stop_by() {
    local pid
    [[ -e $1 ]] || return 0
    pid=$(cat "$1")
    kill -"${2:-TERM}" "$pid" 2>/dev/null || return 0
    for _ in {1..60}; do
        kill -0 "$pid" 2>/dev/null || return 0
        sleep 0.25
    done
    kill -KILL "$pid" 2>/dev/null || true
}

stop() {
    export SLURM_CONF=$folder/slurm.conf
    scancel --full --user="$(id -un)" 2>/dev/null || true
    sleep 1
    for file in "$folder"/slurmd-*.pid "$folder/slurmctld.pid" "$folder/munged.pid"; do stop_by "$file"; done
}

case $action in
start) start "${3:-1}" ;;
stop) stop ;;
kill-node) stop_by "$folder/slurmd-$3.pid" KILL ;;
start-node) start_node "$3" ;;
kill-controller) stop_by "$folder/slurmctld.pid" KILL ;;
start-controller) SLURM_CONF=$folder/slurm.conf slurmctld -f "$folder/slurm.conf" ;;
*)
    echo "cluster.sh: no '$action'" >&2
    exit 2
    ;;
esac
