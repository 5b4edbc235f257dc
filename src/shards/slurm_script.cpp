#include "shards/slurm_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace fumon {

std::string shell_word(const std::string& word) {
    const auto plain = [](unsigned char letter) {
        return std::isalnum(letter) != 0 ||
               std::string_view("_-./:=,+@%").find(static_cast<char>(letter)) !=
                   std::string_view::npos;
    };
    if (!word.empty() && std::ranges::all_of(word, plain)) return word;
    std::string quoted = "'";
    for (const char letter : word)
        quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    return quoted + "'";
}

std::string slurm_script(const SlurmJob& job) {
    std::string words;
    for (const std::string& word : job.words) words += " " + shell_word(word);
    return fmt::format(
        R"(#!/bin/bash
# Written by fumon {version}. Submit it with `sbatch FILE`, from the folder that the paths below are relative to.
# One shard again: `sbatch --array=3 FILE`. What was finished before is kept.
#SBATCH --job-name={name}
#SBATCH --array=1-{shards}
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=4
#SBATCH --output={name}-%A_%a.log
# What your cluster asks for besides, such as --time, --mem, --partition and --account, goes here.
set -eu
fumon=${{FUMON:-fumon}}
command=({words} )

# The first task submits the merge, which begins when all shards have ended.
if [ "$SLURM_ARRAY_TASK_ID" = "$SLURM_ARRAY_TASK_MIN" ]; then
    merge=$(printf ' %q' "$fumon" "${{command[@]}}" --merge)
    sbatch --job-name={name}-merge --ntasks=1 --output={name}-merge-%j.log \
        --dependency=afterany:"$SLURM_ARRAY_JOB_ID" --wrap="$merge" ||
        echo "the merge could not be submitted; when all shards are done, run:$merge" >&2
fi

exec "$fumon" "${{command[@]}}" --shard "$SLURM_ARRAY_TASK_ID/{shards}" --threads "${{SLURM_CPUS_PER_TASK:-1}}"
)",
        fmt::arg("version", FUMON_VERSION), fmt::arg("name", job.name),
        fmt::arg("shards", job.shards), fmt::arg("words", words));
}

}  // namespace fumon
