#include "broad/broad_phase.hpp"

#include <stdexcept>
#include <string>

namespace tumble {

void BroadPhase::add(std::uint32_t key, const Aabb& box, ProxyLayer layer) {
    if (key >= proxies_.size()) {
        proxies_.resize(key + 1);
        is_touched_.resize(key + 1);
    }
    Proxy& proxy = proxies_[key];
    TUMBLE_CHECK(proxy.leaf == AabbTree::kNone);
    proxy.box = box;
    proxy.layer = layer;
    proxy.leaf = tree(layer).insert(box, key);
    touch(key);
}

// The key may stay in touched_: the next search skips it unless a new proxy has this key.
void BroadPhase::remove(std::uint32_t key) {
    TUMBLE_CHECK(has(key));
    Proxy& proxy = proxies_[key];
    tree(proxy.layer).remove(proxy.leaf);
    proxy.leaf = AabbTree::kNone;
}

void BroadPhase::move(const ChunkLists<MovedProxy>& moved) {
    moved.for_each([&](const MovedProxy& proxy) { touch(proxy.key); });  // may run out of memory; what follows does not
    bool all_placed = true;
    moved.for_each([&](const MovedProxy& proxy) {
        proxies_[proxy.key].box = proxy.box;
        all_placed &= tree(proxies_[proxy.key].layer).place(proxies_[proxy.key].leaf, proxy.box);
    });
    for (AabbTree& tree : trees_) tree.refit();
    if (all_placed) return;
    moved.for_each([&](const MovedProxy& proxy) {
        AabbTree& tree = this->tree(proxies_[proxy.key].layer);
        if (tree.box(proxies_[proxy.key].leaf) != proxy.box) tree.move(proxies_[proxy.key].leaf, proxy.box);
    });
}

void BroadPhase::touch(std::uint32_t key) {
    TUMBLE_CHECK(has(key));
    if (is_touched_[key]) return;
    is_touched_[key] = 1;
    touched_.push_back(key);
}

void BroadPhase::audit() const {
    std::array<std::size_t, 3> counts{};
    for (const AabbTree& tree : trees_) tree.audit();
    for (std::uint32_t key = 0; key < proxies_.size(); ++key) {
        const Proxy& proxy = proxies_[key];
        if (proxy.leaf == AabbTree::kNone) continue;
        const auto layer = static_cast<std::size_t>(proxy.layer);
        ++counts[layer];
        if (trees_[layer].box(proxy.leaf) != proxy.box)
            throw std::logic_error("broad phase: proxy " + std::to_string(key) + ": box differs from its leaf's");
    }
    for (std::size_t layer = 0; layer < counts.size(); ++layer)
        if (counts[layer] != trees_[layer].leaf_count())
            throw std::logic_error("broad phase: proxies and leaves differ in number");
}

}  // namespace tumble
