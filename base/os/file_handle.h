#pragma once

#include <cstdio>
#include <memory>

namespace gsim::os {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

/// A file that is closed on destruction; its owner must check for write errors before.
using FileHandle = std::unique_ptr<std::FILE, CloseFile>;

}  // namespace gsim::os
