#include "broad/broad_phase.hpp"

#include <stdexcept>
#include <string>

namespace tumble {

void BroadPhase::add(std::uint32_t key, const Aabb& box, Mobility mobility) {
    if (key >= proxies_.size()) proxies_.resize(key + 1);
    Proxy& proxy = proxies_[key];
    proxy.box = box;
    proxy.mobility = mobility;
    proxy.leaf = tree(mobility).insert(box, key);
    touch(key);
}

// The key may still wait in asked_; a search skips it there unless it has been given to a new proxy.
void BroadPhase::remove(std::uint32_t key) {
    Proxy& proxy = proxies_[key];
    tree(proxy.mobility).remove(proxy.leaf);
    proxy.leaf = AabbTree::kNone;
}

void BroadPhase::move(std::uint32_t key, const Aabb& box) {
    Proxy& proxy = proxies_[key];
    proxy.box = box;
    tree(proxy.mobility).move(proxy.leaf, box);
    touch(key);
}

void BroadPhase::touch(std::uint32_t key) {
    if (proxies_[key].is_asked) return;
    proxies_[key].is_asked = true;
    asked_.push_back(key);
}

void BroadPhase::validate() const {
    fixed_.validate();
    moving_.validate();
    std::size_t fixed_count = 0, moving_count = 0;
    for (std::uint32_t key = 0; key < proxies_.size(); ++key) {
        const Proxy& proxy = proxies_[key];
        if (proxy.leaf == AabbTree::kNone) continue;
        const bool is_fixed = proxy.mobility == Mobility::fixed;
        (is_fixed ? fixed_count : moving_count) += 1;
        if ((is_fixed ? fixed_ : moving_).box(proxy.leaf) != proxy.box)
            throw std::logic_error("broad phase: proxy " + std::to_string(key) + ": box differs from its leaf's");
    }
    if (fixed_count != fixed_.leaf_count() || moving_count != moving_.leaf_count())
        throw std::logic_error("broad phase: proxies and leaves differ in number");
}

}  // namespace tumble
