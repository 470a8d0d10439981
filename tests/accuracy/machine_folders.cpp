#include "tests/accuracy/machine_folders.h"

namespace gsim::accuracy {

namespace fs = std::filesystem;

fs::path machine_file_in(std::span<const std::string> folders, const std::string& file_name) {
    fs::path path;
    for (const std::string& folder : folders) {
        path = fs::path(folder) / file_name;
        if (fs::exists(path)) break;
    }
    return path;
}

}  // namespace gsim::accuracy
