# Shared by ./demo and ./test: installs the packages, builds a release. Sourced, not run.
# Safe to run again: installed packages are left alone, ninja builds only what changed.

say() { printf '\n== %s\n' "$*"; }

as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"; elif command -v sudo >/dev/null; then sudo -n "$@" || sudo "$@"; else
    echo "Installing packages needs root: run this as root, or install sudo." >&2
    return 1
  fi
}

# What the build and the tests need, by Debian 12's names (the CMake package of libopenimageio-dev asks for the tools, too).
build_packages="g++ cmake ninja-build python3
  libboost-dev libopenimageio-dev openimageio-tools libimath-dev libtbb-dev libpng-dev libdeflate-dev libjpeg62-turbo-dev
  libtiff-dev libopenexr-dev libgif-dev libhwy-dev libfmt-dev libcli11-dev nlohmann-json3-dev libtomlplusplus-dev libssl-dev libgtest-dev libgmock-dev
  libcpp-httplib-dev libseccomp-dev pybind11-dev python3-dev python3-numpy"
[ "$(dpkg --print-architecture)" != amd64 ] || build_packages+=" libxbyak-dev"
# The oracle.
oracle_packages="povray povray-includes povray-examples"
# A cluster on one machine, which the test farm.slurm starts.
farm_packages="slurm-wlm munge"

# install_packages [PACKAGE...]: those; what the build and the oracle need, if none is named.
install_packages() {
  local missing=() package
  [ "$#" -gt 0 ] || set -- $build_packages $oracle_packages
  for package in "$@"; do
    dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed || missing+=("$package")
  done
  if [ "${#missing[@]}" -eq 0 ]; then
    say "All packages are installed"
    return
  fi
  say "Installing ${missing[*]}"
  as_root env DEBIAN_FRONTEND=noninteractive apt-get update -q </dev/null
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}" </dev/null
}

# build TARGET...: a release in build/release; from nothing eight sources at a time, which halves the time (CONTRIBUTING.md).
build() {
  say "Building a release in build/release"
  local units=()
  [ -f build/release/build.ninja ] || units=(-DVERISIM_UNITS=ON)
  cmake --preset release "${units[@]}" >/tmp/verisim-configure.$$ 2>&1 </dev/null || { cat /tmp/verisim-configure.$$; rm -f /tmp/verisim-configure.$$; return 1; }
  rm -f /tmp/verisim-configure.$$
  # Compiling takes about 1.5 GB a process: no more processes than there is memory for.
  local cores memory jobs
  cores=$(nproc)
  memory=$(awk '/MemAvailable/ { print int($2 / 1500000) }' /proc/meminfo)
  jobs=$((memory < 1 ? 1 : memory < cores ? memory : cores))
  ninja -C build/release -j "$jobs" "$@" </dev/null
}
