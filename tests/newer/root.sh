#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause

# Roots of other versions of Debian, in which this checkout is built and tested (./dev newer).
#
# Usage: root.sh make <root> <suite>       makes a small root of a suite of Debian, unless it is there
#        root.sh in [--online] <root> <command…>   runs a command there, in this checkout's folder
#        root.sh remove <root>             deletes a root
#
# A command sees this checkout read-only at its own path, ../shared and the compiler's cache as well.
# The folder build is that of the root, and out is out/newer/<suite>. Mounts, processes and network
# are those of namespaces: all are gone when the command ends, however it ends. Those who are not
# root get a user namespace, too, which takes newuidmap and a line in /etc/subuid and /etc/subgid.
set -euo pipefail

script=$(realpath "${BASH_SOURCE[0]}")
checkout=$(dirname "$(dirname "$(dirname "$script")")")

die() {
  echo "root.sh: $*" >&2
  exit 1
}

# namespaces <option…> -- <command…>: runs a command as root of namespaces of its own.
namespaces() {
  local options=(--mount --propagation private --pid --fork --kill-child)
  if [[ $EUID -ne 0 ]]; then
    command -v newuidmap >/dev/null || die "those who are not root need newuidmap (package uidmap)"
    options+=(--user --map-root-user --map-auto)
  fi
  while [[ $1 != -- ]]; do
    options+=("$1")
    shift
  done
  unshare "${options[@]}" "$@"
}

make_root() {
  local root=$1 suite=$2
  [[ ! -e $root/etc/debian_version ]] || return 0
  remove_root "$root.new"
  mkdir -p "$(dirname "$root")"
  # Proxies, and which dates of a mirror are accepted, are those of this machine's apt.
  apt-config dump --no-empty | grep -E '^Acquire::(https?::Proxy|Check-)' >"$root.apt" || true
  namespaces -- mmdebstrap --mode=root --variant=minbase --include=ca-certificates,git,iproute2 \
    --aptopt="$root.apt" "$suite" "$root.new"
  rm "$root.apt"
  namespaces -- "$script" complete "$root.new"
  mv -T "$root.new" "$root"
}

# Adds what a root needs here: folders, and settings by which packages start no services, are not
# kept as files, bring no manuals, and are not flushed to the disk one by one.
complete_root() {
  local root=$1
  echo 'APT::Keep-Downloaded-Packages "false";' >"$root/etc/apt/apt.conf.d/98winding"
  printf '%s\n' force-unsafe-io 'path-exclude=/usr/share/doc/*' 'path-exclude=/usr/share/man/*' \
    'path-exclude=/usr/share/locale/*' >"$root/etc/dpkg/dpkg.cfg.d/winding"
  printf '#!/bin/sh\nexit 101\n' >"$root/usr/sbin/policy-rc.d"
  chmod +x "$root/usr/sbin/policy-rc.d"
  mkdir -p "$root/var/lib/winding/build"
}

remove_root() {
  [[ ! -e $1 ]] || namespaces -- rm -rf --one-file-system "$1"
}

# bind <root> <folder> [<folder in the root>]: mounts a folder, if it exists, there at its own path.
bind() {
  local at=$1${3:-$2}
  [[ -d $2 ]] || return 0
  mkdir -p "$at"
  mount --rbind "$2" "$at"
}

bind_read_only() {
  bind "$@"
  [[ ! -d $2 ]] || mount -o remount,bind,ro "$1${3:-$2}"
}

# enter <network> <root> <command…>: runs in the namespaces, as their first process, which gets no
# signal but those that it traps. `network` is private where its only device is still to start.
enter() {
  local network=$1 root=$2 suite common variables
  shift 2
  suite=$(basename "$root")
  trap 'exit 130' INT TERM HUP
  mount -t proc proc "$root/proc" 2>/dev/null || mount --rbind /proc "$root/proc"
  bind "$root" /sys 2>/dev/null || true # not for others than root with the network of this machine
  bind "$root" /dev
  cp /etc/resolv.conf "$root/etc/resolv.conf"
  mkdir -p "$checkout/build" "$checkout/out/newer/$suite"
  bind "$root" "$checkout"
  bind "$root" "$root/var/lib/winding/build" "$checkout/build"
  bind "$root" "$checkout/out/newer/$suite" "$checkout/out"
  mount -o remount,bind,ro "$root$checkout"
  bind_read_only "$root" "$(realpath -m "$checkout/../shared")"
  common=$(git -c safe.directory='*' -C "$checkout" rev-parse --git-common-dir 2>/dev/null || true)
  [[ $common != /* ]] || bind_read_only "$root" "$common" # that of a worktree lies elsewhere
  variables=(HOME=/root LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin "TERM=${TERM:-dumb}"
    DEBIAN_FRONTEND=noninteractive PYTHONDONTWRITEBYTECODE=1
    GIT_CONFIG_COUNT=1 GIT_CONFIG_KEY_0=safe.directory 'GIT_CONFIG_VALUE_0=*'
    OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1)
  if [[ $WINDING_CCACHE_DIR ]]; then
    bind "$root" "$WINDING_CCACHE_DIR" /root/.cache/ccache
    variables+=("CCACHE_MAXSIZE=$WINDING_CCACHE_SIZE" "CCACHE_BASEDIR=$(dirname "$checkout")"
      CCACHE_NOHASHDIR=1)
  fi
  [[ $network != private ]] || chroot "$root" ip link set lo up
  chroot "$root" env -i "${variables[@]}" env --chdir="$checkout" "$@"
}

run_in() {
  local network=private options=(--net)
  if [[ $1 == --online ]]; then
    network=shared options=()
    shift
  fi
  [[ -e $1/var/lib/winding ]] || die "no root in $1"
  WINDING_CCACHE_DIR=$(ccache --get-config cache_dir 2>/dev/null || true)
  WINDING_CCACHE_SIZE=$(ccache --get-config max_size 2>/dev/null || true)
  export WINDING_CCACHE_DIR WINDING_CCACHE_SIZE
  namespaces "${options[@]}" -- "$script" enter "$network" "$@"
}

action=${1:-}
[[ $# -ge 2 ]] || die "see the usage at the head of $script"
shift
case $action in
  make) make_root "$@" ;;
  in) run_in "$@" ;;
  remove) remove_root "$1" ;;
  complete) complete_root "$@" ;; # these two run in namespaces
  enter) enter "$@" ;;
  *) die "no action '$action'" ;;
esac
