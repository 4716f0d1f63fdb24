# Completion of gibench for bash: the program itself says what may stand next.

# The words after the program up to the cursor. Bash splits them at "=", the program gets them whole.
_gibench_words() {
  local i word splits=0
  words=()
  [[ $COMP_WORDBREAKS == *=* ]] && splits=1
  for ((i = 1; i <= COMP_CWORD; ++i)); do
    word=${COMP_WORDS[i]}
    if ((splits && i > 1)) && [[ $word == =* || ${COMP_WORDS[i - 1]} == *= ]]; then
      words[${#words[@]} - 1]+=$word
    else
      words+=("$word")
    fi
  done
}

_gibench() {
  local word meaning kind before="" added="" current IFS=$'\n'
  local -a words
  _gibench_words
  current=${words[${#words[@]} - 1]}
  if [[ $current == *=* ]]; then
    before=${current%"${current##*=}"} # bash replaces what stands behind the sign, or else the whole word
    [[ $COMP_WORDBREAKS == *=* ]] || added=$before
  fi
  COMPREPLY=()
  while IFS=$'\t' read -r word meaning; do
    case $word in
      :files | :folders)
        compopt -o filenames
        [[ $word == :files ]] && kind=file || kind=directory
        mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -A "$kind" -P "$added" -- "${current#"$before"}")
        ;;
      *) COMPREPLY+=("$added${word#"$before"}") ;;
    esac
  done < <("${COMP_WORDS[0]/#\~\//"$HOME"/}" completion words -- "${words[@]}" 2>/dev/null)
  if ((${#COMPREPLY[@]} == 1)) && [[ ${COMPREPLY[0]} == *= ]]; then compopt -o nospace; fi
}

complete -F _gibench gibench
