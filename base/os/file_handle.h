#pragma once

#include <cstdio>
#include <memory>

namespace gsim::os {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

/// Closes its file at the end; errors of writing are for its owner to ask before.
using FileHandle = std::unique_ptr<std::FILE, CloseFile>;

}  // namespace gsim::os
