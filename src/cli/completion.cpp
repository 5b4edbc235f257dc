#include "cli/completion.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "base/error.h"
#include "film/script/film_keys.h"
#include "run/inputs/scene_argument.h"
#include "run/inputs/shipped_scenes.h"
#include "scene/describe.h"
#include "scene/read.h"

namespace fumon {

namespace {

constexpr const char* mark_of_words = "words:";

void keep_those_that_begin_with(const std::string& begin, std::vector<std::string>& words) {
    std::erase_if(words, [&](const std::string& word) { return !word.starts_with(begin); });
}

/// The option that a word names ("--set", or "--set=camera…"), or none.
CLI::Option* option_of(CLI::App& command, const std::string& word) {
    if (!word.starts_with("-")) return nullptr;
    return command.get_option_no_throw(word.substr(0, word.find('=')));
}

bool takes_a_value(CLI::Option& option) {
    return option.get_items_expected_max() > 0;
}

/// The model of the scene that stands on the command line; empty where there is none.
std::string model_on(const std::vector<std::string>& words) {
    for (std::size_t k = 1; k + 1 < words.size(); ++k) {
        if (words[k].starts_with("-") || words[k].find('=') != std::string::npos) continue;
        try {
            return read_scene(scene_argument(words[k])).model.name;
        } catch (const Error&) {
            continue;  // no scene
        }
    }
    return {};
}

/// "camera.azimuth=" …, or after the sign what the key takes.
Completion settings(const std::string& begun, const std::vector<KeyWords>& keys,
                    const std::string& before) {
    Completion found;
    const std::size_t sign = begun.find('=');
    for (const KeyWords& key : keys) {
        const std::string until_value = fmt::format("{}{}=", before, key.path);
        if (sign == std::string::npos) {
            found.words.push_back(until_value);
        } else if (key.path == begun.substr(0, sign)) {
            for (const std::string& word : key.words)
                found.words.push_back(fmt::format("{}{}", until_value, word));
            found.files = key.words.empty();
        }
    }
    return found;
}

Completion values(CLI::App& command, CLI::Option& option, const std::string& begun,
                  const std::vector<std::string>& words, const std::string& before) {
    if (option.check_lname("set") || option.check_lname("over")) {
        const bool of_film = command.get_name() == "film";
        return settings(begun, of_film ? film_key_words() : scene_key_words(model_on(words)),
                        before);
    }
    Completion found{words_of_option(option), false};
    for (std::string& word : found.words) word.insert(0, before);
    found.files = found.words.empty();
    return found;
}

Completion positionals(CLI::App& command) {
    const std::string& name = command.get_name();
    Completion found;
    const auto add_scenes = [&](const std::vector<std::string>& folders) {
        for (const ShippedScene& scene : shipped_scenes(folders)) found.words.push_back(scene.name);
    };
    if (name == "describe") {
        found.words = described_names();
        found.words.emplace_back("film");
        for (const KeyWords& key : film_key_words())
            found.words.push_back(without_numbers(key.path));
    } else if (name == "new") {
        add_scenes(shipped_folders);
    } else if (name == "completion") {
        found.words = {"bash", "zsh", "fish"};
    } else if (name == "man" || name == "help") {
        for (const CLI::App* one : command.get_parent()->get_subcommands({}))
            found.words.push_back(one->get_name());
    } else if (name == "figure") {
        for (const ShippedScene& scene : shipped_scenes({"figures"}))
            found.words.push_back(scene.file.stem().string());
        found.files = true;
    } else {
        if (command.get_option_no_throw("SCENE") != nullptr ||
            command.get_option_no_throw("INPUT") != nullptr)
            add_scenes({""});
        found.files = true;
    }
    return found;
}

Completion all_candidates(CLI::App& app, const std::vector<std::string>& words) {
    const std::string& begun = words.back();
    const auto options = [&](const CLI::App& command) {
        Completion found;
        for (const CLI::Option* option : command.get_options()) {
            for (const std::string& name : option->get_lnames()) found.words.push_back("--" + name);
            for (const std::string& name : option->get_snames()) found.words.push_back("-" + name);
        }
        return found;
    };
    if (words.size() == 1) {
        if (begun.starts_with("-")) return options(app);
        Completion found;
        for (const CLI::App* command : app.get_subcommands({}))
            found.words.push_back(command->get_name());
        return found;
    }
    CLI::App* command = nullptr;
    for (CLI::App* known : app.get_subcommands({})) {
        if (known->get_name() == words.front()) command = known;
    }
    if (command == nullptr) return {{}, true};
    const std::string& previous = words[words.size() - 2];
    CLI::Option* option = option_of(*command, previous);
    if (option != nullptr && takes_a_value(*option) && previous.find('=') == std::string::npos)
        return values(*command, *option, begun, words, "");
    if (!begun.starts_with("-")) return positionals(*command);
    const std::size_t sign = begun.find('=');
    option = option_of(*command, begun);
    if (sign != std::string::npos && option != nullptr && takes_a_value(*option))
        return values(*command, *option, begun.substr(sign + 1), words, begun.substr(0, sign + 1));
    return options(*command);
}

constexpr const char* bash_script =
    R"script(# Completes fumon's command line in bash: source <(fumon completion bash)
_fumon() {
    local line=${COMP_LINE:0:COMP_POINT} words current answer word
    read -ra words <<< "$line"
    [[ $line == *[[:space:]] ]] && words+=("")
    current=${words[-1]}
    COMPREPLY=()
    compopt +o nospace 2> /dev/null
    while IFS= read -r word; do
        if [[ $word == :files ]]; then
            compopt -o default 2> /dev/null
            while IFS= read -r word; do COMPREPLY+=("$word"); done < <(compgen -f -- "${current##*=}")
            continue
        fi
        [[ $word == *= ]] && compopt -o nospace 2> /dev/null
        # bash replaces what stands behind the last = or : alone
        local before=${current%"${current##*[=:]}"}
        COMPREPLY+=("${word#"$before"}")
    done < <("${words[0]}" completion --line -- "${words[@]:1}" 2> /dev/null)
}
complete -F _fumon fumon
)script";

constexpr const char* zsh_script = R"script(#compdef fumon
# Completes fumon's command line in zsh: as a file _fumon in a folder of $fpath, or source <(fumon completion zsh)
_fumon() {
    local word
    local -a plain open
    for word in "${(@f)$(${words[1]} completion --line -- "${(@)words[2,CURRENT]}" 2> /dev/null)}"; do
        if [[ $word == :files ]]; then
            compset -P '*='
            _files
        elif [[ $word == *= ]]; then
            open+=("$word")
        elif [[ -n $word ]]; then
            plain+=("$word")
        fi
    done
    (( $#plain )) && compadd -- "${plain[@]}"
    (( $#open )) && compadd -S '' -- "${open[@]}"
    return 0
}
if [[ $funcstack[1] == _fumon ]]; then
    _fumon "$@"
else
    compdef _fumon fumon
fi
)script";

constexpr const char* fish_script =
    R"script(# Completes fumon's command line in fish: fumon completion fish | source
function __fumon_complete
    set -l words (commandline -opc) (commandline -ct)
    $words[1] completion --line -- $words[2..-1] 2> /dev/null | string match -v -- ':files'
end
complete -c fumon -a '(__fumon_complete)'
)script";

}  // namespace

Completion completion(CLI::App& app, const std::vector<std::string>& words) {
    const std::vector<std::string> typed = words.empty() ? std::vector<std::string>{""} : words;
    Completion found = all_candidates(app, typed);
    keep_those_that_begin_with(typed.back(), found.words);
    std::ranges::sort(found.words);
    found.words.erase(std::unique(found.words.begin(), found.words.end()), found.words.end());
    return found;
}

std::string words_as_name(const std::vector<std::string>& words) {
    std::string name = mark_of_words;
    for (const std::string& word : words) name += " " + word;
    return name;
}

std::vector<std::string> words_of_option(CLI::Option& option) {
    std::vector<std::string> words;
    try {
        for (int number = 0;; ++number) {
            const std::string name = option.get_validator(number)->get_name();
            if (!name.starts_with(mark_of_words)) continue;
            std::istringstream text(name.substr(std::string_view(mark_of_words).size()));
            for (std::string word; text >> word;) words.push_back(word);
            return words;
        }
    } catch (const CLI::OptionNotFound&) {
        return words;  // there is no further validator
    }
}

std::string completion_script(const std::string& shell) {
    if (shell == "bash") return bash_script;
    if (shell == "zsh") return zsh_script;
    if (shell == "fish") return fish_script;
    return {};
}

}  // namespace fumon
