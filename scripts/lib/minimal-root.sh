# A minimal Debian in a folder, for scripts that check what a fresh machine needs. Read it with `.` in the repository's folder, in a
# shell with `set -eu`; needs root and debootstrap, and takes the mirror and the apt settings of this machine.
#
#   root=DIR; keep=0   before: DIR, or "" for a temporary folder; keep=1 leaves it there
#   suite=NAME         before: bookworm (Debian 12), trixie (13), forky (testing); "" for that of this machine
#   make_root          makes it, unless there is one; removes it or says where it is when the shell ends
#   inside COMMAND     runs a shell command in it, in its folder /src; SHELLMATCH_DATA is its /data, which it cannot change

fail() {
  printf '%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 3
}

minutes() { awk -v s="$1" 'BEGIN { printf "%.1f min (%d s)", s / 60, s }'; }

clean_up_root() {
  for place in data dev/pts dev proc; do
    if mountpoint -q "$root/$place"; then umount "$root/$place" || keep=1; fi
  done
  # Deletes nothing below a mount that could not be removed, such as the machine's own /dev.
  if [ "$keep" -eq 0 ]; then rm -rf --one-file-system "$root"; else echo "The root is in $root"; fi
}

make_root() {
  [ "$(id -u)" -eq 0 ] || fail "only root can make and enter another root; run it as root"
  for tool in debootstrap chroot mount git apt-get; do
    command -v $tool >/dev/null || fail "'$tool' is missing; install it"
  done
  [ -n "$root" ] || root=$(mktemp -d)
  mkdir -p "$root"
  root=$(cd "$root" && pwd)
  trap clean_up_root EXIT
  trap 'exit 130' INT TERM

  # The mirror from which this machine's apt installs its own release.
  own=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")
  suite=${suite:-$own}
  mirror=$(apt-get indextargets --format '$(REPO_URI) $(RELEASE) $(CREATED_BY)' |
    awk -v own="$own" '$2 == own && $3 == "Packages" { print $1; exit }')
  [ -n "$mirror" ] || fail "apt on this machine knows no source for '$own'; add one under /etc/apt"
  proxy=$(apt-config shell proxy Acquire::http::Proxy)
  eval "$proxy"
  [ -z "${proxy:-}" ] || { http_proxy=$proxy; export http_proxy; }

  if [ ! -x "$root/usr/bin/apt-get" ]; then
    echo "Making a minimal Debian, $suite ..."
    start=$(date +%s)
    # A release that is newer than this debootstrap is made as unstable is.
    recipe=/usr/share/debootstrap/scripts/$suite
    [ -e "$recipe" ] || recipe=/usr/share/debootstrap/scripts/sid
    debootstrap --variant=minbase "$suite" "$root" "$mirror" "$recipe" >"$root.log" 2>&1 || {
      tail -n 20 "$root.log" >&2
      fail "debootstrap failed (its last lines are above; all of them in $root.log)"
    }
    rm -f "$root.log"
    echo "  $(minutes $(($(date +%s) - start)))"
  fi

  # Copies the keys and transport settings of apt, the sources where they are for the same release, and the settings of name resolution.
  rm -rf "$root/etc/apt/sources.list" "$root/etc/apt/sources.list.d"
  mkdir -p "$root/etc/apt/sources.list.d" "$root/etc/apt/apt.conf.d" "$root/usr/share/keyrings"
  if [ "$suite" = "$own" ]; then
    for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list /etc/apt/sources.list.d/*.sources; do
      [ -f "$file" ] && cp "$file" "$root$file"
    done
  else
    echo "deb $mirror $suite main" >"$root/etc/apt/sources.list"
  fi
  for file in /usr/share/keyrings/*.gpg /etc/apt/trusted.gpg.d/*; do
    if [ -f "$file" ] && [ ! -e "$root$file" ]; then cp "$file" "$root$file"; fi
  done
  apt-config dump --format '%F "%v";%n' | grep -E '^(Acquire::(http|https|ftp|Check)|APT::Sandbox)' \
    >"$root/etc/apt/apt.conf.d/00of-this-machine" || true
  [ -f /etc/resolv.conf ] && cp -L /etc/resolv.conf "$root/etc/resolv.conf"
  [ -f /etc/hosts ] && cp -L /etc/hosts "$root/etc/hosts"

  rm -rf "$root/src"
  mkdir "$root/src"
  mountpoint -q "$root/proc" || mount -t proc proc "$root/proc"
  mountpoint -q "$root/dev" || mount --bind /dev "$root/dev"
  # The pseudo-terminals that tests take are a file system of their own.
  if mountpoint -q /dev/pts && ! mountpoint -q "$root/dev/pts"; then mount --bind /dev/pts "$root/dev/pts"; fi
  if [ -n "${SHELLMATCH_DATA:-}" ] && ! mountpoint -q "$root/data"; then
    mkdir -p "$root/data"
    mount --bind "$SHELLMATCH_DATA" "$root/data" || fail "SHELLMATCH_DATA should name a folder: $SHELLMATCH_DATA"
    mount -o remount,bind,ro "$root/data"
  fi
}

inside() {
  chroot "$root" env -i HOME=/ PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin TERM=dumb \
    ${SHELLMATCH_DATA:+SHELLMATCH_DATA=/data} ${SHELLMATCH_BROWSER:+SHELLMATCH_BROWSER=$SHELLMATCH_BROWSER} \
    sh -c "cd /src && $1" </dev/null
}
