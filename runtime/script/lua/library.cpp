#include "runtime/script/lua/library.h"

#include "lua_lib/embedded_lua.h"

namespace gsim::script {

Result<std::string> Library::read(std::string_view file_name) const {
    if (!folder_) {
        const std::string_view text = embedded::embedded_lua(file_name);
        if (text.data() == nullptr)
            return Unexpected("the library does not contain the file " + std::string(file_name));
        return std::string(text);
    }
    return folder_files_->read_text(*folder_ / file_name);
}

}  // namespace gsim::script
