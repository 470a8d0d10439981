#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace gsim::faults {

/// What a program asks of the system, where it may be refused.
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

/// What is counted from the first line of main() on. It lies in a file that the program and who looks at it
/// both have mapped, so that it is there however the program ends.
struct Tally {
    std::array<std::atomic<std::uint64_t>, kKinds> calls;
    std::atomic<std::uint64_t> struck;  ///< How many calls were made to fail.
};

/// The file of the tally; the library does nothing where the variable is not set.
inline constexpr const char* kTallyVariable = "GSIM_FAULT_TALLY";
/// "KIND WHICH ERROR REPEATED": the number of the kind, which of its calls fails (from 1; 0: none), its errno
/// (kShort: it is done in part; below 0: this signal comes first), whether (1) all later ones fail, too.
inline constexpr const char* kFaultVariable = "GSIM_FAULT";
inline constexpr int kShort = 0;

}  // namespace gsim::faults
