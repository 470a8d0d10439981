#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "base/error.h"
#include "controller/module/rcs_calls.h"
#include "controller/module/rcs_module.h"

namespace gsim::rrs {

/// A loaded library with a controller module in it (rcs_module.h).
class RcsLibrary {
  public:
    /// Loads the library at `path`, which is first tried in a child process: loaded, a module created for
    /// `machine`, initialized and destroyed. The error is a message that names the library: no such file, no
    /// module, another version, a missing required service, no response within `trial_ms`, or a crash (in the
    /// trial; later ones are not caught).
    static Result<std::shared_ptr<const RcsLibrary>> load(const std::string& path,
                                                          const gsim_rcs_machine& machine,
                                                          int trial_ms = 10'000);
    /// Works as load(), but tries it in this process, in which a crash is a crash of the process.
    static Result<std::shared_ptr<const RcsLibrary>> load_in_process(const std::string& path,
                                                                     const gsim_rcs_machine& machine);
    RcsLibrary(const RcsLibrary&) = delete;
    RcsLibrary& operator=(const RcsLibrary&) = delete;
    ~RcsLibrary();

    /// Returns the file name without its folder.
    const std::string& name() const { return name_; }

  private:
    friend class LoadedModule;

    RcsLibrary() = default;
    static Result<std::shared_ptr<const RcsLibrary>> open(const std::string& path);
    static std::optional<Error> find_library_error(const std::shared_ptr<const RcsLibrary>& library,
                                                   const gsim_rcs_machine& machine);

    std::string name_;
    void* handle_ = nullptr;
    decltype(&gsim_rcs_create) create_ = nullptr;
    decltype(&gsim_rcs_destroy) destroy_ = nullptr;
    decltype(&gsim_rcs_call) call_ = nullptr;
};

/// One controller of a library, in this process or in a separate one (rcs_process.h).
class RcsModule {
  public:
    explicit RcsModule(std::unique_ptr<RcsCalls> calls) : calls_(std::move(calls)) {}
    /// Creates a controller in this process. The error is a message that names the library.
    static Result<RcsModule> create(std::shared_ptr<const RcsLibrary> library,
                                    const gsim_rcs_machine& machine);

    /// Returns the name, as in RcsCalls.
    const std::string& name() const { return calls_->name(); }
    std::int32_t call(std::int32_t opcode, const void* input, void* output) {
        return calls_->call(opcode, input, output);
    }
    void announce(RcsPrefetch prefetch, bool queries_targets) { calls_->announce(prefetch, queries_targets); }
    std::optional<std::string> loss() const { return calls_->loss(); }
    double cpu_s() const { return calls_->cpu_s(); }

  private:
    std::unique_ptr<RcsCalls> calls_;
};

/// Returns the text in an array of `size` bytes; truncated if it has no final zero byte.
std::string rcs_text(const char* text, std::size_t size);

}  // namespace gsim::rrs
