#include "controller/module/rcs_host.h"

#include <cstring>
#include <filesystem>
#include <utility>

#include <dlfcn.h>
#include <fmt/format.h>

#include "controller/module/rcs_trial.h"

namespace gsim::rrs {

namespace {

template <typename Function>
bool find(void* handle, const char* symbol, Function& function) {
    function = reinterpret_cast<Function>(::dlsym(handle, symbol));
    return function != nullptr;
}

std::string load_error() {
    const char* const error = ::dlerror();
    return error != nullptr ? error : "no reason is given";
}

}  // namespace

std::string rcs_text(const char* text, std::size_t size) {
    return {text, ::strnlen(text, size)};
}

RcsLibrary::~RcsLibrary() {
    if (handle_ != nullptr) ::dlclose(handle_);
}

Result<std::shared_ptr<const RcsLibrary>> RcsLibrary::open(const std::string& path) {
    const std::shared_ptr<RcsLibrary> library(new RcsLibrary);
    library->name_ = std::filesystem::path(path).filename().string();
    const std::string& name = library->name_;
    // The path is absolute, because the loader searches a bare name in the system's folders.
    library->handle_ = ::dlopen(std::filesystem::absolute(path).c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library->handle_ == nullptr)
        return Unexpected(fmt::format("cannot load the controller module {}: {}", name, load_error()));
    decltype(&gsim_rcs_version) version = nullptr;
    const std::pair<const char*, bool> symbols[] = {
        {"gsim_rcs_version", find(library->handle_, "gsim_rcs_version", version)},
        {"gsim_rcs_create", find(library->handle_, "gsim_rcs_create", library->create_)},
        {"gsim_rcs_destroy", find(library->handle_, "gsim_rcs_destroy", library->destroy_)},
        {"gsim_rcs_call", find(library->handle_, "gsim_rcs_call", library->call_)},
    };
    for (const auto& [symbol, found] : symbols) {
        if (!found)
            return Unexpected(fmt::format("{} is not a controller module: it has no {}", name, symbol));
    }
    if (const std::int32_t number = version(); number != GSIM_RCS_VERSION) {
        return Unexpected(fmt::format(
            "{} is a controller module of version {} of the interface; this program supports version {}",
            name, number, GSIM_RCS_VERSION));
    }
    return library;
}

/// Returns an error if the module cannot be used.
std::optional<Error> RcsLibrary::find_library_error(const std::shared_ptr<const RcsLibrary>& library,
                                                    const gsim_rcs_machine& machine) {
    auto module = RcsModule::create(library, machine);
    if (!module) return module.error();
    gsim_rcs_message message{};
    const std::int32_t initialized = module->call(GSIM_RCS_INITIALIZE, nullptr, nullptr);
    const std::int32_t result = module->call(GSIM_RCS_GET_MESSAGE, nullptr, &message);
    const std::pair<const char*, std::int32_t> statuses[] = {{"Initialize", initialized},
                                                             {"GetMessage", result}};
    for (const auto& [service, status] : statuses) {
        if (status == GSIM_RCS_SUCCESS) continue;
        if (status == GSIM_RCS_NOT_SUPPORTED)
            return fmt::format("{} does not support the service {}", module->name(), service);
        const std::string reason = rcs_text(message.text, sizeof message.text);
        return fmt::format("{} responded to {} with {}{}{}", module->name(), service, status,
                           reason.empty() ? "" : ": ", reason);
    }
    return {};
}

Result<std::shared_ptr<const RcsLibrary>> RcsLibrary::load(const std::string& path,
                                                           const gsim_rcs_machine& machine, int trial_ms) {
    const std::string name = std::filesystem::path(path).filename().string();
    const auto trial_result = run_trial(
        [&] {
            const auto library = load_in_process(path, machine);
            return library ? std::string() : library.error().message;
        },
        trial_ms);
    if (!trial_result)
        return Unexpected(fmt::format("the controller module {} {} while it was loaded", name,
                                      trial_result.error().message));
    if (!trial_result->empty()) return tl::unexpected(*trial_result);
    return open(path);
}

Result<std::shared_ptr<const RcsLibrary>> RcsLibrary::load_in_process(const std::string& path,
                                                                      const gsim_rcs_machine& machine) {
    auto library = open(path);
    if (!library) return library;
    if (auto error = find_library_error(*library, machine)) return tl::unexpected(*std::move(error));
    return library;
}

/// A controller in this process.
class LoadedModule final : public RcsCalls {
  public:
    using Handle = std::unique_ptr<gsim_rcs_module, decltype(&gsim_rcs_destroy)>;

    static Handle create(const RcsLibrary& library, const gsim_rcs_machine& machine,
                         gsim_rcs_message& message) {
        return {library.create_(&machine, &message), library.destroy_};
    }
    LoadedModule(std::shared_ptr<const RcsLibrary> library, Handle handle)
        : library_(std::move(library)), handle_(std::move(handle)) {}

    const std::string& name() const override { return library_->name(); }
    std::int32_t call(std::int32_t opcode, const void* input, void* output) override {
        return library_->call_(handle_.get(), opcode, input, output);
    }

  private:
    std::shared_ptr<const RcsLibrary> library_;
    Handle handle_;  // destroyed before its library
};

Result<RcsModule> RcsModule::create(std::shared_ptr<const RcsLibrary> library,
                                    const gsim_rcs_machine& machine) {
    gsim_rcs_message message{};
    LoadedModule::Handle handle = LoadedModule::create(*library, machine, message);
    if (handle) return RcsModule(std::make_unique<LoadedModule>(std::move(library), std::move(handle)));
    const std::string reason = rcs_text(message.text, sizeof message.text);
    return Unexpected(fmt::format("{} created no controller for this machine: {}", library->name(),
                                  reason.empty() ? "no reason is given" : reason));
}

}  // namespace gsim::rrs
