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
  sh -c 'part=$((${OMPI_COMM_WORLD_RANK:-$PMI_RANK} + 1)); exec stillpoint sweep "$@" --part "$part/$0"' "$ranks" \
  "$@" --threads 1 --quiet --resume --output "${out%.*}-{part}.$extension" > "${out%.*}.log"
stillpoint sweep merge "$out" "${out%.*}"-*-of-"$ranks.$extension"
