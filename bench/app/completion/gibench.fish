# Completion of gibench for fish: the program itself says what may stand next.

function __gibench_candidates
    set -l words (commandline -opc)
    set -l current (commandline -ct)
    set -l program $words[1]
    set -e words[1]
    set -l before (string match -r -- '^--[^=]*=' $current)
    set -l value (string replace -r -- '^--[^=]*=' '' $current)
    for line in ($program completion words -- $words "$current" 2>/dev/null)
        switch $line
            case ':files'
                for path in (__fish_complete_path "$value")
                    echo "$before$path"
                end
            case ':folders'
                for path in (__fish_complete_directories "$value" '')
                    echo "$before$path"
                end
            case '*'
                echo $line
        end
    end
end

complete -c gibench -f -a '(__gibench_candidates)'
