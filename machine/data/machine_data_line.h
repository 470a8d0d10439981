#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gsim::machine {

/// A line of machine data whose words can be changed while blanks and remark stay.
class EditedLine {
  public:
    explicit EditedLine(std::string_view line);

    std::size_t size() const { return words_.size(); }
    /// Replaces a word. The text that follows keeps its column if blanks allow that.
    void replace(std::size_t index, std::string_view word);
    /// Inserts a word before that one; `index` is size() for the end, before the remark.
    void insert(std::size_t index, std::string_view word);
    void erase(std::size_t index);

    std::string text() const;

  private:
    struct Word {
        std::string gap;  // in front of it
        std::string text;
    };

    std::vector<Word> words_;
    std::string tail_;  // blanks and the remark
};

}  // namespace gsim::machine
