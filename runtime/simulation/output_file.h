#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "runtime/simulation/file_handle.h"

namespace gsim::simulation {

/// The name of standard output, where a file may be it.
inline constexpr const char* kStandardStream = "-";

/// A file that appears under its name only when it is complete: it is written under another name in the same
/// folder, renamed by commit(), and removed without one. What is no regular file (a terminal, a pipe) is
/// written directly, and so is standard output under its name. An existing file keeps its permissions, and a
/// symbolic link stays one.
class OutputFile {
  public:
    /// The error is a sentence that names the file.
    static tl::expected<OutputFile, std::string> open(const std::filesystem::path& path);

    /// Whether open() would go well, as far as that is known before: for what is written at the end of long
    /// work. Nothing is left of it; what is no regular file is not touched. The error is that of open().
    static tl::expected<void, std::string> check(const std::filesystem::path& path);

    OutputFile(OutputFile&&) noexcept = default;
    OutputFile& operator=(OutputFile&&) = delete;
    ~OutputFile();

    /// For writing, open until commit().
    std::FILE* stream() const { return stream_.get(); }
    /// Closes the file and gives it its name. The error, such as a full disk, is a sentence that names the
    /// file; then the file that stood there before is untouched.
    tl::expected<void, std::string> commit();

  private:
    OutputFile() = default;
    tl::expected<void, std::string> open_beside();
    tl::expected<void, std::string> open_directly();
    tl::expected<void, std::string> open_standard_output();
    tl::unexpected<std::string> cannot_write(int error) const;

    std::filesystem::path shown_path_;  // as the caller gave it
    std::filesystem::path path_;        // symbolic links followed
    std::filesystem::path temporary_;   // empty when written directly, and after commit()
    FileHandle stream_;
};

/// Writes a whole file by OutputFile. The error is a sentence.
tl::expected<void, std::string> write_file(const std::filesystem::path& path, std::string_view contents);

}  // namespace gsim::simulation
