#include "support/program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace fumon::test {

namespace fs = std::filesystem;

namespace {

fs::path unique_path(const std::string& stem) {
    static std::atomic<int> count{0};
    return fs::temp_directory_path() /
           (stem + std::to_string(getpid()) + "-" + std::to_string(count++));
}

void redirect(int descriptor, const fs::path& file) {
    const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(opened, descriptor);
}

}  // namespace

Program::Program(const std::vector<std::string>& arguments, const fs::path& folder,
                 const std::vector<std::string>& environment, const std::string& program)
    : output_(unique_path("fumon-stdout-")), errors_(unique_path("fumon-stderr-")) {
    process_ = fork();
    if (process_ < 0) throw std::runtime_error("cannot fork");
    if (process_ != 0) return;
    redirect(STDOUT_FILENO, output_);
    redirect(STDERR_FILENO, errors_);
    if (chdir(folder.c_str()) != 0) _exit(126);
    setenv("FUMON_CACHE_SIZE", "0", 1);  // tests of films draw them
    for (const std::string& setting : environment) putenv(strdup(setting.c_str()));
#ifdef FUMON_SANITIZED
    // The leak checker's tracer itself crashes now and then while the driver's threads are ending.
    // The tests inside this process still look for leaks.
    setenv("ASAN_OPTIONS", "detect_leaks=0", 1);
#endif
    std::vector<char*> words{strdup(program.c_str())};
    for (const std::string& argument : arguments) words.push_back(strdup(argument.c_str()));
    words.push_back(nullptr);
    execv(program.c_str(), words.data());
    _exit(127);
}

Program::~Program() {
    if (process_ > 0) {
        kill(process_, SIGKILL);
        waitpid(process_, nullptr, 0);
    }
    std::error_code ignored;
    fs::remove(output_, ignored);
    fs::remove(errors_, ignored);
}

void Program::send(int signal) const {
    kill(process_, signal);
}

std::string Program::output() const {
    return read_text(output_);
}

Ended Program::wait() {
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = -1;
    Ended ended;
    ended.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    ended.output = read_text(output_);
    ended.errors = read_text(errors_);
    return ended;
}

Ended fumon(const std::vector<std::string>& arguments, const fs::path& folder,
            const std::vector<std::string>& environment, const std::string& program) {
    return Program(arguments, folder, environment, program).wait();
}

std::string read_text(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void write_text(const fs::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}

nlohmann::json read_manifest(const fs::path& folder) {
    return nlohmann::json::parse(read_text(folder / "run.json"));
}

std::string small_scene() {
    return "title = \"small\"\nseed = 5\n[model]\nname = \"sand\"\n[grid]\nnx = 24\nny = "
           "20\n[run]\nsteps = 20\n"
           "[frames]\nevery = 5\n[image]\nwidth = 64\nheight = 48\n";
}

std::vector<std::string> settings_that_leave_the_range() {
    std::vector<std::string> words;
    for (const char* setting : {"bed.low=-1", "model.hop_amount=slope", "model.amount=1000",
                                "model.amount_slope_factor=1000", "model.limit_amount=false",
                                "model.creep_rate=1e-9", "model.hop_per_height=0"})
        words.insert(words.end(), {"--set", setting});
    return words;
}

}  // namespace fumon::test
