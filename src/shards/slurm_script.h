#pragma once

#include <string>
#include <vector>

namespace fumon {

/// What a job script is to do.
struct SlurmJob {
    std::string name;                ///< of the job, "fumon-sweep"
    std::vector<std::string> words;  ///< of the command after "fumon", without --shard and --merge
    int shards = 1;
};

/// A script for sbatch: an array of a task a shard, of which the first submits the merge, to begin
/// when all have ended (afterany: the merge names what is missing).
std::string slurm_script(const SlurmJob& job);

/// A word as a POSIX shell reads it back.
std::string shell_word(const std::string& word);

}  // namespace fumon
