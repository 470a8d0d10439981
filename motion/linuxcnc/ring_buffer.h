#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace gsim::motion::linuxcnc {

/// Queue with reused slots: elements are added at the back, accessed by their index from the front, and
/// removed at the front. It grows to the most elements that it ever held.
template <class Element>
class RingBuffer {
  public:
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    Element& operator[](std::size_t index) { return slots_[(first_ + index) & (slots_.size() - 1)]; }
    const Element& operator[](std::size_t index) const {
        return slots_[(first_ + index) & (slots_.size() - 1)];
    }
    Element& front() { return (*this)[0]; }
    Element& back() { return (*this)[size_ - 1]; }

    /// Returns a new last element, with the previous content of its slot.
    Element& push() {
        if (size_ == slots_.size()) grow();
        ++size_;
        return back();
    }
    /// Duplicates the element at `index`.
    void duplicate(std::size_t index) {
        push();
        for (std::size_t i = size_ - 1; i > index; --i) (*this)[i] = (*this)[i - 1];
    }
    void pop() {
        first_ = (first_ + 1) & (slots_.size() - 1);
        --size_;
    }
    void clear() { size_ = 0; }

  private:
    void grow() {
        std::vector<Element> grown_slots(slots_.empty() ? 16 : 2 * slots_.size());  // a power of two
        for (std::size_t i = 0; i < size_; ++i) grown_slots[i] = std::move((*this)[i]);
        slots_ = std::move(grown_slots);
        first_ = 0;
    }

    std::vector<Element> slots_;
    std::size_t first_ = 0;
    std::size_t size_ = 0;
};

}  // namespace gsim::motion::linuxcnc
