#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include <tl/expected.hpp>

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

    OutputFile(OutputFile&&) noexcept = default;
    OutputFile& operator=(OutputFile&&) = delete;
    ~OutputFile();

    /// For writing, open until commit().
    std::FILE* stream() const { return stream_.get(); }
    /// Closes the file and gives it its name. The error, such as a full disk, is a sentence that names the
    /// file; then the file that stood there before is untouched.
    tl::expected<void, std::string> commit();

  private:
    struct CloseFile {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    OutputFile() = default;
    tl::expected<void, std::string> open_beside();
    tl::expected<void, std::string> open_directly();
    tl::expected<void, std::string> open_standard_output();
    tl::unexpected<std::string> cannot_write(int error) const;

    std::filesystem::path shown_path_;  // as the caller gave it
    std::filesystem::path path_;        // symbolic links followed
    std::filesystem::path temporary_;   // empty when written directly, and after commit()
    std::unique_ptr<std::FILE, CloseFile> stream_;
};

}  // namespace gsim::simulation
