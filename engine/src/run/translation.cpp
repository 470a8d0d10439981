#include "engine/translation.h"

#include <utility>

#include "codegen/language_page.h"
#include "engine/src/guarded.h"
#include "engine/src/host_names.h"
#include "engine/src/machine/machine_input.h"
#include "engine/src/run/language.h"
#include "engine/src/run/run_inputs.h"
#include "engine/src/run/translate_program.h"
#include "engine/src/values.h"

namespace gsim::engine {

using text::DiagnosticKind;

class Translation::State {
  public:
    State(const TranslationRequest& request, Language language, lexer::Source source)
        : cpu_(request.cpu_s), language_(std::move(language)), source_(std::move(source)) {
        cpu_.end_when(request.cancel.flag());
        language_.cpu = &cpu_;
        options_.annotate = request.annotate;
        options_.max_errors = request.max_errors;
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    codegen::LuaSpool& spool() { return spool_; }
    tl::expected<void, Failure> make(const Tell& tell) {
        std::optional<Diagnostic> first;
        const auto made = translate_source(source_, spool_, language_, options_, [&](const auto& told) {
            const Diagnostic diagnostic = diagnostic_of(told);
            if (told.severity == text::Severity::error && !first) first = diagnostic;
            if (tell) tell(diagnostic);
        });
        if (const auto fault = source_.fault())
            return tl::unexpected(failure_of(DiagnosticKind::file, *fault));
        if (made.ok) return {};
        return tl::unexpected(Failure{.code = first ? first->code : "syntax",
                                      .message = first ? first->text : std::string(),
                                      .in_program = true,
                                      .first_error = first});
    }

  private:
    os::CpuLimit cpu_;
    Language language_;
    lexer::Source source_;
    codegen::TranslateOptions options_;
    codegen::LuaSpool spool_;
};

namespace {

tl::expected<void, std::string> take_files_of_cell(TranslationRequest& request) {
    if (request.cell.empty()) return {};
    Request run;
    run.machine = request.machine;
    run.machine_data = request.machine_data;
    run.cell = request.cell;
    run.host = request.host;
    return with_files_found(std::move(run)).map([&](const FoundRequest& found) {
        request.machine = found.request.machine;
        request.machine_data = found.request.machine_data;
    });
}

tl::expected<machine::MachineData, std::string> read_data(const TranslationRequest& request) {
    if (request.machine_data.empty()) return machine::MachineData();
    return request.host.files.inner()
        .read_text(request.machine_data, os::NamedBy::command_line)
        .and_then(
            [&](const std::string& text) { return machine::read_machine_data(text, request.machine_data); });
}

tl::expected<machine::ProgramTable, std::string> read_table(const TranslationRequest& request) {
    if (request.machine.empty()) return machine::ProgramTable();
    return read_program_input(request.host, request.machine);
}

tl::expected<lexer::Source, std::string> open_program(TranslationRequest& request) {
    if (request.text) return std::move(request.text->inner());
    return find_name(request.host, NameKind::sample, request.program).and_then([&](const std::string& file) {
        return lexer::Source::open(request.host.files.inner(), file, os::NamedBy::command_line);
    });
}

}  // namespace

tl::expected<Translation, Failure> Translation::open(TranslationRequest request) {
    return guarded([&]() -> tl::expected<Translation, Failure> {
        const auto refused = [](const std::string& sentence, std::string file = {}) {
            return tl::unexpected(failure_of(DiagnosticKind::input_file, sentence, std::move(file)));
        };
        if (auto taken = take_files_of_cell(request); !taken) return refused(taken.error(), request.cell);
        const auto data = read_data(request);
        if (!data) return refused(data.error(), request.machine_data);
        const auto table = read_table(request);
        if (!table) return refused(table.error(), request.machine);
        auto language = language_of(request.language, *table, *data);
        if (!language) return refused(language.error());
        auto source = open_program(request);
        if (!source) return tl::unexpected(failure_of(DiagnosticKind::file, source.error(), request.program));
        return Translation(std::make_unique<State>(request, *std::move(language), *std::move(source)));
    });
}

Translation::Translation(std::unique_ptr<State> state) : state_(std::move(state)) {}
Translation::Translation(Translation&&) noexcept = default;
Translation& Translation::operator=(Translation&&) noexcept = default;
Translation::~Translation() = default;

void Translation::reserve_space() {
    state_->spool().reserve_file();
}

tl::expected<void, Failure> Translation::make(const Tell& tell) {
    return guarded([&] { return state_->make(tell); });
}

tl::expected<void, Failure> Translation::write(const std::function<bool(std::string_view)>& take) const {
    return guarded([&]() -> tl::expected<void, Failure> {
        bool goes_on = true;
        return state_->spool()
            .copy_to([&](std::string_view part) { goes_on = goes_on && take(part); })
            .map_error(
                [](std::string sentence) { return failure_of(DiagnosticKind::output, std::move(sentence)); });
    });
}

std::string language_page() {
    return codegen::language_page();
}

}  // namespace gsim::engine
