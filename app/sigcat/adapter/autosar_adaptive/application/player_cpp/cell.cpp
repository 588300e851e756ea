#include "player/cell.h"

#include <algorithm>

namespace player {

namespace {

class Reader final {
public:
    explicit Reader(const std::string& text) : text_(text) {}

    Item Next() {
        Skip();
        if (at_ < text_.size() && (text_[at_] == '[' || text_[at_] == '{')) {
            return Inner(text_[at_] == '[' ? ']' : '}');
        }
        Item item;
        const bool is_quoted = at_ < text_.size() && text_[at_] == '"';
        const std::size_t end = is_quoted ? text_.find('"', at_ + 1) : text_.find_first_of(",]}:", at_);
        const std::size_t begin = at_ + (is_quoted ? 1 : 0);
        item.text = text_.substr(begin, end == std::string::npos ? end : end - begin);
        at_ = end == std::string::npos ? text_.size() : end + (is_quoted ? 1 : 0);
        return item;
    }

private:
    Item Inner(char end) {
        Item item;
        ++at_;
        for (Skip(); at_ < text_.size() && text_[at_] != end; Skip()) {
            if (end == '}') {
                item.keys.push_back(Next().text);
                Skip();
            }
            item.items.push_back(Next());
        }
        if (at_ == text_.size()) {
            throw std::runtime_error{"A list or mapping must be closed."};
        }
        ++at_;
        return item;
    }

    void Skip() { at_ = std::min(text_.find_first_not_of(" \t,:", at_), text_.size()); }

    const std::string& text_;
    std::size_t at_{0};
};

}  // namespace

const Item& Item::At(const std::string& key) const {
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (keys[i] == key) {
            return items[i];
        }
    }
    throw std::runtime_error{"A mapping must have " + key + "."};
}

Item Parsed(const std::string& cell) {
    if (cell.empty() || (cell[0] != '[' && cell[0] != '{')) {
        return {cell, {}, {}};
    }
    return Reader{cell}.Next();
}

}  // namespace player
