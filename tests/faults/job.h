#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/faults/fault.h"

namespace gsim::faults {

/// Sanitizers and line counters allocate and make system calls of their own: no faults are injected into
/// their builds.
#if defined(GSIM_INSTRUMENTED)
inline constexpr bool kInstrumented = true;
#else
inline constexpr bool kInstrumented = false;
#endif

/// Names of files in a folder, relative to it, with their contents.
using Files = std::map<std::string, std::string>;

/// A program to run, and what is in its folder before.
struct Job {
    std::string name;
    std::vector<std::string> command;  ///< The program by its name in the build folder, and its arguments.
    Files files = {};
    std::string input = {};  ///< On standard input.
};

/// Conditions of one run of a job.
struct Conditions {
    Kind kind = Kind::count;
    std::uint64_t which = 0;                    ///< Number of the call; 0: none fails.
    int error = kShort;                         ///< errno, or kShort.
    bool repeated = false;                      ///< All later calls of the kind fail, too.
    std::vector<std::string> environment = {};  ///< "NAME=value", in place of those of the test.
    std::string reason = {};                    ///< Text that the message must contain; empty: any.
};

/// Result of a job.
struct Outcome {
    int status = -1;            ///< Its exit status; -1 if a signal ended it, or it hung.
    std::string ended_by = {};  ///< "signal 11", "a hang"; empty if it ended by itself.
    std::string out = {};
    std::string err = {};
    Files files = {};
    std::vector<std::uint64_t> calls = {};  ///< For each kind.
    std::uint64_t struck = 0;
};

/// Runs the job in a new folder, which is gone afterwards.
Outcome run(const Job& job, const Conditions& conditions);

/// Returns the full path of a program in the build folder.
std::string program_path(const std::string& name);

/// The files of a folder and below.
Files read_files(const std::filesystem::path& folder);
void write_files(const std::filesystem::path& folder, const Files& files);
std::string read_file(const std::filesystem::path& file);

/// A new folder of the test, removed with the object.
class Folder {
  public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

/// End of a program that was started.
struct Ended {
    int status = -1;
    std::string by = {};
};

/// Parameters for starting a program.
struct Start {
    std::vector<std::string> command;           ///< The first is the file of the program.
    std::vector<std::string> environment = {};  ///< As in Conditions.
    std::filesystem::path folder;
    std::filesystem::path in = "/dev/null";
    std::filesystem::path out = "/dev/null";
    std::filesystem::path err = "/dev/null";
};

/// Begins a program; its process.
int start(const Start& start);
/// Waits for it. One that does not end within a minute is killed and counts as hung.
Ended wait_for(int process);

}  // namespace gsim::faults
