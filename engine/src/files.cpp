#include "engine/files.h"

#include <utility>

#include "base/os/files.h"
#include "lexer/source.h"

namespace gsim::engine {

Files::Files() : files_(std::shared_ptr<void>(), &os::disk()) {}

Files Files::given(FileProvider provider) {
    return Files(std::make_shared<const os::CallbackFiles>(std::move(provider)));
}

Text::Text(std::string text, std::string name)
    : source_(std::make_shared<lexer::Source>(lexer::Source::from_text(std::move(text), std::move(name)))) {}

tl::expected<Text, std::string> Text::from_stream(std::FILE* stream, std::string name) {
    return lexer::Source::spool(stream, std::move(name)).map([](lexer::Source source) {
        return Text(std::make_shared<lexer::Source>(std::move(source)));
    });
}

}  // namespace gsim::engine
