#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace gsim::faults {

/// System calls of a program that may fail.
enum class Kind : std::uint8_t {
    allocation,  ///< malloc() and its kin, so operator new, too
    write,
    read,
    open,
    close,
    fsync,
    rename,
    mode,    ///< fchmod()
    lock,    ///< flock()
    copy,    ///< dup()
    memory,  ///< memfd_create()
    size,    ///< ftruncate()
    look,    ///< stat() and its kin, readlink(), access()
    remove,  ///< unlink()
    count
};
inline constexpr std::size_t kKinds = static_cast<std::size_t>(Kind::count);

/// Counts from the first line of main() on. They are in a file that the program and its observer both have
/// mapped, so that they remain however the program ends.
struct Tally {
    std::array<std::atomic<std::uint64_t>, kKinds> calls;
    std::atomic<std::uint64_t> struck;  ///< Number of calls made to fail.
};

/// File of the tally; the library is inactive if the variable is not set.
inline constexpr const char* kTallyVariable = "GSIM_FAULT_TALLY";
/// "KIND WHICH ERROR REPEATED": the number of the kind, which of its calls fails (from 1; 0: none), its errno
/// (kShort: it is done in part; below 0: this signal comes first), 1 if all later ones fail, too.
inline constexpr const char* kFaultVariable = "GSIM_FAULT";
inline constexpr int kShort = 0;

}  // namespace gsim::faults
