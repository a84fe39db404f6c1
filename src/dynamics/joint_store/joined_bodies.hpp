// The two to four bodies that a joint acts on, each once.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "debug/check.hpp"
#include "tumble/id.hpp"

namespace tumble {

class JoinedBodies {
public:
    void add(BodyId body) {
        if (std::find(begin(), end(), body) != end()) return;
        TUMBLE_CHECK(count_ < bodies_.size());
        bodies_[count_++] = body;
    }
    const BodyId* begin() const { return bodies_.data(); }
    const BodyId* end() const { return bodies_.data() + count_; }

    // Calls visit(body, other), by index, for each two of them.
    template <class Visitor>
    void for_each_pair(Visitor&& visit) const {
        for (const BodyId* body = begin(); body != end(); ++body)
            for (const BodyId* other = body + 1; other != end(); ++other) visit(body->index, other->index);
    }

private:
    std::array<BodyId, 4> bodies_;
    std::size_t count_ = 0;
};

}  // namespace tumble
