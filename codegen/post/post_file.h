#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "codegen/post/post.h"

namespace gsim::codegen {

/// Reads a description of a post-processor (docs/paths.md) strictly. The error is "file:line:column:
/// message".
Result<Post> read_post(std::string_view toml_text, std::string_view file_name);

/// Returns the names of the posts that are compiled in, those of samples/posts.
std::vector<std::string_view> built_in_posts();

/// Returns one of them by its name or, if `name` ends in .toml, that file.
Result<Post> find_post(const std::string& name);

}  // namespace gsim::codegen
