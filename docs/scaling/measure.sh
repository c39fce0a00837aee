#!/usr/bin/env bash
# What a sweep costs on one core: the processor time of each kind, and what 10^10 and 10^12 entries take.
#
#   measure.sh            with stillpoint on the PATH
set -euo pipefail
TIMEFORMAT='%U %S'
motions=(--v0 1 --p 1 --f 0.001:0.35:5000 --delta 0:0.5:4000)
damped=(--v0 1 --p 1 --f 1e-4:0.02:5000 --delta 1e-4:0.02:4000)
designs=(--v0 1 --p 1 --beta 0.71:1.2:100000)
forced=(--p 1 --f 0.02:0.2:200 --delta 0:0.1:100 --excitation harmonic --k 0.2 --lambda 0.35 --t-end 200)

# measure NAME ENTRIES OPTIONS...
measure() {
  local name=$1 entries=$2 seconds
  shift 2
  seconds=$({ time stillpoint sweep "$@" --threads 1 --quiet > /dev/null; } 2>&1)
  awk -v name="$name" -v entries="$entries" -v seconds="$seconds" 'BEGIN {
    split(seconds, part, " ")
    each = (part[1] + part[2]) / entries
    printf "%-36s %10.3g ns   10^10: %8.3g core h   10^12: %8.3g core h\n",
      name, each * 1e9, each * 1e10 / 3600, each * 1e12 / 3600
  }'
}
measure "motions, --reduce" 2e7 "${motions[@]}" --reduce
measure "motions, --reduce --times" 2e7 "${motions[@]}" --reduce --times
measure "motions with many half-cycles" 2e7 "${damped[@]}" --reduce
measure "motions, .npy rows" 2e7 "${motions[@]}" --format npy --output /dev/null
measure "motions, CSV rows" 2e7 "${motions[@]}" --output /dev/null
measure "designs, --reduce" 1e5 "${designs[@]}" --reduce
measure "motions under a load, --reduce" 2e4 "${forced[@]}" --reduce
