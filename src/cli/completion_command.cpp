#include <cstdio>
#include <memory>

#include "base/error.h"
#include "cli/command.h"
#include "cli/completion.h"
#include "cli/examples.h"
#include "cli/shared_options.h"

namespace fumon {

namespace {

struct CompletionOptions {
    std::vector<std::string> words;  ///< the shell; or, to be completed, a command line
    bool line = false;
};

int perform(CLI::App& app, const CompletionOptions& options) {
    if (!options.line) {
        if (options.words.size() != 1)
            throw InputError("fumon completion: name one shell: bash, zsh or fish");
        if (const std::string fault = word_fault(options.words.front(), {"bash", "zsh", "fish"});
            !fault.empty())
            throw InputError("fumon completion: " + fault);
        std::fputs(completion_script(options.words.front()).c_str(), stdout);
        return 0;
    }
    const Completion found = completion(app, options.words);
    for (const std::string& word : found.words) std::puts(word.c_str());
    if (found.files) std::puts(":files");
    return 0;
}

}  // namespace

Command completion_command() {
    return {"completion", "print what completes fumon's command line in bash, zsh or fish",
            [](CLI::App& command) -> std::function<int()> {
                const auto options = std::make_shared<CompletionOptions>();
                command.add_option("SHELL", options->words, "bash, zsh or fish");
                command.add_flag("--line", options->line,
                                 "complete a command line: its words after --, the last one as far "
                                 "as it is typed; a line :files stands for the names of files");
                add_examples(command,
                             {{"fumon completion bash", "source <(…) in ~/.bashrc reads it"},
                              {"fumon completion --line -- run --set look.mo", ""}});
                return [&command, options] { return perform(*command.get_parent(), *options); };
            }};
}

}  // namespace fumon
