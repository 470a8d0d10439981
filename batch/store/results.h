#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "base/error.h"
#include "batch/store/sqlite.h"
#include "batch/work/job.h"
#include "batch/work/run_row.h"

namespace gsim::batch {

/// Key by which a run is found again.
struct RunKey {
    std::string key;             ///< Hash of all that is known before it.
    std::string program_sha256;  ///< Empty: the program cannot be read.
    std::string machine_sha256;  ///< Hash of its file; empty: built in.
};

/// Function that returns the current hash of a file, empty if the file does not exist.
using FileHash = std::function<std::string(const std::string& name)>;

/// Method by which SQLite keeps a file consistent if a program is interrupted.
enum class Journal : std::uint8_t {
    write_ahead,  ///< Others read while one writes; all of them on one machine.
    rollback,     ///< For file systems that machines share.
};

/// Adds the columns and tables of this version to a file of results of an earlier one, before it is opened
/// read-only. A file that cannot be changed, or is no file of results, stays unchanged.
void upgrade_schema(const std::string& file);

/// Runs in an SQLite file (docs/batch.md describes its tables). One process at a time writes; any number may
/// read meanwhile.
class Results {
  public:
    /// Opens the file, or creates it. The error is a message: it is of another kind, or of a newer version.
    static Result<Results> open(const std::string& file, Journal journal = Journal::write_ahead);
    Results(Results&&) noexcept;
    Results& operator=(Results&&) = delete;
    ~Results();

    /// Begins a batch: `jobs` of them by this plan. All runs that are recorded from now on belong to it.
    Result<void> begin_batch(const std::string& plan, std::uint64_t jobs, const std::string& version);
    /// Continues a batch that another process began. The error: it is not in this file.
    Result<void> resume_batch(std::int64_t batch, const std::string& token);
    std::int64_t batch() const { return batch_; }
    /// Returns the token that distinguishes a batch from all others, also in other files.
    const std::string& token() const { return token_; }
    /// Ends the batch, as complete or as cut off.
    Result<void> end_batch(bool complete);

    struct StoredRun {
        std::int64_t run = 0;
        bool is_clean = true;
    };
    /// Finds a run by its key that is still valid. All files that it has read are unchanged, and it has the
    /// requested documents. It did not end by an error that another attempt may avoid (`retry`).
    Result<std::optional<StoredRun>> find(const std::string& key, const FileHash& file_hash,
                                          StoredDocuments requested, bool retry);
    /// Adds a new run; returns its number.
    Result<std::int64_t> add(const Job& job, const RunKey& key, const RunRow& row,
                             const std::string& version);
    /// Records the run for a job of the batch.
    Result<void> record(std::uint64_t job, std::int64_t run, bool reused);
    /// Copies the runs that another file has for its jobs. Jobs of this batch that already have a run are
    /// skipped. Returns the number of copied runs.
    Result<std::uint64_t> merge(const std::string& file);
    /// Returns the number of jobs of the batch that have a run.
    Result<std::uint64_t> recorded();
    /// Commits the additions so far to the disk, so that others see them.
    Result<void> commit();

  private:
    struct Statements;

    Results(Database database, std::unique_ptr<Statements> statements);
    Result<bool> is_current(std::int64_t run, const FileHash& file_hash);
    Result<void> add_inputs(std::int64_t run, const RunRow& row);

    Database database_;
    std::unique_ptr<Statements> statements_;
    std::int64_t batch_ = 0;
    std::string token_;
};

}  // namespace gsim::batch
