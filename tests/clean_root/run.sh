#!/usr/bin/env bash
# Runs ./run and then ./check as root in a bare Debian: a new debootstrap root, a clone of HEAD, packages from the host's mirror.
#   tests/clean_root/run.sh bookworm|trixie [FOLDER]
# FOLDER (default /var/tmp/cusp-clean-root) keeps each release's downloaded packages and ccache for the next run; the root is
# made anew. Needs a Debian host, root and debootstrap. The mounts end with the run: they live in a namespace of their own.
set -euo pipefail

release="${1:?usage: run.sh bookworm|trixie [FOLDER]}"
work="${2:-/var/tmp/cusp-clean-root}"
source_tree="$(cd "$(dirname "$0")/../.." && pwd)"

if [ "${CUSP_CLEAN_ROOT:-}" != inside ]; then
  exec env CUSP_CLEAN_ROOT=inside unshare --mount --pid --fork --kill-child "$0" "$@"
fi
. "$(dirname "$0")/root.sh"

clean_root() {
  make_root
  mount_root
  git clone -q --no-hardlinks "$source_tree" "$root/root/cusp"
}

step "root" clean_root
step "./run" inside /root/cusp/run
step "./check" inside /root/cusp/check
echo "==== $release: whole: $SECONDS s"
