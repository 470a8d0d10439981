#include "runtime/script/library.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "lua_lib/embedded_lua.h"

namespace gsim::script {

tl::expected<std::string, std::string> Library::read(std::string_view file_name) const {
    if (!folder_) {
        const std::string_view text = embedded::embedded_lua(file_name);
        if (text.data() == nullptr)
            return tl::unexpected("the library has no file " + std::string(file_name));
        return std::string(text);
    }
    const std::filesystem::path path = *folder_ / file_name;
    std::ifstream file(path, std::ios::binary);
    if (!file) return tl::unexpected(path.string() + ": " + std::strerror(errno));
    return std::string(std::istreambuf_iterator<char>(file), {});
}

}  // namespace gsim::script
