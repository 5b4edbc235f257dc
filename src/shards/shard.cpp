#include "shards/shard.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <numeric>
#include <queue>
#include <string_view>

#include "base/error.h"

namespace fumon {

namespace {

std::optional<int> whole(std::string_view text) {
    int value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::optional<int> whole(const Environment& environment, const char* name) {
    const std::optional<std::string> text = environment(name);
    return text ? whole(*text) : std::nullopt;
}

Shard checked(const Shard& shard, const std::string& place) {
    if (shard.of < 1 || shard.of > most_shards || shard.number < 1 || shard.number > shard.of) {
        throw InputError(
            fmt::format("{} is shard {} of {}; it takes N/OF with N from 1 to OF and at "
                        "most {} shards, as 3/16",
                        place, shard.number, shard.of, most_shards));
    }
    return shard;
}

Shard slurm_shard(const Environment& environment) {
    const std::optional<int> task = whole(environment, "SLURM_ARRAY_TASK_ID");
    const std::optional<int> count = whole(environment, "SLURM_ARRAY_TASK_COUNT");
    if (!task || !count) {
        throw InputError(
            "--shard slurm: SLURM_ARRAY_TASK_ID and SLURM_ARRAY_TASK_COUNT are not set; submit the "
            "job with sbatch --array=1-16, or name the shard, as --shard 3/16");
    }
    const int step = std::max(1, whole(environment, "SLURM_ARRAY_TASK_STEP").value_or(1));
    const int first = whole(environment, "SLURM_ARRAY_TASK_MIN").value_or(1);
    const int last =
        whole(environment, "SLURM_ARRAY_TASK_MAX").value_or(first + (*count - 1) * step);
    if ((last - first) / step + 1 != *count || (*task - first) % step != 0) {
        throw InputError(
            fmt::format("--shard slurm: the array's {} tasks from {} to {} have gaps, so the "
                        "number of shards is unknown; name the shard, as --shard {}/16",
                        *count, first, last, *task));
    }
    return checked({(*task - first) / step + 1, *count}, "--shard slurm");
}

struct RankNames {
    const char* rank;
    const char* size;
    const char* beside;  ///< processes on the same machine
};

constexpr std::array<RankNames, 2> mpirun_names{
    {{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_LOCAL_SIZE"},
     {"PMI_RANK", "PMI_SIZE", "MPI_LOCALNRANKS"}}};
constexpr RankNames srun_names{"SLURM_PROCID", "SLURM_NTASKS", nullptr};

std::optional<Shard> shard_of_rank(const RankNames& names, const Environment& environment) {
    const std::optional<int> rank = whole(environment, names.rank);
    const std::optional<int> size = whole(environment, names.size);
    if (!rank || !size) return std::nullopt;
    return checked({*rank + 1, *size}, "--shard mpi");
}

Shard mpi_shard(const Environment& environment) {
    for (const RankNames& names : {mpirun_names[0], mpirun_names[1], srun_names}) {
        if (const auto shard = shard_of_rank(names, environment)) return *shard;
    }
    throw InputError(
        "--shard mpi: neither OMPI_COMM_WORLD_RANK, PMI_RANK nor SLURM_PROCID is set; start fumon "
        "with mpirun or srun, or name the shard, as --shard 3/16");
}

}  // namespace

Environment own_environment() {
    return [](const char* name) -> std::optional<std::string> {
        const char* const value = std::getenv(name);
        if (value == nullptr) return std::nullopt;
        return value;
    };
}

std::optional<Rank> rank_of_mpirun(const Environment& environment) {
    for (const RankNames& names : mpirun_names) {
        const auto shard = shard_of_rank(names, environment);
        if (!shard) continue;
        if (shard->of == 1) return std::nullopt;
        return Rank{*shard, std::max(1, whole(environment, names.beside).value_or(1))};
    }
    return std::nullopt;
}

Shard read_shard(const std::string& text, const Environment& environment) {
    if (text == "slurm") return slurm_shard(environment);
    if (text == "mpi") return mpi_shard(environment);
    const std::size_t slash = text.find('/');
    if (slash != std::string::npos) {
        const std::optional<int> number = whole(std::string_view(text).substr(0, slash));
        const std::optional<int> of = whole(std::string_view(text).substr(slash + 1));
        if (number && of) return checked({*number, *of}, "--shard " + text);
    }
    throw InputError(
        fmt::format("--shard: it takes N/OF, as 3/16, or slurm, mpi or none, not \"{}\"", text));
}

std::string shard_text(const Shard& shard) {
    return fmt::format("{}/{}", shard.number, shard.of);
}

std::vector<int> shares_of(const std::vector<double>& lengths, int shards) {
    std::vector<std::size_t> order(lengths.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order,
                             [&](std::size_t a, std::size_t b) { return lengths[a] > lengths[b]; });
    using Load = std::pair<double, int>;  // the least first, of equals the first shard
    std::priority_queue<Load, std::vector<Load>, std::greater<>> loads;
    for (int shard = 1; shard <= shards; ++shard) loads.emplace(0.0, shard);
    std::vector<int> shares(lengths.size());
    for (const std::size_t task : order) {
        auto [load, shard] = loads.top();
        loads.pop();
        shares[task] = shard;
        loads.emplace(load + lengths[task], shard);
    }
    return shares;
}

}  // namespace fumon
