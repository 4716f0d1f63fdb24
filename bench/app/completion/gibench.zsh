#compdef gibench
# Completion of gibench for zsh: the program itself says what may stand next.

_gibench() {
  local line word paths=""
  local -a typed=("${(@Q)words[2,CURRENT]}") whole open
  for line in "${(@f)$("${(Q)words[1]/#\~\//$HOME/}" completion words -- "${typed[@]}" 2>/dev/null)}"; do
    word=${line%%$'\t'*}
    case $line in
      "") ;;
      :files | :folders) paths=$line ;;
      *=$'\t'*) open+=("${word//:/\\:}:${line#*$'\t'}") ;;
      *) whole+=("${word//:/\\:}:${line#*$'\t'}") ;;
    esac
  done
  ((${#whole})) && _describe 'gibench' whole
  ((${#open})) && _describe 'parameter' open -S ''
  if [[ -n $paths ]]; then
    compset -P '--*='
    if [[ $paths == :files ]]; then _files; else _files -/; fi
  fi
}

if [[ ${funcstack[1]} == _gibench ]]; then _gibench "$@"; else compdef _gibench gibench; fi
