#include <map>

#include "app/reference/completion_scripts.h"
#include "app/reference/words.h"

namespace scb::app {
namespace {

constexpr const char* bash_engine = R"(
# _scb_offer CURRENT: sets COMPREPLY to what of $words, $folders and files with $endings begins so.
_scb_offer() {
    local current=$1 before= word name ending
    if [[ -n $list ]]; then
        before=${current%"${current##*,}"}
        current=${current##*,}
        compopt -o nospace
    fi
    for word in $words; do
        [[ $word == "$current"* && ,$before != *",$word,"* ]] && COMPREPLY+=("$before$word")
    done
    [[ ${#COMPREPLY[@]} == 1 && ${COMPREPLY[0]} == *: ]] && compopt -o nospace
    [[ -n $folders$endings ]] || return
    local offered=${#COMPREPLY[@]}
    current=${current//\\/}
    while IFS= read -r name; do
        if [[ -d ${name/#\~/$HOME} ]]; then
            COMPREPLY+=("$name")
            continue
        fi
        for ending in $endings; do
            [[ ${name,,} == *"$ending" ]] && COMPREPLY+=("$name")
        done
    done < <(compgen -f -- "${current#[\"\']}")
    [[ ${#COMPREPLY[@]} -gt $offered ]] && compopt -o filenames
}

_scb() {
    local command=scb option= only= i word current glued
    local commands options valued words list folders endings most given=0
    local -a line=()
    COMPREPLY=()
    # Bash has divided words at '=' and ':'; here they are whole again.
    for ((i = 1; i <= COMP_CWORD; i++)); do
        word=${COMP_WORDS[i]}
        if [[ ${#line[@]} -gt 0 && ($word == [=:]* || $glued == *[=:]) ]]; then
            line[${#line[@]} - 1]+=$word
        else
            line+=("$word")
        fi
        glued=$word
    done
    current=${line[${#line[@]} - 1]}
    unset "line[${#line[@]} - 1]"
    _scb_command scb
    for word in "${line[@]}"; do
        if [[ -n $option ]]; then
            option=
        elif [[ $word == -- ]]; then
            only=arguments
        elif [[ -z $only && $word == -* ]]; then
            [[ " $valued " == *" $word "* ]] && option=$word
        elif [[ " $commands " == *" $word "* ]]; then
            command+=" $word"
            _scb_command "$command"
        else
            ((given++))
        fi
    done
    if [[ -z $option && -z $only && $current == --*=* ]]; then
        option=${current%%=*}
        current=${current#*=}
    fi
    if [[ -n $option ]]; then
        _scb_values "$command" "$option"
        _scb_offer "$current"
    elif [[ -z $only && $current == -* ]]; then
        COMPREPLY=($(compgen -W "$options" -- "$current"))
    elif [[ -n $commands ]]; then
        COMPREPLY=($(compgen -W "$commands" -- "$current"))
    elif ((given < most)); then
        _scb_values "$command" ""
        _scb_offer "$current"
    fi
    # What stands before a colon is a word of its own for bash, and stays.
    if [[ $current == *:* && $COMP_WORDBREAKS == *:* ]]; then
        current=${current%"${current##*:}"}
        COMPREPLY=("${COMPREPLY[@]#"$current"}")
    fi
}
complete -F _scb scb
)";

/// What completes a value, as assignments; empty where nothing is known of it.
std::string values_text(const OptionValues& values) {
    std::string text;
    if (!values.words.empty()) text += " words='" + joined(values.words, " ") + "'";
    if (values.is_list) text += " list=yes";
    if (values.is_folder) text += " folders=yes";
    if (!values.endings.empty()) text += " endings='" + joined(values.endings, " ") + "'";
    return text;
}

std::string command_case(const ReferenceCommand& command, const ReferenceCommand& program) {
    std::vector<std::string> commands, options, valued;
    for (const ReferenceCommand& sub : command.commands) commands.push_back(sub.word());
    for (const ReferenceOption* option : options_of(command, program))
        for (const std::string& name : option->names) {
            options.push_back(name);
            if (option->takes_value) valued.push_back(name);
        }
    return "    '" + command.name + "')\n        commands='" + joined(commands, " ") +
           "'\n        options='" + joined(options, " ") + "'\n        valued='" +
           joined(valued, " ") + "'\n        most=" + std::to_string(most_arguments(command)) +
           " ;;\n";
}

}  // namespace

std::string bash_completion(const ReferenceCommand& program) {
    std::string text =
        "# Completion of scb for bash, written by `scb completion bash`.\n\n"
        "# _scb_command COMMAND: sets what it takes.\n_scb_command() {\n    case $1 in\n";
    // By values, the options that take them: most are of several commands.
    std::map<std::string, std::vector<std::string>> takers;
    for (const ReferenceCommand* command : all_commands(program)) {
        text += command_case(*command, program);
        for (const ReferenceOption* option : options_of(*command, program))
            for (const std::string& name : option->names)
                takers[values_text(option->values)].push_back("'" + command->name + " " + name +
                                                              "'");
        if (const ReferenceOption* argument = command->argument())
            takers[values_text(argument->values)].push_back("'" + command->name + " '");
    }
    text +=
        "    esac\n}\n\n# _scb_values COMMAND OPTION: sets what its value can be.\n_scb_values() "
        "{\n"
        "    words= list= folders= endings=\n    case \"$1 $2\" in\n";
    takers.erase("");
    for (const auto& [values, patterns] : takers)
        text += "    " + joined(patterns, " | \\\n    ") + ")\n       " + values + " ;;\n";
    return text + "    esac\n}\n" + bash_engine;
}

}  // namespace scb::app
