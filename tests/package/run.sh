#!/usr/bin/env bash
# Builds the package in a Debian root, installs it in a second, bare one, opens the window there, upgrades and removes it.
#   tests/package/run.sh bookworm|trixie [PACKAGE.deb]
# With a PACKAGE of that release nothing is built. CUSP_PACKAGE_FOLDER (default /var/tmp/cusp-package) keeps downloads, ccache
# and the package for the next run; the roots are made anew. Needs what tests/clean_root/run.sh needs.
set -euo pipefail

release="${1:?usage: run.sh bookworm|trixie [PACKAGE.deb]}"
package="${2:-}"
work="${CUSP_PACKAGE_FOLDER:-/var/tmp/cusp-package}"
source_tree="$(cd "$(dirname "$0")/../.." && pwd)"

if [ "${CUSP_PACKAGE_ROOT:-}" != inside ]; then
  exec env CUSP_PACKAGE_ROOT=inside unshare --mount --pid --fork --kill-child "$0" "$@"
fi
. "$source_tree/tests/clean_root/root.sh"

build_root() {
  make_root
  mount_root
  git clone -q --no-hardlinks "$source_tree" "$root/root/cusp"
}

build_package() {
  inside /root/cusp/run --set-up
  inside /root/cusp/run --build release --target cusp_package
  cp "$root"/root/cusp/build/release/cusp_*.deb "$work/$release/"
  package="$(ls -t "$work/$release"/cusp_*.deb | head -1)"
}

bare_root() {
  root="$work/$release/bare"
  make_root
  mount_root
  git clone -q --no-hardlinks "$source_tree" "$root/root/cusp"
  cp "$package" "$root/root/cusp.deb"
}

# The same package under a higher version.
raise_version() {
  inside sh -euc 'dpkg-deb -R /root/cusp.deb /root/next
    sed -i "s/^Version: .*/&+next/" /root/next/DEBIAN/control
    dpkg-deb --root-owner-group -Zgzip -z1 -b /root/next /root/next.deb >/dev/null && rm -r /root/next'
}

apt_install() { inside env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "$@" >>"$work/$release/apt.log"; }

install_alone() { # What the package depends on must do: no recommended package is there.
  inside apt-get update -qq
  apt_install /root/cusp.deb
  inside cusp --version
  inside cusp validate class-1-36
}

window() {
  apt_install git python3 python3-gi xvfb openbox xdotool dbus-daemon at-spi2-core gir1.2-atspi-2.0 desktop-file-utils shared-mime-info man-db
  inside /usr/bin/python3 /root/cusp/tests/package/installed.py
}

upgrade() {
  inside sh -euc 'mkdir -p /root/station && cusp play paper-block --script expert --db /root/station/cusp.db --out /root/station >/dev/null
    cd /root/station && find . -type f | sort | xargs sha256sum >/root/before'
  apt_install /root/next.deb
  inside sh -euc 'dpkg-query -W -f="\${Version}\n" cusp | grep "+next$"
    cd /root/station && sha256sum --quiet -c /root/before && cusp history cusp.db verify'
}

remove() {
  inside sh -euc 'dpkg -L cusp >/root/listed; apt-get purge -y -qq cusp >/dev/null
    left=$(while read -r file; do if [ ! -d "$file" ] && [ -e "$file" ]; then echo "$file"; fi; done </root/listed
      find / -xdev \( -path /proc -o -path /sys -o -path /dev -o -path /root -o -path /tmp -o -path /var/cache \) -prune -o -iname "*cusp*" -print
      grep -rls cusp /usr/share/applications /usr/share/mime /usr/lib/udev/rules.d /var/lib/dpkg/info || true)
    if [ -n "$left" ]; then echo "left behind: $left" >&2; exit 1; fi
    cd /root/station && sha256sum --quiet -c /root/before'
}

if [ -z "$package" ]; then
  step "root" build_root
  step "package" build_package
fi
package="$(readlink -f "$package")"
echo "==== $release: $(basename "$package"), $(stat -c %s "$package") bytes"
dpkg-deb -f "$package" Depends
step "bare root" bare_root
step "higher version" raise_version
step "install" install_alone
step "window" window
step "upgrade" upgrade
step "remove" remove
echo "==== $release: whole: $SECONDS s"
