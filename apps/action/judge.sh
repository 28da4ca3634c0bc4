#!/usr/bin/env bash
# Step of action.yml: judges the lines, or reconstructs and judges the patches if there are no
# lines.
set -euo pipefail

# The lines of a text, without blanks around them and without empty lines.
list() { sed 's/^[[:space:]]*//; s/[[:space:]]*$//; /^$/d' <<<"$1"; }
mapfile -t lines < <(list "$INPUT_LINES")
mapfile -t clouds < <(list "$INPUT_CLOUD")
mapfile -t patches < <(list "$INPUT_PATCH")
words=$(mktemp)
xargs -r printf '%s\0' <<<"$INPUT_ARGUMENTS" >"$words"  # understands quotes, expands nothing
mapfile -d '' -t arguments <"$words"
rm "$words"

# An option without values is left out; the program says what is missing.
add_option() { [ "$#" -eq 1 ] || command+=("$@"); }
if [ "${#lines[@]}" -eq 0 ] && [ "${#patches[@]}" -gt 0 ]; then
  command=(run "${patches[@]}")
else
  command=(evaluate)
  add_option --lines "${lines[@]}"
  add_option --patch "${patches[@]}"
fi
add_option --cloud "${clouds[@]}"

rm -f "$INPUT_OUT"/gates.{xml,md}  # of an earlier use of this folder
ridgeline "${command[@]}" --out "$INPUT_OUT" "${arguments[@]}"

echo "results=$INPUT_OUT" >>"$GITHUB_OUTPUT"
[ ! -f "$INPUT_OUT/report.html" ] || echo "report=$INPUT_OUT/report.html" >>"$GITHUB_OUTPUT"
