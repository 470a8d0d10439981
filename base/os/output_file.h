#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "base/os/file_handle.h"
#include "base/os/temporary_name.h"

namespace gsim::os {

/// The name of standard output, where a file may be it.
inline constexpr const char* kStandardStream = "-";

/// What commit() waits for.
enum class Reach {
    system,  ///< The file is whole for all programs; a crash of the machine may lose it.
    disk     ///< And on the disk: for data that are the only copy.
};

/// What becomes of a file that has the name already.
enum class Existing {
    replace,
    keep  ///< It stays, and commit() fails.
};

/// A file that appears under its name only when it is complete: it is written under another name in the same
/// folder, renamed by commit(), and removed without one, also where a signal ends the program. What is no
/// regular file (a terminal, a pipe) is written directly, and so is standard output under its name. An
/// existing file keeps its permissions, and a symbolic link stays one. All places that write files do so by
/// this.
class OutputFile {
  public:
    /// The error is a sentence that names the file.
    static tl::expected<OutputFile, std::string> open(const std::filesystem::path& path,
                                                      Existing existing = Existing::replace);

    /// Whether open() would go well, as far as that is known before: for what is written at the end of long
    /// work. Nothing is left of it; what is no regular file is not touched. The error is that of open().
    static tl::expected<void, std::string> check(const std::filesystem::path& path);

    OutputFile(OutputFile&&) noexcept = default;
    OutputFile& operator=(OutputFile&&) = delete;
    ~OutputFile() = default;

    /// Writes a piece. The first failure is kept for commit(), and what comes after it is dropped: false.
    bool write(std::string_view text);
    /// For who must write to a stream, open until commit(), which knows of a failure, but not its reason.
    std::FILE* stream() const { return stream_.get(); }
    /// Closes the file, so that a full disk shows, and commit() only gives it its name. Where several files
    /// belong together all of them are settled first.
    tl::expected<void, std::string> settle(Reach reach = Reach::system);
    /// Settles the file and gives it its name. The error, such as a full disk, is a sentence that names the
    /// file; then the file that stood there before is untouched.
    tl::expected<void, std::string> commit(Reach reach = Reach::system);
    /// That it cannot be written, for this value of errno.
    tl::unexpected<std::string> cannot_write(int error) const;

  private:
    OutputFile() = default;
    tl::expected<void, std::string> open_beside();
    tl::expected<void, std::string> open_directly();
    tl::expected<void, std::string> open_standard_output();
    int close(Reach reach);
    int rename() const;

    std::string shown_name_;      // as the caller gave it, in quotes
    std::filesystem::path path_;  // symbolic links followed
    TemporaryName temporary_;     // empty when written directly, and after commit()
    FileHandle stream_;           // none once it is settled
    Existing existing_ = Existing::replace;
    int error_ = 0;  // errno of the first failure
};

/// Writes a whole file by OutputFile. The error is a sentence.
tl::expected<void, std::string> write_file(const std::filesystem::path& path, std::string_view contents,
                                           Reach reach = Reach::system);

}  // namespace gsim::os
