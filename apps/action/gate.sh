#!/usr/bin/env bash
# Step of action.yml: applies the gates to the results; its exit code is that of `ridgeline gate`.
set -euo pipefail

baseline=()
[ -z "$INPUT_BASELINE" ] || baseline=(--baseline "$INPUT_BASELINE")
status=0
ridgeline gate "$RESULTS" --gates "$INPUT_GATES" "${baseline[@]}" \
  --junit "$RESULTS/gates.xml" --summary "$RESULTS/gates.md" || status=$?

passed=false
[ "$status" -ne 0 ] || passed=true
echo "passed=$passed" >>"$GITHUB_OUTPUT"
[ ! -f "$RESULTS/gates.xml" ] || echo "junit=$RESULTS/gates.xml" >>"$GITHUB_OUTPUT"
exit "$status"
