#!/bin/sh
# A sweep in parts on the cores of this machine, with GNU parallel:
#
#   parallel.sh PARTS OUT OPTIONS...
#   parallel.sh 64 rows.npy --v0 1 --p 1 --f 0:0.3:1000 --delta 0:0.5:1000
#
# After a failure give the same command again: parts that are complete are not computed again.
set -eu
parts=$1
out=$2
shift 2
extension=${out##*.}
seq "$parts" | parallel --quote -N0 --halt soon,fail=1 \
  stillpoint sweep "$@" --part "{#}/$parts" --threads 1 --quiet --resume \
  --output "${out%.*}-{part}.$extension" > "${out%.*}.log"
stillpoint sweep merge "$out" "${out%.*}"-*-of-"$parts.$extension"
