#!/usr/bin/env bash
# Installs what is missing, builds everything and runs every test.
# Usage: ./test.sh [ctest arguments]
set -euo pipefail
cd "$(dirname "$0")"
. cmake/packages.sh

part "Packages"
ensure_packages "${build_packages[@]}" "${python_packages[@]}" "${test_packages[@]}"
prepare_node_tests
part "Building"
cmake --preset release -DRIDGELINE_BUILD_TESTS=ON -DRIDGELINE_BUILD_BENCHMARKS=ON "${python_options[@]}" \
  -DRIDGELINE_TEST_SHARDS="${RIDGELINE_TEST_SHARDS:-0}"
cmake --build build/release
part "Tests"
exec ctest --test-dir build/release --output-on-failure --parallel "$(nproc)" "$@"
