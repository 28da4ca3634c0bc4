# Debian / Ubuntu packages, read by demo.sh, test.sh and the scripts in .ci; the functions that
# install them, and the folder of what later checks of this user can use again, in whatever
# checkout.
ridgeline_cache=${XDG_CACHE_HOME:-$HOME/.cache}/ridgeline

build_packages=(
  g++ cmake ninja-build pkg-config git ccache
  libeigen3-dev libpcl-dev libflann-dev liblz4-dev libboost-dev
  libopencv-dev
  libgdal-dev libsqlite3-dev libexpat1-dev zlib1g-dev libssl-dev libproj-dev proj-data libembree-dev libtbb-dev
  libcli11-dev nlohmann-json3-dev libyaml-cpp-dev libfmt-dev libspdlog-dev
)
python_packages=(pybind11-dev python3-pybind11 python3-dev python3-numpy python3-setuptools python3-pip)
python_options=(-DRIDGELINE_BUILD_PYTHON=ON -DPython_EXECUTABLE=/usr/bin/python3)  # for which python3-numpy is
test_packages=(libgtest-dev libgmock-dev libbenchmark-dev gdal-bin python3-matplotlib mypy python3-yaml)
# for the tests with Node, which are skipped without; of any origin will do
node_packages=()
command -v npm >/dev/null || node_packages=(nodejs npm)
browser_packages=(chromium)
cluster_packages=(slurmctld slurmd slurm-client munge parallel)  # their test is skipped without
check_packages=(clang-format-14 clang-tidy-14)
debian_packages=(help2man dpkg-dev lintian debootstrap python3-yaml)
clang_packages=(clang-14 libclang-rt-14-dev)

# A part of a script begins: its name and the seconds since the script began.
part() { printf -- '-- %s (after %s s)\n' "$1" "$SECONDS"; }

missing_packages() {
  local package
  for package in "$@"; do
    dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed ||
      echo "$package"
  done
}

# Installs what is missing of the given packages; without root it says what to install.
ensure_packages() {
  local missing
  mapfile -t missing < <(missing_packages "$@")
  [ "${#missing[@]}" -eq 0 ] && return 0
  echo "Installing ${#missing[@]} packages: ${missing[*]}"
  local run=()
  if [ "$(id -u)" -ne 0 ]; then
    if command -v sudo >/dev/null && sudo -n true 2>/dev/null; then
      run=(sudo)
    else
      echo "No root rights here. Install them with:" >&2
      echo "  sudo apt-get install --no-install-recommends ${missing[*]}" >&2
      return 1
    fi
  fi
  "${run[@]}" apt-get update -qq
  "${run[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null && return 0
  local package
  for package in "${missing[@]}"; do
    "${run[@]}" apt-get install -s -qq "$package" >/dev/null 2>&1 ||
      echo "Package $package cannot be installed: $(apt-cache policy "$package" | sed -n 3p)" >&2
  done
  return 1
}

# The npm packages of a folder as its lock file states them, unless they are there.
install_npm_packages() {
  [ "$1/node_modules/.package-lock.json" -nt "$1/package-lock.json" ] && return 0
  npm ci --prefix "$1" --ignore-scripts --silent
}

# What the tests with Node need, where it can be had.
prepare_node_tests() {
  ensure_packages "${node_packages[@]}" && install_npm_packages tests/laz_perf ||
    echo "The comparison with laz-perf will be skipped"
  ensure_packages "${node_packages[@]}" "${browser_packages[@]}" && install_npm_packages tests/report ||
    echo "The report's tests in the browser will be skipped"
}
