#include <algorithm>
#include <iterator>

#include "engine/run.h"

namespace gsim::engine {

namespace {

struct DocumentWord {
    Document document;
    const char* word;
};

constexpr DocumentWord kDocumentWords[] = {
#define GSIM_DOCUMENT(name, number, option, help, ...) {Document::name, #name},
#include "engine/documents.def"
};

}  // namespace

std::vector<std::string> document_names() {
    std::vector<DocumentWord> words(std::begin(kDocumentWords), std::end(kDocumentWords));
    std::sort(words.begin(), words.end(),
              [](const DocumentWord& a, const DocumentWord& b) { return a.document < b.document; });
    std::vector<std::string> names;
    names.reserve(words.size());
    for (const DocumentWord& each : words) names.emplace_back(each.word);
    return names;
}

std::optional<Document> document_named(std::string_view name) {
    for (const DocumentWord& each : kDocumentWords) {
        if (each.word == name) return each.document;
    }
    return std::nullopt;
}

}  // namespace gsim::engine
