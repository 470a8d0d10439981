#include "apps/run_files.h"

#include <set>
#include <utility>

#include <fmt/format.h>

#include "apps/machine_data_file.h"
#include "apps/to_error.h"
#include "base/os/file_identity.h"
#include "base/os/output_file.h"

namespace gsim::apps {

namespace {

struct WrittenFile {
    std::string option;
    std::string name;
};

/// Returns the files that the run of one robot writes, without those that several robots write together.
std::vector<WrittenFile> written_files(const RunArguments& arguments, const OutputNames& outputs) {
    std::vector<WrittenFile> written;
    const auto add = [&](const char* option, const std::string& name) {
        if (!name.empty()) written.push_back({option, name});
    };
    for (const OutputNames::File& file : OutputNames::files()) add(file.option, outputs.*file.name);
    if (arguments.request.robots.empty()) {
        add("--sarif", arguments.findings.sarif);
        add("--variables", arguments.request.variables);
    }
    return written;
}

std::optional<Error> conflict(const std::vector<WrittenFile>& written, const engine::Run::NamedFile& file) {
    const auto identity = os::file_identity(file.name);
    if (!identity) return std::nullopt;
    for (const WrittenFile& output : written) {
        if (output.name.empty() || os::file_identity(output.name) != identity) continue;
        if (file.robot.empty()) {
            return fmt::format("{} '{}' is {}, which would be overwritten; give it another name",
                               output.option, output.name, file.what);
        }
        return fmt::format("'{}' of the robot {} is also {}; give one of them another name", output.name,
                           file.robot, file.what);
    }
    return std::nullopt;
}

/// Returns all files that a robot must not overwrite.
std::vector<engine::Run::NamedFile> protected_files(const RunArguments& arguments, const engine::Run& run,
                                                    const std::string& robot) {
    std::vector<engine::Run::NamedFile> others = {
        {arguments.outputs.report, "the report", robot},
        {arguments.outputs.view, "the page", robot},
        {arguments.findings.sarif, "the file of --sarif", robot},
        {arguments.request.program, "the program", robot},
        {arguments.request.robots, "the robots file", robot},
        {arguments.request.setup, "the setup", robot},
    };
    for (engine::Run::NamedFile& file : run.named_files()) {
        if (file.robot == robot) others.push_back(std::move(file));
    }
    return others;
}

}  // namespace

std::optional<Error> output_conflict(const RunArguments& arguments, const engine::Run& run) {
    if (arguments.request.robots.empty()) {
        const auto written = written_files(arguments, arguments.outputs);
        for (const auto& file : run.named_files()) {
            if (auto message = conflict(written, file)) return message;
        }
        return std::nullopt;
    }
    const std::vector<WrittenFile> common{{"--report", arguments.outputs.report},
                                          {"--view", arguments.outputs.view},
                                          {"--sarif", arguments.findings.sarif}};
    for (const auto& file : run.named_files()) {
        if (auto message = conflict(common, file)) return message;
    }
    for (const std::string& robot : run.robots()) {
        const auto written = written_files(arguments, arguments.outputs.for_robot(robot));
        for (const auto& file : protected_files(arguments, run, robot)) {
            if (auto message = conflict(written, file)) return message;
        }
    }
    return std::nullopt;
}

Result<void> document_error(const engine::Run& run, const std::string& code) {
    for (const engine::Error& failure : run.errors()) {
        if (failure.code == code) return tl::unexpected(failure.message);
    }
    return {};
}

Result<RunOutputs> RunOutputs::open(const RunArguments& arguments, engine::Run& run) {
    RunOutputs all;
    const auto add = [&](const OutputNames& names, std::size_t robot) {
        return Outputs::open(names, run, robot).map([&](std::unique_ptr<Outputs> outputs) {
            all.outputs_.push_back(std::move(outputs));
        });
    };
    if (arguments.request.robots.empty())
        return add(arguments.outputs, 0).map([&] { return std::move(all); });
    for (std::size_t i = 0; i < run.robots().size(); ++i) {
        if (auto result = add(arguments.outputs.for_robot(run.robots()[i]), i); !result)
            return tl::unexpected(result.error());
    }
    OutputNames shared_names;
    shared_names.report = arguments.outputs.report;
    return add(shared_names, 0).map([&] { return std::move(all); });
}

Result<void> RunOutputs::commit(const engine::Report& report) {
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
        const bool for_robot = i < report.robots.size();
        if (auto committed = outputs_[i]->commit(for_robot ? report.robots[i] : report); !committed)
            return committed;
    }
    return {};
}

// The files are locked in a fixed order, so that two runs with the same two files do not wait for each other.
Result<void> PersistentFiles::lock(const RunArguments& arguments, const engine::Run& run) {
    std::set<std::string> files;
    if (!arguments.request.variables.empty()) files.insert(arguments.request.variables);
    const auto saved_file = os::file_identity(arguments.save_machine_data);
    is_in_place_ = saved_file && saved_file == os::file_identity(run.request().machine_data);
    if (is_in_place_) files.insert(arguments.save_machine_data);
    for (const std::string& file : files) {
        auto lock = lock_for_change(file, arguments.wait_s);
        if (!lock) return tl::unexpected(lock.error());
        locks_.push_back(*std::move(lock));
    }
    return {};
}

Result<void> PersistentFiles::check(const RunArguments& arguments) {
    for (const std::string* file : {&arguments.request.variables, &arguments.save_machine_data}) {
        if (file->empty()) continue;
        if (auto writable = os::OutputFile::check(*file); !writable) return writable;
    }
    return {};
}

Result<void> PersistentFiles::write(const RunArguments& arguments, const engine::Run& run) const {
    Result<void> kept;
    if (const std::string& file = arguments.request.variables; !file.empty()) {
        kept = run.variables().map_error(to_error).and_then(
            [&](const std::string& text) { return save_text(file, text); });
    }
    const std::string& file = arguments.save_machine_data;
    if (!kept || file.empty()) return kept;
    const auto data = run.machine_data();
    if (!data) return Unexpected(fmt::format("{} is not written: {}", file, data.error().message));
    return is_in_place_ ? save_text(file, *data) : replace_text(file, *data, arguments.wait_s);
}

}  // namespace gsim::apps
