#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A block by GNU parallel, and by a real Slurm of which a node and the controller are killed in the
# middle, has the bytes of the block that one process makes. Exit code 77: what it needs is missing
# here, and what, on the last line. Usage: cluster_test.sh PROGRAM
set -euo pipefail
program=$1
# shellcheck source=tests/cluster/mini_slurm.sh
. "$(dirname "$0")/mini_slurm.sh"

skip() { echo "Skipped: $*"; exit 77; }
fail() {
  echo "FAILED: $*" >&2
  [ -z "$cluster" ] || tail -n 20 "$cluster"/*.log >&2
  head -n 100 "$work"/*/logs/* >&2
  exit 1
}

export RIDGELINE_RETRY_S=1
work=$(mktemp -d)
clean_up() {
  [ -z "$cluster" ] || stop_cluster
  rm -rf "$work"
}
trap clean_up EXIT

# A path that scripts must quote.
make_block() {
  folder="$work/it's a block"
  "$program" --quiet simulate --block 1,3 --frame-px 768,512 --out "$folder" --seed 3
  block=$folder/block.yaml
  sed -i 's/^patch_size_m:.*/patch_size_m: 50/' "$block"  # four patches
}

# One thread each, as the tasks of this test share a host.
block_in() { "$program" --quiet --jobs 1 block "$block" --out "$work/$1" "${@:2}"; }

# run.json names folders and times; logs and scripts belong to the way that a block took.
compare_with_one_host() {
  diff -rq -x run.json -x logs -x '*.sbatch' -x '*.sh' "$work/one host" "$work/$1" || fail "$1: not the bytes of one host"
}

by_parallel() {
  block_in parallel --slurm
  HOME=$work sh "$work/parallel/parallel.sh" -j 2 || fail "parallel.sh: exit code $?"
  compare_with_one_host parallel
  echo "GNU parallel: the bytes of one host (after $SECONDS s)"
}

# The scripts of docs/cluster.md for lines that are judged, in a folder with data of their names.
docs=$(realpath "$(dirname "$0")/../../docs")
script_of_docs() {
  awk -v name="# $1" '/^```/ { text = ""; shown = 0; next } { text = text $0 "\n" }
    $0 == name { shown = 1 } shown { printf "%s", text; text = "" }' "$docs/cluster.md"
}

areas=$work/areas
make_areas() (
  mkdir "$areas"
  cd "$areas"
  ridgeline --quiet simulate --out . --seed 3 --extent-m 60,60 --no-images
  mkdir tiles && mv lidar.las tiles/1.laz && mv truth.geojson town.geojson
  local name
  for name in areas.sh submit_areas.sh areas.sbatch parallel_areas.sh; do
    script_of_docs $name | sed 's/town.gpkg/town.geojson/' > $name
    [ -s $name ] || fail "docs/cluster.md: no $name"
  done
  sh areas.sh
  printf '513000,5402000,513031.5,5404000\n513031.5,5402000,514000,5404000\n' > areas.txt
  ridgeline --quiet evaluate --lines town.geojson --cloud 'tiles/*.laz' --out whole --no-report
)

compare_with_one_run() {
  local rms=""
  for folder in whole town; do
    rms="$rms $(cut -d, -f3,4,5,6 $folder/table2.csv | md5sum)"
  done
  [ "$(echo "$rms" | tr ' ' '\n' | sort -u | grep -c '[0-9a-f]')" -eq 1 ] || fail "$1: not the figures of one run"
  echo "$1: areas have the figures of one run (after $SECONDS s)"
  rm -r runs town
}

areas_by_parallel() {
  (cd "$areas" && HOME=$work sh parallel_areas.sh && compare_with_one_run "GNU parallel")
}

areas_by_slurm() {
  (cd "$areas" && sh submit_areas.sh --partition=main && wait_until queue_is_empty && compare_with_one_run Slurm)
}

start_slurm() {
  cluster=$work/daemons
  export SLURM_CONF=$cluster/slurm.conf
  mkdir "$cluster"
  start_cluster && return
  # Containers may forbid what daemons need. Anything else is a fault.
  grep -hE 'Operation not permitted|Permission denied|gethostbyname|getaddrinfo' "$cluster"/*.log &&
    skip "Slurm cannot start in this environment"
  fail "Slurm did not start"
}

elements_on() { squeue -h -t RUNNING -w "$1" -o %i | wc -l; }

# Each element does one task, and waits before, so that both nodes are busy for as long as this test
# needs.
submit() {
  block_in slurm --slurm
  local n_tasks
  n_tasks=$(sed -n 's/^n_tasks=//p' "$work/slurm/tasks.sbatch")
  sed -i -e "s/^tasks_per_element=.*/tasks_per_element=1/" -e "s/--array=.*/--array=1-$n_tasks/" \
    -e 's/^step() {/&\n  sleep 2/' "$work/slurm/tasks.sbatch"
  sh "$work/slurm/submit.sh" --partition=main
}

both_nodes_work() {
  [ "$(elements_on n1)" -gt 0 ] && [ "$(elements_on n2)" -gt 0 ] &&
    [ "$(find "$work/slurm" -name .ridgeline.lock | wc -l)" -ge 3 ]
}

# As an operator does. A controller that was killed has forgotten what happened since it saved its
# state: it sets aside what started, and waits for what ended until the nodes report.
reported_at_s=0
queue_is_empty() {
  local held
  [ "$SECONDS" -lt $((reported_at_s + 5)) ] || { scontrol reconfigure && reported_at_s=$SECONDS; }
  mapfile -t held < <(squeue -h -r -t PENDING -o '%i %r' | awk '/held|Held/ { print $1 }')
  [ "${#held[@]}" -eq 0 ] || scontrol release "${held[@]}"
  [ -z "$(sinfo -h -n n1 -t drain -o %N)" ] || scontrol update nodename=n1 state=resume
  [ -z "$(squeue -h)" ]
}

wait_until() {
  local end=$((SECONDS + 120))
  until "$1"; do
    [ "$SECONDS" -lt "$end" ] || { squeue >&2; fail "never: $1"; }
    sleep 0.1
  done
}

by_slurm() {
  start_slurm
  submit
  wait_until both_nodes_work
  kill_node n2
  scontrol update nodename=n2 state=down reason=killed
  wait_for_saved_state || fail "the controller does not save its state"
  kill_controller
  sleep 1
  start_controller
  wait_until queue_is_empty
  grep -q 'restart 1' "$work"/slurm/logs/tasks.*.log || fail "no element was interrupted"
  compare_with_one_host slurm
  echo "Slurm: the bytes of one host (after $SECONDS s)"
}

missing_of() {
  local tool
  for tool in "$@"; do command -v "$tool" >/dev/null || printf '%s ' "$tool"; done
}

PATH=$PATH:/usr/sbin  # where daemons are
without_slurm=$(missing_of munged slurmctld slurmd sbatch)
without_parallel=$(missing_of parallel)
[ -z "$without_slurm" ] || [ -z "$without_parallel" ] || skip "not installed: $without_slurm$without_parallel"
PATH=$(dirname "$(realpath "$program")"):$PATH
make_areas
make_block
block_in "one host"
[ -n "$without_parallel" ] || { areas_by_parallel; by_parallel; }
[ -n "$without_slurm" ] || { by_slurm; areas_by_slurm; }
[ -z "$without_slurm$without_parallel" ] || skip "not installed: $without_slurm$without_parallel"
