# A bare Debian root for the scripts that source this: debootstrap, packages from the host's mirror, mounts, a clone of HEAD.
# Before: release (bookworm or trixie), work (the folder that keeps downloads and ccache), source_tree.
# Needs a Debian host, root, debootstrap, and a mount namespace of its own, with which the mounts end.

root="$work/$release/root" archives="$work/$release/archives" ccache="$work/$release/ccache"

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

make_root() { # The root anew, without a clone.
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
}

mount_root() {
  mount --make-rprivate /
  mount -t proc proc "$root/proc"
  mount --rbind /sys "$root/sys"
  mount --rbind /dev "$root/dev"
  mount --bind "$archives" "$root/var/cache/apt/archives"
  mkdir -p "$root/var/cache/ccache"
  mount --bind "$ccache" "$root/var/cache/ccache"
}

inside() { # COMMAND...
  env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root CCACHE_DIR=/var/cache/ccache \
    chroot "$root" "$@"
}
