# bash completion of ridgeline: commands and options as the program's own help lists them, else files.

_ridgeline() {
  local current=${COMP_WORDS[COMP_CWORD]}
  local command=${COMP_WORDS[1]}
  if [ "$COMP_CWORD" -eq 1 ] && [[ $current != -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(
      "${COMP_WORDS[0]}" --help 2>/dev/null | sed -n '/^Subcommands:/,$s/^  \([a-z]\+\) .*/\1/p'
    )" -- "$current")
  elif [[ $current == -* ]]; then
    [[ $command == -* ]] && command=
    mapfile -t COMPREPLY < <(compgen -W "$(
      "${COMP_WORDS[0]}" $command --help 2>/dev/null | grep -o -- '--[a-z0-9-]\+' | sort -u
    )" -- "$current")
  fi
}

complete -o default -F _ridgeline ridgeline
