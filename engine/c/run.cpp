#include <algorithm>
#include <new>

#include "engine/c/handles.h"
#include "engine/version.h"

namespace gsim::engine {

#define GSIM_RUN_STATUS(name, number, constant) static_assert((constant) == (number));
#include "base/kinds/run_status.def"
#define GSIM_SEVERITY(name, number, constant) static_assert((constant) == (number));
#include "base/kinds/severity.def"

DiagnosticHandler make_diagnostic_handler(gsim_on_diagnostic on_diagnostic, void* user) {
    if (on_diagnostic == nullptr) return {};
    return [on_diagnostic, user](const Diagnostic& reported) {
        const gsim_diagnostic diagnostic{.severity = static_cast<std::int32_t>(reported.severity),
                                         .line = reported.line,
                                         .column = reported.column,
                                         .end_column = reported.end_column,
                                         .code = reported.code.c_str(),
                                         .file = reported.file.c_str(),
                                         .text = reported.text.c_str(),
                                         .hint = reported.hint.c_str()};
        on_diagnostic(user, &diagnostic);
    };
}

std::int32_t store_error(gsim_run& run, const Error& error) {
    run.error = error.message;
    return error.in_program ? GSIM_REJECTED : GSIM_FAILED;
}

namespace {

std::int32_t open(gsim_run& run, const gsim_request& given, const DiagnosticHandler& on_diagnostic) {
    Request request = make_request(given);
    request.cancel = run.cancel;
    auto opened = Run::open(std::move(request), on_diagnostic);
    if (!opened) return store_error(run, opened.error());
    run.run.emplace(*std::move(opened));
    const auto prepared = run.run->prepare();
    if (prepared) return GSIM_OK;
    if (prepared.error().in_program) run.report = run.run->make_report(prepared.error());
    return store_error(run, prepared.error());
}

bool is_ready(const gsim_run& run, std::size_t robot) {
    return run.run && run.status == GSIM_OK && robot < run.run->robots().size();
}

/// Stores a message in place of an unavailable result.
std::int32_t report_not_ready(gsim_run& run) {
    if (run.error.empty()) run.error = "the robot does not exist";
    return GSIM_FAILED;
}

const char* kept(gsim_run& run, std::string& storage, const tl::expected<std::string, Error>& text) {
    if (!text) {
        store_error(run, text.error());
        return nullptr;
    }
    storage = *text;
    return storage.c_str();
}

}  // namespace
}  // namespace gsim::engine

using namespace gsim::engine;

int32_t gsim_api_version() {
    return GSIM_API_VERSION;
}

const char* gsim_version() {
    return gsim::engine::version();
}

gsim_run* gsim_run_open(const gsim_request* request, gsim_on_diagnostic on_diagnostic, void* user) {
    gsim_run* run = new (std::nothrow) gsim_run();
    if (run == nullptr) return nullptr;
    run->status =
        call_noexcept([&] { return open(*run, *request, make_diagnostic_handler(on_diagnostic, user)); });
    return run;
}

void gsim_run_destroy(gsim_run* run) {
    delete run;
}

int32_t gsim_run_status(const gsim_run* run) {
    return run->status;
}

const char* gsim_run_error(const gsim_run* run) {
    return run->error.c_str();
}

size_t gsim_run_robot_count(const gsim_run* run) {
    return run->run ? run->run->robots().size() : 0;
}

const char* gsim_run_robot_name(const gsim_run* run, size_t robot) {
    return robot < gsim_run_robot_count(run) ? run->run->robots()[robot].c_str() : "";
}

char gsim_run_axis(const gsim_run* run, size_t robot, size_t axis) {
    if (!is_ready(*run, robot) || axis >= run->run->axes(robot).size()) return 0;
    return run->run->axes(robot)[axis].letter;
}

int32_t gsim_run_axis_is_rotary(const gsim_run* run, size_t robot, size_t axis) {
    return gsim_run_axis(run, robot, axis) != 0 && run->run->axes(robot)[axis].rotary ? 1 : 0;
}

double gsim_run_home(const gsim_run* run, size_t robot, size_t axis) {
    return gsim_run_axis(run, robot, axis) != 0 ? run->run->home(robot)[axis] : 0;
}

int32_t gsim_run_on_progress(gsim_run* run, gsim_on_progress show, void* user) {
    return call_noexcept([&] {
        if (!is_ready(*run, 0)) return report_not_ready(*run);
        run->run->on_progress(
            [show, user](std::uint64_t done, std::uint64_t total) { show(user, done, total); });
        return std::int32_t{GSIM_OK};
    });
}

int32_t gsim_run_go(gsim_run* run) {
    return call_noexcept([&] {
        if (!is_ready(*run, 0)) return report_not_ready(*run);
        if (run->report) {
            run->error = "a run can be started only once";
            return std::int32_t{GSIM_FAILED};
        }
        auto report = run->run->go();
        if (!report) return store_error(*run, report.error());
        run->report = *std::move(report);
        for (const Error& error : run->run->errors()) store_error(*run, error);
        return std::int32_t{GSIM_OK};
    });
}

void gsim_run_cancel(gsim_run* run) {
    run->cancel.now();
}

int32_t gsim_run_outcome(const gsim_run* run) {
    return run->report ? static_cast<std::int32_t>(run->report->status) : GSIM_ALARM;
}

double gsim_run_cycle_time_s(const gsim_run* run) {
    return run->report ? run->report->cycle_time_s : 0;
}

const char* gsim_run_report_json(gsim_run* run) {
    call_noexcept([&] {
        if (run->report && run->json.empty()) run->json = run->report->json();
        return GSIM_OK;
    });
    return run->json.c_str();
}

const char* gsim_run_report_text(gsim_run* run) {
    call_noexcept([&] {
        if (run->report && run->text.empty()) run->text = run->report->text();
        return GSIM_OK;
    });
    return run->text.c_str();
}

const char* gsim_run_file(const gsim_run* run, uint32_t file) {
    return file < run->file_names.size() ? run->file_names[file]->c_str() : "";
}

const char* gsim_run_variables(gsim_run* run) {
    const char* text = nullptr;
    call_noexcept([&] {
        if (!run->report || !is_ready(*run, 0)) return report_not_ready(*run);
        text = kept(*run, run->variables, run->run->variables());
        return std::int32_t{GSIM_OK};
    });
    return text;
}

const char* gsim_run_machine_data(gsim_run* run) {
    const char* text = nullptr;
    call_noexcept([&] {
        if (!run->report || !is_ready(*run, 0)) return report_not_ready(*run);
        text = kept(*run, run->machine_data, run->run->machine_data());
        return std::int32_t{GSIM_OK};
    });
    return text;
}

int32_t gsim_translate(const gsim_request* request, gsim_on_diagnostic on_diagnostic, void* handler_user,
                       gsim_write_text callback, void* sink_user) {
    return call_noexcept([&]() -> std::int32_t {
        Request given = make_request(*request);
        TranslationRequest translation_options;
        translation_options.program = given.program;
        translation_options.text = given.text;
        translation_options.machine = given.machine;
        translation_options.machine_data = given.machine_data;
        translation_options.language = given.language;
        translation_options.cpu_s = given.limits.cpu_s;
        translation_options.host = given.host;
        const DiagnosticHandler cpp_handler = make_diagnostic_handler(on_diagnostic, handler_user);
        const auto fail = [&](const Error& error) -> std::int32_t {
            if (error.in_program) return GSIM_REJECTED;
            if (cpp_handler) cpp_handler({.code = error.code, .file = error.file, .text = error.message});
            return GSIM_FAILED;
        };
        auto translation = Translation::open(std::move(translation_options));
        if (!translation) return fail(translation.error());
        if (const auto result = translation->make(cpp_handler); !result) return fail(result.error());
        bool is_accepted = true;
        const auto written = translation->write([&](std::string_view text) {
            return is_accepted = callback(sink_user, text.data(), text.size()) != 0;
        });
        if (!written) return fail(written.error());
        return is_accepted ? GSIM_OK : GSIM_FAILED;
    });
}
