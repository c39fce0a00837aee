#!/bin/sh
# run.sh ENGINE PROGRAM SCRIPTS: a sweep in parts by the script of the engine. The first process that starts is
# killed while it computes; the same command again must end with the bytes of the whole sweep. 77: not installed.
set -eu
engine=$1
script=$1
program=$2
scripts=$3
dir=$(mktemp -d)
stop=:
trap '$stop; rm -rf "$dir"' EXIT
cd "$dir"

need() {
  for command in "$@"; do
    command -v "$command" > /dev/null || { echo "skipped: no $command"; exit 77; }
  done
}
case $engine in
  parallel)
    need parallel
    PARALLEL_HOME=$dir/home
    export PARALLEL_HOME
    mkdir home && touch home/will-cite ;;
  openmpi)
    need mpirun.openmpi
    script=mpirun
    MPIRUN="mpirun.openmpi --allow-run-as-root --oversubscribe"
    export MPIRUN ;;
  mpich)
    need mpirun.mpich
    script=mpirun
    MPIRUN=mpirun.mpich
    export MPIRUN ;;
  slurm)
    PATH=$PATH:/usr/sbin
    need slurmctld slurmd munged sbatch srun
    [ "$(id -u)" = 0 ] || { echo "skipped: slurmd needs root"; exit 77; }
    SLURM_TRIAL_PORT=$((20000 + $$ % 20000))
    SLURM_CONF=$dir/cluster/slurm.conf
    export SLURM_TRIAL_PORT SLURM_CONF
    stop="sh $scripts/slurm_node.sh stop cluster"
    sh "$scripts/slurm_node.sh" start cluster ;;
esac

# A stillpoint in whose place the first process to start is killed as soon as it has begun to write.
mkdir bin
cat > bin/stillpoint << END
#!/bin/sh
if mkdir "$dir/killed" 2> "$dir/killed.log"; then
  "$program" "\$@" &
  while kill -0 \$! 2> "$dir/killed.log" && ! ls "$dir"/*.part 2> "$dir/killed.log"; do :; done
  kill -9 \$!
  exit 1
fi
exec "$program" "\$@"
END
chmod +x bin/stillpoint
PATH=$dir/bin:$PATH
export PATH

set -- --p 1 --f 0.001:0.01:24 --delta 0:0.001:50 --excitation harmonic --k 0.1 --lambda 0.9 --t-end 700
"$program" sweep "$@" --output whole.csv --quiet > whole.log
if sh "$scripts/$script.sh" 4 rows.csv "$@"; then
  echo "a part was killed and nobody noticed"
  exit 1
fi
[ -d killed ] && [ ! -e rows.csv ]
sh "$scripts/$script.sh" 4 rows.csv "$@"
cmp rows.csv whole.csv

if [ "$engine" = slurm ]; then
  srun -n 2 sh -c 'exec stillpoint sweep "$@" --part "$((SLURM_PROCID + 1))/$SLURM_NTASKS"' step \
    "$@" --reduce --output 'step-{part}.json' > step.log
  stillpoint sweep merge step.json step-1-of-2.json step-2-of-2.json
  stillpoint sweep "$@" --reduce --output whole.json > whole.log
  cmp step.json whole.json
fi
