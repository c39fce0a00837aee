#!/bin/sh
# A Slurm cluster of one node, this machine, to try things out. Its files are in DIR. As root:
#
#   slurm_node.sh start DIR      then: export SLURM_CONF=DIR/slurm.conf
#   slurm_node.sh stop DIR
#
# On Debian it needs slurm-wlm. Two clusters at once need different ports, SLURM_TRIAL_PORT and the next one.
set -eu
action=$1
dir=$(realpath -m "$2")
case $action in
  start)
    mkdir -p "$dir/state" "$dir/spool" "$dir/munge"
    chmod 0711 "$dir/munge"
    dd if=/dev/urandom of="$dir/munge.key" bs=128 count=1 2> "$dir/dd.log"
    chmod 0400 "$dir/munge.key"
    munged --force --key-file="$dir/munge.key" --socket="$dir/munge/socket" \
      --pid-file="$dir/munge/pid" --log-file="$dir/munge/log" --seed-file="$dir/munge/seed"
    node=$(hostname -s)
    cat > "$dir/slurm.conf" << CONF
ClusterName=trial
SlurmctldHost=$node(127.0.0.1)
AuthType=auth/munge
AuthInfo=socket=$dir/munge/socket
CredType=cred/munge
SlurmUser=root
SlurmdUser=root
SlurmctldPort=${SLURM_TRIAL_PORT:-26817}
SlurmdPort=$((${SLURM_TRIAL_PORT:-26817} + 1))
SlurmctldPidFile=$dir/slurmctld.pid
SlurmdPidFile=$dir/slurmd.pid
SlurmctldLogFile=$dir/slurmctld.log
SlurmdLogFile=$dir/slurmd.log
StateSaveLocation=$dir/state
SlurmdSpoolDir=$dir/spool
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
ReturnToService=2
MaxArraySize=1001
SchedulerParameters=sched_interval=1,batch_sched_delay=0
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
NodeName=$node NodeAddr=127.0.0.1 CPUs=$(nproc)
PartitionName=trial Nodes=$node Default=YES MaxTime=INFINITE State=UP
CONF
    export SLURM_CONF="$dir/slurm.conf"
    slurmctld -c -f "$SLURM_CONF"
    slurmd -c -f "$SLURM_CONF"
    tries=0
    until sinfo -h -o %t | grep -q idle; do
      tries=$((tries + 1))
      [ "$tries" -lt 100 ] || { sinfo; exit 1; }
      sleep 0.2
    done
    ;;
  stop)
    for pid in slurmd.pid slurmctld.pid munge/pid; do
      [ -f "$dir/$pid" ] || continue
      number=$(cat "$dir/$pid")
      kill "$number"
      while kill -0 "$number" 2> "$dir/stop.log"; do sleep 0.1; done
    done
    ;;
esac
