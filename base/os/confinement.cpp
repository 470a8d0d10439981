#include "base/os/confinement.h"

#include <cerrno>
#include <cstdint>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "base/os/descriptor.h"

// The interface as of landlock(7), with the rights of its later versions, independent of the installed
// headers. The kernel is queried for the rights that it has.
namespace gsim::os {

namespace {

constexpr std::uint64_t kExecute = 1U << 0U;
constexpr std::uint64_t kWriteFile = 1U << 1U;
constexpr std::uint64_t kReadFile = 1U << 2U;
constexpr std::uint64_t kReadFolder = 1U << 3U;
constexpr std::uint64_t kRemoveFile = 1U << 5U;
constexpr std::uint64_t kMakeFile = 1U << 8U;
constexpr std::uint64_t kVersion1Rights = (1U << 13U) - 1;
constexpr std::uint64_t kRefer = 1U << 13U;     // since version 2
constexpr std::uint64_t kTruncate = 1U << 14U;  // since version 3
constexpr std::uint64_t kIoctl = 1U << 15U;     // since version 5
constexpr std::uint64_t kNetworkRights = 3;     // since version 4
constexpr std::uint64_t kAllScopes = 3;         // since version 6
constexpr std::uint64_t kFileRights = kExecute | kWriteFile | kReadFile | kTruncate | kIoctl;
constexpr unsigned kQueryVersion = 1;
constexpr int kRulePathBeneath = 1;

struct RulesetAttributes {
    std::uint64_t files;
    std::uint64_t network;
    std::uint64_t scopes;
};

struct [[gnu::packed]] PathRule {
    std::uint64_t allowed;
    std::int32_t parent;
};

long landlock_version() {
    return ::syscall(SYS_landlock_create_ruleset, nullptr, std::size_t{0}, kQueryVersion);
}

RulesetAttributes all_rights(long version) {
    RulesetAttributes all{kVersion1Rights, 0, 0};
    if (version >= 2) all.files |= kRefer;
    if (version >= 3) all.files |= kTruncate;
    if (version >= 4) all.network = kNetworkRights;
    if (version >= 5) all.files |= kIoctl;
    if (version >= 6) all.scopes = kAllScopes;
    return all;
}

std::size_t attributes_size(long version) {
    if (version >= 6) return sizeof(RulesetAttributes);
    return version >= 4 ? 2 * sizeof(std::uint64_t) : sizeof(std::uint64_t);
}

Unexpected confinement_error(const std::string& what) {
    return Unexpected(
        fmt::format("cannot {} to confine the run: {}", what, std::generic_category().message(errno)));
}

/// The rules of one confinement.
class Ruleset {
  public:
    Ruleset(int descriptor, std::uint64_t handled) : descriptor_(descriptor), handled_rights_(handled) {}

    int number() const { return descriptor_.number(); }

    Result<void> allow(const std::vector<std::filesystem::path>& paths, std::uint64_t rights) {
        for (const std::filesystem::path& path : paths) {
            if (auto allowed = allow(path, rights); !allowed) return allowed;
        }
        return {};
    }

  private:
    Result<void> allow(const std::filesystem::path& path, std::uint64_t rights) {
        const Descriptor opened(::open(path.c_str(), O_PATH | O_CLOEXEC));
        struct stat found {};
        if (opened.number() < 0 || ::fstat(opened.number(), &found) != 0) return {};
        std::uint64_t allowed = rights & handled_rights_;
        if (!S_ISDIR(found.st_mode)) allowed &= kFileRights;
        const PathRule rule{allowed, opened.number()};
        // Objects outside any file system (pipes by their name in /proc) take no rule, and need none.
        if (::syscall(SYS_landlock_add_rule, number(), kRulePathBeneath, &rule, 0U) != 0 && errno != EBADFD)
            return confinement_error(fmt::format("allow '{}'", path.string()));
        return {};
    }

    Descriptor descriptor_;
    std::uint64_t handled_rights_;
};

}  // namespace

Result<bool> confine(const SandboxPolicy& policy) {
    const long version = landlock_version();
    if (version < 1) return false;
    const RulesetAttributes all = all_rights(version);
    Ruleset rules(
        static_cast<int>(::syscall(SYS_landlock_create_ruleset, &all, attributes_size(version), 0U)),
        all.files);
    if (rules.number() < 0) return confinement_error("create rules");
    constexpr std::uint64_t kReadRights = kReadFile | kReadFolder;
    constexpr std::uint64_t kWriteRights = kWriteFile | kTruncate;
    for (const auto& [paths, rights] :
         {std::pair{&policy.read, kReadRights},
          {&policy.run, kReadRights | kExecute},
          {&policy.written, kWriteRights},
          {&policy.changed, kReadRights | kWriteRights | kMakeFile | kRemoveFile}}) {
        if (auto result = rules.allow(*paths, rights); !result) return tl::unexpected(result.error());
    }
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return confinement_error("drop privileges");
    if (::syscall(SYS_landlock_restrict_self, rules.number(), 0U) != 0)
        return confinement_error("apply rules");
    return true;
}

}  // namespace gsim::os
