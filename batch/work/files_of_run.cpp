#include "batch/work/files_of_run.h"

#include <filesystem>
#include <utility>

namespace gsim::batch {

namespace {

std::string normal(const std::string& name) {
    return std::filesystem::path(name).lexically_normal().string();
}

}  // namespace

void FilesOfRun::replace(const std::string& name, std::string text) {
    replaced_[normal(name)] = std::move(text);
}

bool FilesOfRun::is_replaced(const std::string& name) const {
    return replaced_.contains(normal(name));
}

std::optional<std::string> FilesOfRun::read(const std::string& name) {
    const auto replaced = replaced_.find(normal(name));
    return replaced != replaced_.end() ? std::optional(replaced->second) : read_as_it_is(name);
}

std::optional<std::string> FilesOfRun::read_as_it_is(const std::string& name) {
    const std::string plain = normal(name);
    const auto content = files_.get(plain);
    asked_[plain] = content == nullptr ? std::string() : content->sha256;
    return content == nullptr ? std::nullopt : std::optional(content->bytes);
}

void FilesOfRun::note(const std::string& name) {
    asked_[normal(name)] = files_.hash_of(normal(name));
}

std::vector<ReadFile> FilesOfRun::asked() const {
    std::vector<ReadFile> all;
    for (const auto& [name, hash] : asked_) all.push_back({name, hash});
    return all;
}

engine::Host host_as_it_is(const engine::Host& system, FilesOfRun& files) {
    engine::Host host = system;
    host.files =
        engine::Files::given([&files](const std::string& name) { return files.read_as_it_is(name); });
    host.read_solid = [&files, read = system.read_solid](const std::string& file, double tolerance_mm) {
        files.note(file);
        return read(file, tolerance_mm);
    };
    host.load_module = [&files, load = system.load_module](const std::string& file,
                                                           const machine::Machine& machine) {
        files.note(file);
        return load(file, machine);
    };
    return host;
}

engine::Host host_with(const engine::Host& system, FilesOfRun& files) {
    engine::Host host = host_as_it_is(system, files);
    host.files = engine::Files::given([&files](const std::string& name) { return files.read(name); });
    host.find = [&files, find = system.find](engine::NameKind kind, const std::string& name) {
        return files.is_replaced(name) ? tl::expected<std::string, std::string>(name) : find(kind, name);
    };
    return host;
}

}  // namespace gsim::batch
