#include "engine/translation.h"

#include <utility>

#include "codegen/language_page.h"
#include "engine/src/conversions.h"
#include "engine/src/guard_exceptions.h"
#include "engine/src/host_names.h"
#include "engine/src/machine/machine_input.h"
#include "engine/src/run/language.h"
#include "engine/src/run/run_inputs.h"
#include "engine/src/run/translate_program.h"

namespace gsim::engine {

using text::DiagnosticKind;

class Translation::State {
  public:
    State(const TranslationRequest& request, Language language, lexer::Source source)
        : cpu_limit_(request.cpu_s), language_(std::move(language)), source_(std::move(source)) {
        cpu_limit_.set_cancel_flag(request.cancel.flag());
        language_.cpu = &cpu_limit_;
        options_.annotate = request.annotate;
        options_.max_errors = request.max_errors;
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    codegen::LuaSpool& spool() { return spool_; }
    tl::expected<void, Error> make(const DiagnosticHandler& on_diagnostic) {
        std::optional<Diagnostic> first;
        const auto result = translate_source(source_, spool_, language_, options_, [&](const auto& reported) {
            const Diagnostic diagnostic = to_diagnostic(reported);
            if (reported.severity == text::Severity::error && !first) first = diagnostic;
            if (on_diagnostic) on_diagnostic(diagnostic);
        });
        if (const auto error_message = source_.error_message())
            return tl::unexpected(make_error(DiagnosticKind::file, *error_message));
        if (result.ok) return {};
        return tl::unexpected(Error{.code = first ? first->code : "syntax",
                                    .message = first ? first->text : std::string(),
                                    .in_program = true,
                                    .first_error = first});
    }

  private:
    os::CpuLimit cpu_limit_;
    Language language_;
    lexer::Source source_;
    codegen::TranslateOptions options_;
    codegen::LuaSpool spool_;
};

namespace {

Result<void> add_cell_files(TranslationRequest& request) {
    if (request.cell.empty()) return {};
    Request run;
    run.machine = request.machine;
    run.machine_data = request.machine_data;
    run.cell = request.cell;
    run.host = request.host;
    return resolve_files(std::move(run)).map([&](const ResolvedRequest& found) {
        request.machine = found.request.machine;
        request.machine_data = found.request.machine_data;
    });
}

Result<machine::MachineData> read_data(const TranslationRequest& request) {
    if (request.machine_data.empty()) return machine::MachineData();
    return request.host.files.impl()
        .read_text(request.machine_data, os::NameSource::command_line)
        .and_then(
            [&](const std::string& text) { return machine::read_machine_data(text, request.machine_data); });
}

Result<machine::ProgramTable> read_table(const TranslationRequest& request) {
    if (request.machine.empty()) return machine::ProgramTable();
    return read_program_input(request.host, request.machine);
}

Result<lexer::Source> open_program(TranslationRequest& request) {
    if (request.text) return std::move(request.text->impl());
    return resolve_name(request.host, NameKind::sample, request.program)
        .and_then([&](const std::string& file) -> Result<lexer::Source> {
            return lexer::Source::open(request.host.files.impl(), file, os::NameSource::command_line);
        });
}

}  // namespace

tl::expected<Translation, Error> Translation::open(TranslationRequest request) {
    return guard_exceptions([&]() -> tl::expected<Translation, Error> {
        const auto unexpected_error = [](const std::string& message, std::string file = {}) {
            return tl::unexpected(make_error(DiagnosticKind::input_file, message, std::move(file)));
        };
        if (auto result = add_cell_files(request); !result)
            return unexpected_error(result.error().message, request.cell);
        const auto data = read_data(request);
        if (!data) return unexpected_error(data.error().message, request.machine_data);
        const auto table = read_table(request);
        if (!table) return unexpected_error(table.error().message, request.machine);
        auto language = make_language(request.language, *table, *data);
        if (!language) return unexpected_error(language.error().message);
        auto source = open_program(request);
        if (!source) return tl::unexpected(make_error(DiagnosticKind::file, source.error(), request.program));
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

tl::expected<void, Error> Translation::make(const DiagnosticHandler& on_diagnostic) {
    return guard_exceptions([&] { return state_->make(on_diagnostic); });
}

tl::expected<void, Error> Translation::write(const std::function<bool(std::string_view)>& callback) const {
    return guard_exceptions([&]() -> tl::expected<void, Error> {
        bool continues = true;
        return state_->spool()
            .copy_to([&](std::string_view part) { continues = continues && callback(part); })
            .map_error(
                [](const gsim::Error& error) { return make_error(DiagnosticKind::output, error.message); });
    });
}

std::string language_page() {
    return codegen::language_page();
}

}  // namespace gsim::engine
