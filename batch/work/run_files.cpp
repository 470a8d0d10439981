#include "batch/work/run_files.h"

#include <filesystem>
#include <utility>

namespace gsim::batch {

namespace {

std::string normalized(const std::string& name) {
    return std::filesystem::path(name).lexically_normal().string();
}

}  // namespace

void RunFiles::replace(const std::string& name, std::string text) {
    replaced_texts_[normalized(name)] = std::move(text);
}

bool RunFiles::is_replaced(const std::string& name) const {
    return replaced_texts_.contains(normalized(name));
}

std::optional<std::string> RunFiles::read(const std::string& name) {
    const auto replaced = replaced_texts_.find(normalized(name));
    return replaced != replaced_texts_.end() ? std::optional(replaced->second) : read_original(name);
}

std::optional<std::string> RunFiles::read_original(const std::string& name) {
    const std::string plain = normalized(name);
    const auto content = files_.get(plain);
    requested_hashes_[plain] = content == nullptr ? std::string() : content->sha256;
    return content == nullptr ? std::nullopt : std::optional(content->bytes);
}

void RunFiles::record(const std::string& name) {
    requested_hashes_[normalized(name)] = files_.file_hash(normalized(name));
}

std::vector<ReadFile> RunFiles::files_read() const {
    std::vector<ReadFile> all;
    for (const auto& [name, hash] : requested_hashes_) all.push_back({name, hash});
    return all;
}

engine::Host host_with_originals(const engine::Host& system, RunFiles& files) {
    engine::Host host = system;
    host.files =
        engine::Files::given([&files](const std::string& name) { return files.read_original(name); });
    host.read_solid = [&files, read = system.read_solid](const std::string& file, double tolerance_mm) {
        files.record(file);
        return read(file, tolerance_mm);
    };
    host.load_module = [&files, load = system.load_module](const std::string& file,
                                                           const machine::Machine& machine) {
        files.record(file);
        return load(file, machine);
    };
    return host;
}

engine::Host host_with_replacements(const engine::Host& system, RunFiles& files) {
    engine::Host host = host_with_originals(system, files);
    host.files = engine::Files::given([&files](const std::string& name) { return files.read(name); });
    host.find = [&files, find = system.find](engine::NameKind kind, const std::string& name) {
        return files.is_replaced(name) ? tl::expected<std::string, std::string>(name) : find(kind, name);
    };
    return host;
}

}  // namespace gsim::batch
