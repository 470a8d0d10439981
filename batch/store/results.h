#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "batch/store/sqlite.h"
#include "batch/work/job.h"
#include "batch/work/run_row.h"

namespace gsim::batch {

/// What a run is found again by.
struct RunKey {
    std::string key;             ///< Hash of all that is known before it.
    std::string program_sha256;  ///< Empty: the program cannot be read.
    std::string machine_sha256;  ///< Of its file; empty: built in.
};

/// Says what a file is now: its hash, empty where there is none.
using HashOf = std::function<std::string(const std::string& name)>;

/// How SQLite keeps a file whole where a program ends in its middle.
enum class Journal : std::uint8_t {
    write_ahead,  ///< Others read while one writes; all of them on one machine.
    rollback,     ///< For file systems that machines share.
};

/// Gives a file of results of an earlier version what this one has more, before it is read alone. One that
/// cannot be changed, or is none, stays as it is.
void bring_up_to_date(const std::string& file);

/// Runs in a file of SQLite (docs/batch.md tells of its tables). One process at a time writes; any number
/// reads meanwhile.
class Results {
  public:
    /// Opens the file, or makes it. The error is a sentence: it is of another kind, or of a newer version.
    static tl::expected<Results, std::string> open(const std::string& file,
                                                   Journal journal = Journal::write_ahead);
    Results(Results&&) noexcept;
    Results& operator=(Results&&) = delete;
    ~Results();

    /// A batch begins: `jobs` of them by this plan. All runs that are noted from now on belong to it.
    SqlDone begin_batch(const std::string& plan, std::uint64_t jobs, const std::string& version);
    /// A batch that was begun by another process goes on. The error: it is not in this file.
    SqlDone resume_batch(std::int64_t batch, const std::string& token);
    std::int64_t batch() const { return batch_; }
    /// What tells a batch from all others, also in other files.
    const std::string& token() const { return token_; }
    /// It came to its end, or was cut off.
    SqlDone end_batch(bool whole);

    struct FoundRun {
        std::int64_t run = 0;
        bool is_clean = true;
    };
    /// A run by its key that is still true: all files that it has read are as they were, it has what is
    /// wanted where one is wanted, and it did not end by a failure that another try may not have (`retry`).
    tl::expected<std::optional<FoundRun>, std::string> find(const std::string& key, const HashOf& hash_of,
                                                            Kept wanted, bool retry);
    /// A new run; its number.
    tl::expected<std::int64_t, std::string> add(const Job& job, const RunKey& key, const RunRow& row,
                                                const std::string& version);
    /// The run that stands for a job of the batch.
    SqlDone note(std::uint64_t job, std::int64_t run, bool reused);
    /// Takes over what another file has of its jobs: the runs that stand for them there. Those that a job of
    /// this batch has here already are left alone. How many were taken.
    tl::expected<std::uint64_t, std::string> take_over(const std::string& file);
    /// How many jobs of the batch have a run.
    tl::expected<std::uint64_t, std::string> noted();
    /// What was added so far is on the disk, and others see it.
    SqlDone commit();

  private:
    struct Statements;

    Results(Database database, std::unique_ptr<Statements> statements);
    tl::expected<bool, std::string> is_current(std::int64_t run, const HashOf& hash_of);
    SqlDone add_inputs(std::int64_t run, const RunRow& row);

    Database database_;
    std::unique_ptr<Statements> statements_;
    std::int64_t batch_ = 0;
    std::string token_;
};

}  // namespace gsim::batch
