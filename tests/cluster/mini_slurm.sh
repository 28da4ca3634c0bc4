# shellcheck shell=bash
# SPDX-License-Identifier: BSD-3-Clause
# A Slurm of two nodes on this host, for tests: functions to source. Neither root nor systemd is
# needed, and nothing outside of its folder is touched.
cluster=  # its folder

# A port of this host that nobody listens to, with two more after it. Below those that the system
# gives away.
free_ports() {
  local port offset busy
  while true; do
    port=$((20000 + RANDOM % 12000)) busy=
    for offset in 0 1 2; do
      (: >"/dev/tcp/127.0.0.1/$((port + offset))") 2>/dev/null && busy=1
    done
    [ -n "$busy" ] || { echo "$port"; return; }
  done
}

# Memory and cores of the nodes are stated, not looked up, so that one host can pose as several.
write_cluster_conf() {
  local host user port
  host=$(hostname -s) user=$(id -un) port=$(free_ports)
  cat >"$cluster/slurm.conf" <<CONF
ClusterName=mini
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
AuthInfo=socket=$cluster/munge.sock,cred_expire=5
CredType=cred/munge
SlurmctldPort=$port
StateSaveLocation=$cluster/state
SlurmdSpoolDir=$cluster/spool.%n
SlurmctldPidFile=$cluster/slurmctld.pid
SlurmdPidFile=$cluster/slurmd.%n.pid
SlurmctldLogFile=$cluster/slurmctld.log
SlurmdLogFile=$cluster/slurmd.%n.log
SlurmdParameters=config_overrides
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
SchedulerParameters=batch_sched_delay=0,bf_interval=1,sched_interval=1
ReturnToService=2
SlurmdTimeout=30
KillWait=2
NodeName=n[1-2] NodeHostname=$host NodeAddr=127.0.0.1 Port=[$((port + 1))-$((port + 2))] CPUs=2 RealMemory=8000
PartitionName=main Nodes=ALL Default=YES
CONF
  # Without this file slurmd asks systemd.
  printf 'CgroupAutomount=no\nConstrainCores=no\nConstrainRAMSpace=no\n' >"$cluster/cgroup.conf"
}

# Whether messages can be signed here: what all of Slurm rests on.
start_munge() {
  dd if=/dev/urandom of="$cluster/munge.key" bs=1024 count=1 status=none
  chmod 400 "$cluster/munge.key"
  munged --force --key-file="$cluster/munge.key" --socket="$cluster/munge.sock" --pid-file="$cluster/munged.pid" \
    --log-file="$cluster/munged.log" --seed-file="$cluster/munge.seed" --num-threads=1 2>>"$cluster/munged.log" &&
    munge --no-input --socket="$cluster/munge.sock" | unmunge --socket="$cluster/munge.sock" >/dev/null
}

# Arguments: none, or -c for a controller without memory.
start_controller() { slurmctld "$@"; }

start_node() { slurmd -c -N "$1"; }

kill_controller() {
  local pid
  pid=$(cat "$cluster/slurmctld.pid")
  kill -9 "$pid"
  while kill -0 "$pid" 2>/dev/null; do sleep 0.05; done
}

# Processes of a node that a job started there: their environment says so.
jobs_on() {
  grep -lzsxF "SLURM_CONF=$cluster/slurm.conf" /proc/[0-9]*/environ |
    xargs grep -lzsxF "SLURMD_NODENAME=$1" /dev/null | grep -o '[0-9]*'
}

# Those parents of processes that hold them for Slurm.
helpers_of() {
  local pid parent
  for pid in "$@"; do
    parent=$(awk '$1 == "PPid:" { print $2 }' "/proc/$pid/status" 2>/dev/null) || continue
    ! grep -qx slurmstepd "/proc/$parent/comm" 2>/dev/null || echo "$parent"
  done
}

# As a power cut does: the daemon and all that runs on the node ends before it can tell the
# controller. So those that would tell end first.
kill_node() {
  local jobs
  mapfile -t jobs < <(jobs_on "$1")
  # shellcheck disable=SC2046  # numbers
  kill -9 $(cat "$cluster/slurmd.$1.pid") $(helpers_of "${jobs[@]}") "${jobs[@]}" 2>/dev/null || true
}

# Returns once the controller would remember all that it did until now: it saves its state every 5
# s. A controller that is killed earlier starts running elements once more, and Slurm drains their
# nodes.
wait_for_saved_state() {
  local attempt
  touch "$cluster/now"
  for ((attempt = 0; attempt < 200; ++attempt)); do
    [ "$cluster/state/job_state" -nt "$cluster/now" ] && return 0
    # it saves after a change only, and the last one may have been saved before we looked
    [ $((attempt % 20)) -ne 19 ] || scontrol update jobid="$(squeue -h -o %A | head -n 1)" comment="$attempt"
    sleep 0.1
  done
  return 1
}

# Starts everything. Needs `cluster` and SLURM_CONF.
start_cluster() {
  local node attempt
  mkdir -p "$cluster/state" "$cluster/spool.n1" "$cluster/spool.n2"
  write_cluster_conf
  start_munge || return 1
  start_controller -c || return 1
  for node in n1 n2; do start_node "$node" || return 1; done
  for ((attempt = 0; attempt < 100; ++attempt)); do
    [ "$(sinfo -h -N -t idle -o %N 2>/dev/null | wc -l)" -eq 2 ] && return 0
    sleep 0.1
  done
  return 1
}

stop_cluster() {
  local node file
  for node in n1 n2; do kill_node "$node"; done
  for file in slurmctld munged; do
    [ ! -s "$cluster/$file.pid" ] || kill -9 "$(cat "$cluster/$file.pid")" 2>/dev/null || true
  done
}
