#!/usr/bin/env bash
# Makes the sample patches again; the same bytes every time. Usage: sample_data/make.sh PROGRAM
# [FOLDER]
set -euo pipefail
program=$(realpath "$1")
cd "${2:-$(dirname "$0")}"

make() {
  rm -rf "$1"
  "$program" --quiet simulate --out "$@"
  rm "$1/simulate.json"
}

make 1 --seed 4 --aligned-share 0.9 --extent-m 65,65
make 2 --seed 24 --aligned-share 0.5 --extent-m 65,65
make 3 --seed 2 --aligned-share 0.5 --street-azimuth-deg 3 --extent-m 65,65
make 4 --seed 19 --aligned-share 0.9 --extent-m 56,56 --focal-length-px 7000 --views strip:3,cross:2
make 5 --seed 7 --aligned-share 0.5 --extent-m 65,65 --focal-length-px 13000 --blur-px 3 --bayer --jpeg-quality 85
