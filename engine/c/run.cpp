#include <algorithm>
#include <new>

#include "engine/c/handles.h"
#include "engine/version.h"

namespace gsim::engine {

#define GSIM_RUN_STATUS(name, number, constant) static_assert((constant) == (number));
#include "base/kinds/run_status.def"
#define GSIM_SEVERITY(name, number, constant) static_assert((constant) == (number));
#include "base/kinds/severity.def"

Tell tell_of(gsim_tell tell, void* user) {
    if (tell == nullptr) return {};
    return [tell, user](const Diagnostic& told) {
        const gsim_diagnostic diagnostic{.severity = static_cast<std::int32_t>(told.severity),
                                         .line = told.line,
                                         .column = told.column,
                                         .end_column = told.end_column,
                                         .code = told.code.c_str(),
                                         .file = told.file.c_str(),
                                         .text = told.text.c_str(),
                                         .hint = told.hint.c_str()};
        tell(user, &diagnostic);
    };
}

std::int32_t keep_failure(gsim_run& run, const Failure& failure) {
    run.error = failure.message;
    return failure.in_program ? GSIM_REFUSED : GSIM_FAILED;
}

namespace {

std::int32_t open(gsim_run& run, const gsim_request& given, const Tell& tell) {
    Request request = request_of(given);
    request.cancel = run.cancel;
    auto opened = Run::open(std::move(request), tell);
    if (!opened) return keep_failure(run, opened.error());
    run.run.emplace(*std::move(opened));
    const auto prepared = run.run->prepare();
    if (prepared) return GSIM_OK;
    if (prepared.error().in_program) run.report = run.run->report_of(prepared.error());
    return keep_failure(run, prepared.error());
}

bool is_ready(const gsim_run& run, std::size_t robot) {
    return run.run && run.status == GSIM_OK && robot < run.run->robots().size();
}

/// Stores a message in place of an unavailable result.
std::int32_t not_ready(gsim_run& run) {
    if (run.error.empty()) run.error = "there is no such robot";
    return GSIM_FAILED;
}

const char* kept(gsim_run& run, std::string& place, const tl::expected<std::string, Failure>& text) {
    if (!text) {
        keep_failure(run, text.error());
        return nullptr;
    }
    place = *text;
    return place.c_str();
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

gsim_run* gsim_run_open(const gsim_request* request, gsim_tell tell, void* user) {
    gsim_run* run = new (std::nothrow) gsim_run();
    if (run == nullptr) return nullptr;
    run->status = without_throwing([&] { return open(*run, *request, tell_of(tell, user)); });
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

size_t gsim_run_robots(const gsim_run* run) {
    return run->run ? run->run->robots().size() : 0;
}

const char* gsim_run_robot(const gsim_run* run, size_t robot) {
    return robot < gsim_run_robots(run) ? run->run->robots()[robot].c_str() : "";
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

int32_t gsim_run_show_progress(gsim_run* run, gsim_show_progress show, void* user) {
    return without_throwing([&] {
        if (!is_ready(*run, 0)) return not_ready(*run);
        run->run->show_progress(
            [show, user](std::uint64_t done, std::uint64_t total) { show(user, done, total); });
        return std::int32_t{GSIM_OK};
    });
}

int32_t gsim_run_go(gsim_run* run) {
    return without_throwing([&] {
        if (!is_ready(*run, 0)) return not_ready(*run);
        if (run->report) {
            run->error = "a run goes once";
            return std::int32_t{GSIM_FAILED};
        }
        auto report = run->run->go();
        if (!report) return keep_failure(*run, report.error());
        run->report = *std::move(report);
        for (const Failure& fault : run->run->faults()) keep_failure(*run, fault);
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
    without_throwing([&] {
        if (run->report && run->json.empty()) run->json = run->report->json();
        return GSIM_OK;
    });
    return run->json.c_str();
}

const char* gsim_run_report_text(gsim_run* run) {
    without_throwing([&] {
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
    without_throwing([&] {
        if (!run->report || !is_ready(*run, 0)) return not_ready(*run);
        text = kept(*run, run->variables, run->run->variables());
        return std::int32_t{GSIM_OK};
    });
    return text;
}

const char* gsim_run_machine_data(gsim_run* run) {
    const char* text = nullptr;
    without_throwing([&] {
        if (!run->report || !is_ready(*run, 0)) return not_ready(*run);
        text = kept(*run, run->machine_data, run->run->machine_data());
        return std::int32_t{GSIM_OK};
    });
    return text;
}

int32_t gsim_translate(const gsim_request* request, gsim_tell tell, void* tell_user, gsim_take_text take,
                       void* take_user) {
    return without_throwing([&]() -> std::int32_t {
        Request given = request_of(*request);
        TranslationRequest asked;
        asked.program = given.program;
        asked.text = given.text;
        asked.machine = given.machine;
        asked.machine_data = given.machine_data;
        asked.language = given.language;
        asked.cpu_s = given.limits.cpu_s;
        asked.host = given.host;
        const Tell telling = tell_of(tell, tell_user);
        const auto fail = [&](const Failure& failure) -> std::int32_t {
            if (failure.in_program) return GSIM_REFUSED;
            if (telling) telling({.code = failure.code, .file = failure.file, .text = failure.message});
            return GSIM_FAILED;
        };
        auto translation = Translation::open(std::move(asked));
        if (!translation) return fail(translation.error());
        if (const auto made = translation->make(telling); !made) return fail(made.error());
        bool taken = true;
        const auto written = translation->write(
            [&](std::string_view text) { return taken = take(take_user, text.data(), text.size()) != 0; });
        if (!written) return fail(written.error());
        return taken ? GSIM_OK : GSIM_FAILED;
    });
}
