#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace fumon {

/// The part of some work that one of several programs does: number `number` of `of`, from 1.
struct Shard {
    int number = 1;
    int of = 1;
};

/// How many shards there may be.
inline constexpr int most_shards = 10'000;

/// The value of an environment variable; nothing where it is not set.
using Environment = std::function<std::optional<std::string>(const char* name)>;

/// The environment of this program.
Environment own_environment();

/// A program among those that mpirun started.
struct Rank {
    Shard shard;     ///< the rank plus one
    int beside = 1;  ///< how many of them are on this machine
};

/// Which of several programs mpirun or mpiexec has started this one as (OMPI_COMM_WORLD_RANK, _SIZE
/// and _LOCAL_SIZE, or PMI_RANK, PMI_SIZE and MPI_LOCALNRANKS); nothing where it is the only one.
/// Slurm's variables do not tell: a job's own script has them, too.
std::optional<Rank> rank_of_mpirun(const Environment& environment = own_environment());

/// Reads --shard: "3/16"; "slurm", this task of a Slurm array (SLURM_ARRAY_TASK_ID, with _MIN,
/// _MAX, _STEP and _COUNT); or "mpi", this process of those that mpirun or srun started
/// (OMPI_COMM_WORLD_RANK and _SIZE, PMI_RANK and PMI_SIZE, or SLURM_PROCID and SLURM_NTASKS), the
/// rank plus one. Throws InputError for another text, and where the variables are not there or no
/// row of tasks without gaps.
Shard read_shard(const std::string& text, const Environment& environment = own_environment());

/// "3/16".
std::string shard_text(const Shard& shard);

/// Shares work out: for each task, of which shard it is (from 1). The longest task goes first, to
/// the shard with the least so far (Graham 1969, longest processing time first: the longest shard
/// is at most a third longer than it need be); of equals the earlier task and the first shard. The
/// same `lengths` give the same shares, wherever that is asked.
std::vector<int> shares_of(const std::vector<double>& lengths, int shards);

}  // namespace fumon
