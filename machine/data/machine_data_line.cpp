#include "machine/data/machine_data_line.h"

#include <algorithm>

#include "machine/data/machine_data_words.h"

namespace gsim::machine {

EditedLine::EditedLine(std::string_view line) {
    std::size_t end = 0;
    for (const DataWord& word : data_words(line)) {
        const std::size_t start = word.column - 1;
        words_.push_back({std::string(line.substr(end, start - end)), std::string(word.text)});
        end = start + word.text.size();
    }
    tail_ = line.substr(end);
}

void EditedLine::replace(std::size_t index, std::string_view word) {
    Word& old = words_[index];
    std::string& gap = index + 1 < words_.size() ? words_[index + 1].gap : tail_;
    const std::size_t blanks = std::min(gap.find_first_not_of(' '), gap.size());
    if (blanks > 1 && old.text.size() > word.size()) gap.insert(0, old.text.size() - word.size(), ' ');
    if (blanks > 1 && old.text.size() < word.size())
        gap.erase(0, std::min(word.size() - old.text.size(), blanks - 1));
    old.text = word;
}

void EditedLine::insert(std::size_t index, std::string_view word) {
    words_.insert(words_.begin() + static_cast<std::ptrdiff_t>(index),
                  {index == 0 ? std::string() : std::string("  "), std::string(word)});
}

void EditedLine::erase(std::size_t index) {
    words_.erase(words_.begin() + static_cast<std::ptrdiff_t>(index));
}

std::string EditedLine::text() const {
    std::string text;
    for (const Word& word : words_) text += word.gap + word.text;
    return text + tail_;
}

}  // namespace gsim::machine
