#pragma once

#include <filesystem>
#include <string>

namespace gsim::conformance {

/// A new folder among the system's temporary files, gone with the object. Throws
/// std::filesystem::filesystem_error.
class ScratchFolder {
  public:
    ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    ~ScratchFolder();

    const std::filesystem::path& path() const { return path_; }
    /// Writes a file there; throws std::runtime_error if that fails.
    std::filesystem::path write(const std::string& name, const std::string& text) const;

  private:
    std::filesystem::path path_;
};

}  // namespace gsim::conformance
