// libFuzzer's program for all targets: the name that it is called by says which one is meant. Under another
// name it lists them, with the family of each.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/os/confinement.h"
#include "tests/build_files/build_files.h"
#include "tests/fuzz/target.h"

namespace {

namespace fs = std::filesystem;
using gsim::fuzz::Target;

/// It is set once, before the first input, because libFuzzer's functions take no argument that could carry
/// it.
const Target*& chosen_target() {
    static const Target* target = nullptr;
    return target;
}

[[noreturn]] void list_targets() {
    for (const Target& target : gsim::fuzz::targets()) fmt::print("{} {}\n", target.name, target.family);
    std::exit(0);
}

/// Returns the value of an argument that is one of these options, or none if it is none of them.
std::optional<std::string_view> option_value(std::string_view argument,
                                             std::initializer_list<std::string_view> options) {
    for (const std::string_view option : options) {
        if (argument.starts_with(option)) return argument.substr(option.size());
    }
    return std::nullopt;
}

/// Returns the access to what the arguments name: folders of inputs and single ones, of which the first may
/// be added to, the dictionary, and the folder for findings. An input cannot open other files, except those
/// in tests/fuzz/beside.
gsim::os::SandboxPolicy fuzz_sandbox_policy(int argc, char** argv) {
    gsim::os::SandboxPolicy policy;
    policy.read.emplace_back(gsim::tests::source_path("tests/fuzz/beside"));
    for (const char* path : {"/proc/self", "/dev/null"}) policy.read.emplace_back(path);
    // The symbolizer of the sanitizers, and what it reads.
    policy.run.emplace_back(gsim::tests::build_path("lib/fuzz_modules"));
    for (const char* folder : {"/usr", "/lib", "/lib64"}) policy.run.emplace_back(folder);
    std::error_code ignored;
    policy.read.push_back(fs::read_symlink("/proc/self/exe", ignored));
    bool is_first = true;
    for (int i = 1; i < argc; ++i) {
        const std::string_view argument = argv[i];
        if (const auto dictionary = option_value(argument, {"-dict="})) {
            policy.read.emplace_back(*dictionary);
        } else if (const auto output =
                       option_value(argument, {"-artifact_prefix=", "-exact_artifact_path="})) {
            policy.changed.push_back(fs::absolute(*output).parent_path());
        } else if (!argument.starts_with('-')) {
            (std::exchange(is_first, false) ? policy.changed : policy.read).emplace_back(argument);
        }
    }
    return policy;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
    chosen_target() = gsim::fuzz::find_target(fs::path((*argv)[0]).filename().string());
    if (chosen_target() == nullptr) list_targets();
    if (!chosen_target()->confined) return 0;
    if (const auto confined = gsim::os::confine(fuzz_sandbox_policy(*argc, *argv)); !confined) {
        fmt::print(stderr, "{}\n", confined.error().message);
        std::exit(1);
    }
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view input(reinterpret_cast<const char*>(data), size);
    if (const auto broken = chosen_target()->check(input).broken) {
        fmt::print(stderr, "{}: {}\n", chosen_target()->name, *broken);
        std::abort();
    }
    return 0;
}
