# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
# Completion of voussoir's command line in bash: source scripts/completion.bash
# Everything is asked of the program itself, so that nothing here can drift: commands and options of --help, cases of `voussoir cases`.

_voussoir() {
  local program=${COMP_WORDS[0]} command=${COMP_WORDS[1]} word=${COMP_WORDS[COMP_CWORD]} words=""
  if [ "$COMP_CWORD" -eq 1 ]; then
    words=$("$program" --help 2>/dev/null | sed -nE '/^Subcommands:/,/^$/s/^  ([a-z]+) .*/\1/p')
  elif [[ $word == -* ]]; then
    words=$("$program" "$command" --help 2>/dev/null | sed -nE 's/^  (-.,)?(--[a-z-]+).*/\2/p')
  elif [[ $COMP_CWORD -eq 2 && $command =~ ^(run|check|modes|limit|bench)$ ]]; then
    words=$("$program" cases 2>/dev/null | sed -nE 's/^([a-z0-9-]+) .*/\1/p')
  fi
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}
complete -o default -F _voussoir voussoir  # -o default: where nothing fits, names of files
