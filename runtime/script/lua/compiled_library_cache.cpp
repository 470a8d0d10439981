#include "runtime/script/lua/compiled_library_cache.h"

#include <utility>

namespace gsim::script {

std::shared_ptr<const std::string> CompiledLibraryCache::find(std::string_view file_name) const {
    const std::lock_guard lock(mutex_);
    const auto found = files_.find(file_name);
    return found == files_.end() ? nullptr : found->second;
}

void CompiledLibraryCache::keep(std::string_view file_name, std::string compiled) {
    const std::lock_guard lock(mutex_);
    files_.try_emplace(std::string(file_name), std::make_shared<const std::string>(std::move(compiled)));
}

}  // namespace gsim::script
