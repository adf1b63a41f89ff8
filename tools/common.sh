# shellcheck shell=bash
# What tools/run, tools/test and tools/tidy share: source it. It defines `root` and functions.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '%s\n' "$*" >&2; }

# Prints the packages of tools/packages that are not installed.
missing_packages() {
  local package
  grep -Ev '^(#|$)' "$root/tools/packages" | while read -r package; do
    dpkg-query -W -f '${db:Status-Abbrev}' "$package" 2>/dev/null | grep -q '^ii' || echo "$package"
  done
}

# Installs what is missing; asks apt for new lists only if the known ones do not have the packages.
install_packages() {
  command -v dpkg-query >/dev/null || {
    say "This is not a Debian system: install the equivalents of tools/packages yourself."
    return 0
  }
  local missing as_root=()
  mapfile -t missing < <(missing_packages)
  (( ${#missing[@]} )) || return 0
  if (( EUID )); then
    command -v sudo >/dev/null || {
      say "Missing packages, and no sudo to install them. As root: apt-get install ${missing[*]}"
      return 1
    }
    as_root=(sudo)
  fi
  say "Installing ${missing[*]}"
  local install=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive
    apt-get install --yes --no-install-recommends "${missing[@]}")
  apt-get install --simulate --no-install-recommends "${missing[@]}" >/dev/null 2>&1 ||
    "${as_root[@]}" apt-get update
  "${install[@]}" || { "${as_root[@]}" apt-get update && "${install[@]}"; }
}

# How many compilers fit at once: one per processor, and about 1.5 GB for each.
build_jobs() {
  local available_kb processors
  available_kb=$(awk '/MemAvailable/ {print $2}' /proc/meminfo)
  processors=$(nproc)
  local fitting=$(( available_kb / 1500000 ))
  (( fitting < 1 )) && fitting=1
  echo $(( fitting < processors ? fitting : processors ))
}

# build PRESET [TARGET…]: configures build/PRESET if need be, and builds.
build() {
  local preset=$1
  shift
  local tree=$root/build/$preset
  [[ -f $tree/build.ninja ]] || (cd "$root" && cmake --preset "$preset" -Wno-dev) >&2
  cmake --build "$tree" --parallel "$(build_jobs)" ${1:+--target "$@"} >&2
}
