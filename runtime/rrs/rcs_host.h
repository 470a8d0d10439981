#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include <tl/expected.hpp>

#include "runtime/rrs/rcs_module.h"

namespace gsim::rrs {

class RcsModule;

/// A loaded library with a controller module in it (rcs_module.h).
class RcsLibrary {
  public:
    /// Loads the library at `path`, which is tried out in a child process first: loaded, a module created for
    /// `machine`, initialized and destroyed. The error is a sentence that names the library: no such file, no
    /// module, another version, a service missing that each needs, a crash (in the trial; none later is
    /// caught), no answer within `trial_ms`.
    static tl::expected<std::shared_ptr<const RcsLibrary>, std::string> load(const std::string& path,
                                                                             const gsim_rcs_machine& machine,
                                                                             int trial_ms = 10'000);
    RcsLibrary(const RcsLibrary&) = delete;
    RcsLibrary& operator=(const RcsLibrary&) = delete;
    ~RcsLibrary();

    /// The file name without its folder.
    const std::string& name() const { return name_; }

  private:
    friend class RcsModule;

    RcsLibrary() = default;
    static tl::expected<std::shared_ptr<const RcsLibrary>, std::string> open(const std::string& path);
    static std::string try_out(const std::string& path, const gsim_rcs_machine& machine);

    std::string name_;
    void* handle_ = nullptr;
    decltype(&gsim_rcs_create) create_ = nullptr;
    decltype(&gsim_rcs_destroy) destroy_ = nullptr;
    decltype(&gsim_rcs_call) call_ = nullptr;
};

/// One controller of a library.
class RcsModule {
  public:
    /// The error is a sentence that names the library.
    static tl::expected<RcsModule, std::string> create(std::shared_ptr<const RcsLibrary> library,
                                                       const gsim_rcs_machine& machine);

    RcsModule(RcsModule&&) = default;
    RcsModule& operator=(RcsModule&&) = delete;  // would drop a library before its module

    const std::string& name() const { return library_->name(); }
    /// Answers what the module answers, unchecked.
    std::int32_t call(std::int32_t opcode, const void* input, void* output) {
        return library_->call_(handle_.get(), opcode, input, output);
    }

  private:
    using Handle = std::unique_ptr<gsim_rcs_module, decltype(&gsim_rcs_destroy)>;

    RcsModule(std::shared_ptr<const RcsLibrary> library, Handle handle)
        : library_(std::move(library)), handle_(std::move(handle)) {}

    std::shared_ptr<const RcsLibrary> library_;
    Handle handle_;  // goes before its library
};

/// The text in an array of `size` bytes; cut where no zero byte ends it.
std::string rcs_text(const char* text, std::size_t size);

}  // namespace gsim::rrs
