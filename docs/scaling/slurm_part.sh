#!/bin/sh
#SBATCH --job-name=stillpoint
#SBATCH --ntasks=1
#SBATCH --requeue
# One task of the array that slurm.sh submits.
exec stillpoint sweep "$@" --part "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" --threads "${SLURM_CPUS_PER_TASK:-1}" --resume
