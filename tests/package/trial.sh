#!/usr/bin/env bash
# trial.sh ROOT DEB...: installs the packages in ROOT, uses them there, removes them, and fails
# unless that leaves not a file behind. To be run as root; ROOT is a minimal Debian without them, which
# keeps the compiler that the trial installs:
#   debootstrap --variant=minbase bookworm ROOT
set -euo pipefail

root=${1:?ROOT} here=$(cd "$(dirname "$0")" && pwd -P)
shift
say() { printf 'trial: %s\n' "$*"; }
die() { say "$@"; exit 1; }

inside() {
  chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 \
    DEBIAN_FRONTEND=noninteractive "$@" </dev/null
}
apt() { inside apt-get -qq -y -o Dpkg::Use-Pty=0 "$@" >/dev/null; }

# What stands in ROOT, but for what apt and dpkg note of themselves.
files() {
  (cd "$root" && find . -xdev \( -path ./tmp -o -path ./proc -o -path ./var/cache -o -path ./var/log \
    -o -path ./var/lib/apt -o -path ./var/lib/dpkg \) -prune -o -print | LC_ALL=C sort)
}

remove() {
  apt purge --auto-remove "$1"
  # dpkg may go on knowing the name, where another package mentions it.
  local status
  status=$(inside dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null || true)
  [[ -z $status || $status == not-installed ]] || die "dpkg says that $1 is $status"
  diff <(printf '%s\n' "$2") <(files) || die "removing $1 left the files another than before"
  say "$1: installed, used and removed; every file is as before"
}

work=$root/tmp/trial
rm -rf "$work" && mkdir -p "$work"
cp "$@" "$work"
cp -r "$here/../consumer" "$here/../../docs/tour" "$here/../../data/records" "$here/../tour/run.cmake" \
  "$here/../../data/scenes/isolator.json" "$work"
[[ -e $root/etc/resolv.conf ]] || cp /etc/resolv.conf "$root/etc"
apt update

# The program.
before=$(files)
apt install --no-install-recommends "/tmp/trial/$(cd "$work" && ls stillpoint_*.deb)"
inside stillpoint --version
inside stillpoint design /usr/share/doc/stillpoint/scenes/isolator.json | grep -A 3 '^Design'
inside zgrep -q '^.TH STILLPOINT 1' /usr/share/man/man1/stillpoint.1.gz
inside bash -c '. /usr/share/bash-completion/completions/stillpoint && complete -p stillpoint'
remove stillpoint "$before"

# The module.
before=$(files)
apt install --no-install-recommends "/tmp/trial/$(cd "$work" && ls python3-stillpoint_*.deb)"
inside python3 -B -c 'import stillpoint; print(stillpoint.design("/tmp/trial/isolator.json"))' | grep 'Build f'
remove python3-stillpoint "$before"

# The libraries, by CMake and by pkg-config.
apt install --no-install-recommends g++ cmake make pkg-config
before=$(files)
apt install --no-install-recommends "/tmp/trial/$(cd "$work" && ls libstillpoint-dev_*.deb)"
inside cmake -S /tmp/trial/consumer -B /tmp/trial/build >/dev/null
inside cmake --build /tmp/trial/build >/dev/null
inside /tmp/trial/build/consumer
record=/tmp/trial/records/near_fault_pulse.txt
for program in motion region design sweep record; do
  inside bash -c "c++ -std=c++20 /tmp/trial/tour/$program.cpp -o /tmp/trial/$program \
    \$(pkg-config --cflags --libs stillpoint)"
  inside cmake "-DPROGRAM=/tmp/trial/$program" -DPAGE=/tmp/trial/tour/README.md \
    "-DARGUMENT=$([[ $program != record ]] || echo $record)" -P /tmp/trial/run.cmake
done
say "the consumer and the five programs of the tour were built and said what they should"
remove libstillpoint-dev "$before"
rm -rf "$work"
