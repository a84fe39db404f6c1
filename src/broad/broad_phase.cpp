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

void BroadPhase::move(ChunkLists<MovedProxy>& moved, Crew& crew) {
    // These two may run out of memory; what follows does not.
    moved.for_each([&](const MovedProxy& proxy) { touch(proxy.key); });
    changed_.reserve(kNodesOfPart * parts_of_walk(crew));
    moved.for_each_list(crew, [&](std::vector<MovedProxy>& proxies) {
        for (const MovedProxy& proxy : proxies) {
            Proxy& own = proxies_[proxy.key];
            own.box = proxy.box;
            tree(own.layer).prefetch(own.leaf);
        }
        std::size_t far = 0;  // the number of proxies whose new box is apart from the old one: the list keeps them
        for (const MovedProxy& proxy : proxies)
            if (!tree(proxies_[proxy.key].layer).place(proxies_[proxy.key].leaf, proxy.box)) proxies[far++] = proxy;
        proxies.resize(far);
    });
    for (AabbTree& tree : trees_) refit(tree, crew);
    moved.for_each(
        [&](const MovedProxy& proxy) { tree(proxies_[proxy.key].layer).reinsert_if_apart(proxies_[proxy.key].leaf); });
}

std::size_t BroadPhase::parts_of_walk(const Crew& crew) const {
    const std::size_t chunks = crew.chunk_count(touched_.size(), kLeastLeaves);
    return chunks > 1 ? kPartsOfChunk * chunks : 1;
}

void BroadPhase::refit(AabbTree& tree, Crew& crew) {
    const std::size_t first = tree.list_changed(parts_of_walk(crew), changed_);
    crew.for_each(changed_.size() - first, kPartsOfChunk, [&](std::size_t i) { tree.refit(changed_[first + i]); });
    for (std::size_t i = first; i-- > 0;) tree.refit(changed_[i]);
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
