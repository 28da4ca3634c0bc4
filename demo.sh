#!/usr/bin/env bash
# Installs what is missing, builds, runs the demonstration and prints its tables.
# Usage: ./demo.sh [--out DIR]
set -euo pipefail
cd "$(dirname "$0")"
. cmake/packages.sh

ensure_packages "${build_packages[@]}"
[ -f build/release/build.ninja ] || cmake --preset release -DRIDGELINE_BUILD_TESTS=OFF
echo "Building"
cmake --build build/release --target ridgeline
if [ "$#" -eq 0 ]; then set -- --out out/demo; fi
exec build/release/apps/ridgeline demo "$@"
