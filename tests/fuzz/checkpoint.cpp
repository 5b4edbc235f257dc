// Checkpoints: the input's first byte chooses a scheme of a model, the rest are the file's entries,
// which get the head, length and checksum that belong to them; from 128 on, the rest is the whole
// file. With --make-corpus=FOLDER it writes a checkpoint of each scheme there, which is needed
// whenever checkpoints change.

#include "files/checkpoint.h"

#include <fstream>
#include <sstream>

#include "checkpoint_target.h"
#include "fuzz_input.h"

namespace {

using namespace fumon;

template <class Number>
std::string little_endian(Number number) {
    std::string bytes;
    for (std::size_t i = 0; i < sizeof number; ++i)
        bytes += static_cast<char>(number >> (8 * i) & 0xFF);
    return bytes;
}

std::string whole_file(std::string_view entries) {
    std::string file(checkpoint_magic);
    file += little_endian(checkpoint_format);
    file += entries;
    file += little_endian(static_cast<std::uint64_t>(file.size()));
    Sha256Stream hash;
    hash.add(file.data(), file.size());
    const Sha256 sum = hash.finish();
    return file.append(sum.begin(), sum.end());
}

void read_checkpoint(const std::string& bytes, std::size_t kind) {
    fuzz::taken([&] {
        CheckpointReader reader(std::make_unique<std::istringstream>(bytes), "checkpoint.fumon");
        RunCheckpoint checkpoint;
        checkpoint.serialise(reader);
        const auto model = fuzz::small_model(kind);
        model->serialise(reader);
        reader.finish();
        if (model->steps_done() < 0 || model->snapshot().bed.size() == 0)
            fuzz::broken_promise("a restored model can be shown", "");
    });
}

constexpr std::size_t head_size = checkpoint_magic.size() + sizeof checkpoint_format;
constexpr std::size_t end_size = sizeof(std::uint64_t) + sizeof(Sha256);

/// A checkpoint of each scheme after two steps, as an input.
void make_corpus(const std::filesystem::path& folder) {
    for (std::size_t kind = 0; kind < fuzz::checkpoint_kinds.size(); ++kind) {
        const auto model = fuzz::small_model(kind);
        for (int step = 0; step < 2; ++step) model->step();
        RunCheckpoint checkpoint;
        checkpoint.scene = fuzz::checkpoint_kinds.at(kind).scene;
        checkpoint.step = model->steps_done();
        checkpoint.beds = {{0, {{".asc", {}}}}, {1, {{".asc", {}}, {".prj", {}}}}};
        checkpoint.inputs.push_back({"bed.asc", "00ff"});
        const std::filesystem::path file = folder / fuzz::checkpoint_kinds.at(kind).name;
        CheckpointWriter writer(file);
        checkpoint.serialise(writer);
        model->serialise(writer);
        writer.commit();
        std::ostringstream bytes;
        bytes << std::ifstream(file, std::ios::binary).rdbuf();
        const std::string whole = bytes.str();
        const auto first = static_cast<char>(kind);
        std::ofstream(file, std::ios::binary)
            << first << whole.substr(head_size, whole.size() - head_size - end_size);
        if (kind > 0) continue;
        constexpr char as_whole_file = '\x80';
        std::ofstream(folder / "whole-file", std::ios::binary) << as_whole_file << whole;
    }
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
    constexpr std::string_view flag = "--make-corpus=";
    for (int n = 1; n < *count; ++n) {
        const std::string_view argument = (*arguments)[n];
        if (!argument.starts_with(flag)) continue;
        make_corpus(argument.substr(flag.size()));
        std::exit(0);
    }
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return -1;
    const std::string_view rest = fuzz::as_text(data, size).substr(1);
    constexpr unsigned as_whole_file = 128;
    read_checkpoint(data[0] < as_whole_file ? whole_file(rest) : std::string(rest),
                    data[0] % as_whole_file);
    return 0;
}
