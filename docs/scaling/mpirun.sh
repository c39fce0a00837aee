#!/bin/sh
# A sweep in parts, one for each rank of Open MPI or MPICH:
#
#   mpirun.sh RANKS OUT OPTIONS...
#
# MPIRUN is the command that starts the ranks, "mpirun" unless it is set: MPIRUN="mpirun --hostfile hosts".
# After a failure give the same command again: parts that are complete are not computed again.
set -eu
ranks=$1
out=$2
shift 2
extension=${out##*.}
${MPIRUN:-mpirun} -np "$ranks" \
  stillpoint sweep "$@" --part auto --threads 1 --quiet --resume \
  --output "${out%.*}-{part}.$extension" > "${out%.*}.log"
stillpoint sweep merge "$out" "${out%.*}"-*-of-"$ranks.$extension"
