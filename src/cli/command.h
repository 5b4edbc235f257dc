#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>

namespace fumon {

/// A command as `fumon --help` lists it.
struct Command {
    const char* name;
    const char* help;  ///< one line
    /// Declares the options and examples, and returns the body, which runs once they are read. The
    /// body returns the exit status, and throws InputError (2) or Error (3).
    std::function<std::function<int()>(CLI::App&)> declare;
};

/// A command of a struct of options, a function that declares them, and a body that takes them.
template <class Options>
Command make_command(const char* name, const char* help, void (*declare)(CLI::App&, Options&),
                     int (*body)(const Options&)) {
    return {name, help, [declare, body](CLI::App& command) -> std::function<int()> {
                const auto options = std::make_shared<Options>();
                declare(command, *options);
                return [body, options] { return body(*options); };
            }};
}

}  // namespace fumon
