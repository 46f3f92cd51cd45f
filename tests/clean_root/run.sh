#!/usr/bin/env bash
# Runs ./run and then ./check as root in a bare Debian: a new debootstrap root, a clone of HEAD, packages from the host's mirror.
#   tests/clean_root/run.sh bookworm|trixie [FOLDER]
# FOLDER (default /var/tmp/cusp-clean-root) keeps each release's downloaded packages and ccache for the next run; the root is
# made anew. Needs a Debian host, root and debootstrap. The mounts end with the run: they live in a namespace of their own.
set -euo pipefail

release="${1:?usage: run.sh bookworm|trixie [FOLDER]}"
work="${2:-/var/tmp/cusp-clean-root}"
source_tree="$(cd "$(dirname "$0")/../.." && pwd)"
root="$work/$release/root" archives="$work/$release/archives" ccache="$work/$release/ccache"

if [ "${CUSP_CLEAN_ROOT:-}" != inside ]; then
  exec env CUSP_CLEAN_ROOT=inside unshare --mount --pid --fork --kill-child "$0" "$@"
fi

step() { # NAME COMMAND...
  local name="$1" start=$SECONDS
  shift
  echo "==== $release: $name"
  "$@"
  echo "==== $release: $name: $((SECONDS - start)) s"
}

# The host's archive and security archive: "URI COMPONENT".
mirror() { # SUITE
  apt-get indextargets --format '$(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' |
    awk -v suite="$1" '$2 == suite && $3 == "main" { print $1; exit }'
}
host="$(. /etc/os-release && echo "$VERSION_CODENAME")"
main="$(mirror "$host")" security="$(mirror "$host-security")"
[ -n "$main" ] || { echo "apt's configuration names no archive of $host" >&2; exit 1; }

make_root() {
  rm -rf --one-file-system "$root"
  mkdir -p "$root" "$archives/partial" "$ccache"
  debootstrap --variant=minbase --cache-dir="$archives" "$release" "$root" "$main" >"$work/$release/debootstrap.log" ||
    { tail -20 "$work/$release/debootstrap.log" >&2; exit 1; }
  {
    echo "deb $main $release main"
    echo "deb $main $release-updates main"
    if [ -n "$security" ]; then echo "deb $security $release-security main"; fi
  } >"$root/etc/apt/sources.list"
  apt-config dump | grep -E '^Acquire::https?::Proxy' >"$root/etc/apt/apt.conf.d/10host" || true
  mount -t proc proc "$root/proc"
  mount --rbind /sys "$root/sys"
  mount --rbind /dev "$root/dev"
  mount --bind "$archives" "$root/var/cache/apt/archives"
  mkdir -p "$root/var/cache/ccache"
  mount --bind "$ccache" "$root/var/cache/ccache"
  git clone -q --no-hardlinks "$source_tree" "$root/root/cusp"
}

inside() { # COMMAND...
  env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root CCACHE_DIR=/var/cache/ccache \
    chroot "$root" "$@"
}

mount --make-rprivate /
step "root" make_root
step "./run" inside /root/cusp/run
step "./check" inside /root/cusp/check
echo "==== $release: whole: $SECONDS s"
