#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace fumon {

/// How a command ends. Where several things were asked for, the highest that occurred counts. What
/// a signal stopped and may go on with ends as shells have it, with 128 + its number.
enum ExitStatus : int {
    all_is_well = 0,
    differs_from_expected = 1,  ///< pictures that were compared
    input_is_wrong = 2,         ///< a scene, a file, the command line
    could_not_work = 3,         ///< disk, folder, memory, OpenGL, a crash, a run that failed
};

/// The base of everything fumon throws on purpose. `main` catches it once, prints one line and
/// exits with `exit_status()`: could_not_work (full disk, NaN in a field, no OpenGL).
class Error : public std::runtime_error {
  public:
    explicit Error(const std::string& what) : std::runtime_error(what) {}
    [[nodiscard]] virtual int exit_status() const { return could_not_work; }
};

/// A text as one line can show it: line ends and tabs as spaces, other control characters as '?'.
inline std::string one_line(std::string text) {
    for (char& letter : text) {
        const auto code = static_cast<unsigned char>(letter);
        if (letter == '\n' || letter == '\r' || letter == '\t') {
            letter = ' ';
        } else if (code < 0x20 || code == 0x7F) {
            letter = '?';
        }
    }
    return text;
}

/// The user's input is wrong: a scene, a terrain file or the command line. Exit status 2; nothing
/// has been written. The text is one line (see one_line), located as `file:line:column: ` where
/// there is a place.
class InputError : public Error {
  public:
    explicit InputError(std::string what) : InputError(std::vector{std::move(what)}) {}
    /// Of several faults, which its text has a line each.
    explicit InputError(std::vector<std::string> faults)
        : Error(joined(faults)), lines_(std::move(faults)) {}
    [[nodiscard]] int exit_status() const override { return input_is_wrong; }
    [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }

  private:
    static std::string joined(std::vector<std::string>& faults) {
        std::string text;
        for (std::string& fault : faults) {
            fault = one_line(std::move(fault));
            text += (text.empty() ? "" : "\n") + fault;
        }
        return text;
    }

    std::vector<std::string> lines_;
};

/// The same faults with `place` before each of them.
inline InputError placed(const std::string& place, const InputError& fault) {
    std::vector<std::string> lines = fault.lines();
    for (std::string& line : lines) line.insert(0, place);
    return InputError(std::move(lines));
}

/// A key's value does not fit the rest of the scene; whoever knows the scene puts the key's place
/// before it.
class KeyError : public InputError {
  public:
    KeyError(std::string key, const std::string& what) : InputError(what), key_(std::move(key)) {}
    [[nodiscard]] const std::string& key() const { return key_; }

  private:
    std::string key_;
};

}  // namespace fumon
