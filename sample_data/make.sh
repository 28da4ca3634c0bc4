#!/usr/bin/env bash
# Makes the three sample patches again; the same bytes every time. Usage: sample_data/make.sh PROGRAM
set -euo pipefail
program=$(realpath "$1")
cd "$(dirname "$0")"
"$program" simulate --out 1 --seed 4 --aligned-share 0.9 --extent-m 65,65
"$program" simulate --out 2 --seed 24 --aligned-share 0.5 --extent-m 65,65
"$program" simulate --out 3 --seed 2 --aligned-share 0.5 --street-azimuth-deg 3 --extent-m 65,65
