#!/bin/bash
# Sets up and tests gnomon in a bare Debian 13 (PoCL 6, Mesa 25), made by debootstrap in a folder of its own.
set -euo pipefail

usage() {
    cat <<'TEXT'
usage: tests/debian13.sh [FOLDER]

Runs, as root, what .ci/run does on Debian 12, in a Debian 13 in FOLDER (default /var/tmp/gnomon-debian13), which is
made with debootstrap if it is not there, and stays: the commit that is checked out is set up and tested, then
`gnomon verify` compares PoCL 6 and rusticl with the recorded bits. Half an hour on 2 cores. The host is left as it is.
TEXT
}

[[ ${1:-} != -h && ${1:-} != --help ]] || { usage && exit; }
root=${1:-/var/tmp/gnomon-debian13}
((EUID == 0)) || { echo "debian13.sh: must be root, for chroot" >&2 && exit 1; }
command -v debootstrap >/dev/null || { echo "debian13.sh: no debootstrap; apt-get install debootstrap" >&2 && exit 1; }
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# Named last, once it is whole.
if [[ ! -e $root/etc/gnomon-debootstrapped ]]; then
    debootstrap --variant=minbase trixie "$root"
    touch "$root/etc/gnomon-debootstrapped"
fi

trap 'umount "$root/proc" "$root/sys"' EXIT
mount -t proc proc "$root/proc"
mount -t sysfs sys "$root/sys"
mkdir -p "$root/gnomon"
git archive HEAD | tar -x -C "$root/gnomon"

inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root CI=true DEBIAN_FRONTEND=noninteractive "$@"; }

inside /gnomon/setup
inside apt-get install -y --no-install-recommends mesa-opencl-icd
inside bash -c 'cd /gnomon && ctest --preset pocl -j2'
inside env OCL_ICD_VENDORS=pocl.icd /gnomon/build/gnomon verify
inside bash -c 'cd /gnomon && ctest --preset rusticl -j2'
inside env OCL_ICD_VENDORS=rusticl.icd RUSTICL_ENABLE=llvmpipe /gnomon/build/gnomon verify --quick
