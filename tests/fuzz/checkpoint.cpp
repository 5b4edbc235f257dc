// Checkpoints: the input's first byte chooses a model, the rest are the file's entries, which get
// the head, length and checksum that belong to them; and the rest is read as a whole file, too.

#include "files/checkpoint.h"

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
        checkpoint.carry(reader);
        const auto model = fuzz::small_model(kind);
        model->carry(reader);
        reader.finish();
        if (model->steps_done() < 0 || model->snapshot().bed.size() == 0)
            fuzz::broken_promise("a restored model can be shown", "");
    });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return -1;
    const std::string_view rest = fuzz::as_text(data, size).substr(1);
    read_checkpoint(whole_file(rest), data[0]);
    read_checkpoint(std::string(rest), data[0]);
    return 0;
}
