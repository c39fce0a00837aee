#!/bin/sh
# A sweep in parts, each a task of a Slurm array:
#
#   slurm.sh PARTS OUT OPTIONS...
#
# SBATCH_PARTITION, SBATCH_ACCOUNT and SBATCH_TIMELIMIT in the environment choose where and for how long. The
# command waits for the tasks, then merges. After a failure give it again: tasks whose part is complete end at once.
set -eu
parts=$1
out=$2
shift 2
extension=${out##*.}
sbatch --quiet --wait --array="1-$parts" --output="${out%.*}-%a.log" \
  "$(dirname "$0")/slurm_part.sh" "$@" --output "${out%.*}-{part}.$extension"
stillpoint sweep merge "$out" "${out%.*}"-*-of-"$parts.$extension"
