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
    /// Puts another word in the place of one. What stands behind it keeps its column where blanks allow that.
    void replace(std::size_t index, std::string_view word);
    /// Inserts a word in front of that one; `index` is size() for the end, in front of the remark.
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
