#include "runtime/machine/text_file.h"

namespace gsim::machine {

namespace {

constexpr std::size_t kMaxBytes = std::size_t{4} << 20U;

}  // namespace

tl::expected<std::string, std::string> read_text_file(const std::filesystem::path& path,
                                                      os::NamedBy named_by) {
    return os::read_input(path, named_by, kMaxBytes);
}

}  // namespace gsim::machine
