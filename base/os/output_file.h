#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "base/error.h"
#include "base/os/file_handle.h"
#include "base/os/temporary_name.h"

namespace gsim::os {

/// Name of standard output, for parameters that accept it as a file.
inline constexpr const char* kStandardStream = "-";

/// File state that commit() waits for.
enum class Durability {
    system,  ///< The file is complete for all programs; a crash of the machine may lose it.
    disk     ///< And on the disk: for data that are the only copy.
};

/// Treatment of a file that has the name already.
enum class ExistingFilePolicy {
    replace,
    keep  ///< It stays, and commit() fails.
};

/// A file that appears under its name only when it is complete. It is written under another name in the same
/// folder and renamed by commit(). Without commit() it is removed, also if a signal ends the program.
/// Anything but a regular file (a terminal, a pipe) is written directly, and so is standard output under its
/// name. An existing file keeps its permissions, and a symbolic link stays one. All code that writes files
/// uses this class.
class OutputFile {
  public:
    /// Opens the file. The error is a message that names it.
    static Result<OutputFile> open(const std::filesystem::path& path,
                                   ExistingFilePolicy existing = ExistingFilePolicy::replace);

    /// Checks if open() would succeed, as far as that is known before; for content that is written at the end
    /// of long work. Leaves no file, and does not touch anything but a regular file. The error is that of
    /// open().
    static Result<void> check(const std::filesystem::path& path);

    OutputFile(OutputFile&&) noexcept = default;
    OutputFile& operator=(OutputFile&&) = delete;
    ~OutputFile() = default;

    /// Writes a part. The first error is kept for commit(); later text is dropped, and the result is false.
    bool write(std::string_view text);
    /// Returns the stream for code that must write to one. It is open until commit(), which detects an error,
    /// but not its reason.
    std::FILE* stream() const { return stream_.get(); }
    /// Closes the file, so that a full disk is detected, and commit() only gives it its name. If several
    /// files belong together, all of them are settled first.
    Result<void> prepare_commit(Durability reach = Durability::system);
    /// Settles the file and gives it its name. The error, such as a full disk, is a message that names the
    /// file; then the previous file is unchanged.
    Result<void> commit(Durability reach = Durability::system);
    /// Returns the error that it cannot be written, for this value of errno.
    Unexpected write_error(int error) const;

  private:
    OutputFile() = default;
    Result<void> open_temporary();
    Result<void> open_directly();
    Result<void> open_standard_output();
    int close(Durability reach);
    int rename() const;

    std::string display_name_;    // as the caller gave it, in quotes
    std::filesystem::path path_;  // symbolic links followed
    TemporaryName temporary_;     // empty when written directly, and after commit()
    FileHandle stream_;           // null once it is settled
    ExistingFilePolicy existing_policy_ = ExistingFilePolicy::replace;
    int error_ = 0;  // errno of the first failure
};

/// Writes a complete file by OutputFile.
Result<void> write_file(const std::filesystem::path& path, std::string_view contents,
                        Durability reach = Durability::system);

}  // namespace gsim::os
