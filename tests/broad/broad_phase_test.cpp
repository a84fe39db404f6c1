// The tree and the pair search against brute force over all boxes.
#include "broad/broad_phase.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <vector>

#include "support/thread_tasks.hpp"

using namespace tumble;
using namespace tumble::test;

namespace {

class RandomBoxes {
public:
    explicit RandomBoxes(unsigned seed) : random_(seed) {}

    Aabb next(float room = 20.0f) {
        std::uniform_real_distribution<float> place(0.0f, room), side(0.1f, 2.0f);
        const Vec2 lower{place(random_), place(random_)};
        return {lower, lower + Vec2{side(random_), side(random_)}};
    }

    std::uint32_t below(std::uint32_t bound) {
        return std::uniform_int_distribution<std::uint32_t>(0, bound - 1)(random_);
    }

private:
    std::mt19937 random_;
};

std::vector<std::uint32_t> sorted_hits(const AabbTree& tree, const Aabb& box) {
    std::vector<std::uint32_t> keys;
    tree.query(box, [&](std::uint32_t key) { keys.push_back(key); });
    std::sort(keys.begin(), keys.end());
    return keys;
}

struct Proxy {
    Aabb box;
    ProxyLayer layer;
};

std::set<ProxyPair> all_overlaps(const std::map<std::uint32_t, Aabb>& boxes) {
    std::set<ProxyPair> pairs;
    for (const auto& [a, first] : boxes)
        for (const auto& [b, second] : boxes)
            if (a < b && overlaps(first, second)) pairs.insert({a, b});
    return pairs;
}

// The pairs of which at least one leaf has a key that `is_marked` holds for. No leaf stays marked.
template <class IsMarked>
std::set<ProxyPair> pairs_of(AabbTree& tree, const std::map<std::uint32_t, AabbTree::Node>& leaves,
                             IsMarked&& is_marked) {
    std::set<ProxyPair> pairs;
    for (const auto& [key, leaf] : leaves)
        if (is_marked(key)) tree.mark(leaf);
    tree.for_each_pair([&](std::uint32_t a, std::uint32_t b) {
        CHECK(pairs.insert(make_pair_of(a, b)).second);  // each once
    });
    for (const auto& [key, leaf] : leaves)
        if (is_marked(key)) tree.unmark(leaf);
    tree.for_each_pair([](std::uint32_t, std::uint32_t) { FAIL("a mark is left"); });
    return pairs;
}

std::set<ProxyPair> all_overlaps(const std::map<std::uint32_t, Proxy>& proxies) {
    std::set<ProxyPair> pairs;
    for (const auto& [a, first] : proxies)
        for (const auto& [b, second] : proxies)
            if (a < b && overlaps(first.box, second.box) &&
                (first.layer != ProxyLayer::fixed || second.layer != ProxyLayer::fixed))
                pairs.insert({a, b});
    return pairs;
}

bool accept_all(ProxyPair) { return true; }
Crew crew;  // this thread alone

Aabb shifted(const Aabb& box, Vec2 by) { return {box.lower + by, box.upper + by}; }

// Refits what is above placed leaves, in the order of list_changed(). Returns the number of subtrees.
std::size_t refit_all(AabbTree& tree, std::size_t parts, std::size_t capacity) {
    std::vector<AabbTree::Node> changed;
    changed.reserve(capacity);
    const std::size_t first = tree.list_changed(parts, changed);
    CHECK(changed.size() <= capacity);
    for (std::size_t i = first; i < changed.size(); ++i) tree.refit(changed[i]);
    for (std::size_t i = first; i-- > 0;) tree.refit(changed[i]);
    tree.audit();
    return changed.size() - first;
}

void move(BroadPhase& broad, const std::vector<BroadPhase::MovedProxy>& moved, Crew& movers = crew) {
    ChunkLists<BroadPhase::MovedProxy> lists;
    lists.fill(movers, moved.size(), 1, [&](std::size_t i, auto& list) { list.push_back(moved[i]); });
    broad.move(lists, movers);
}

}  // namespace

TEST_CASE("a query finds exactly the overlapping boxes through random edits") {
    RandomBoxes boxes(1);
    AabbTree tree;
    std::map<std::uint32_t, Aabb> live;
    std::map<std::uint32_t, AabbTree::Node> leaves;
    int removed = 0, moved = 0;
    for (std::uint32_t round = 0; round < 3000; ++round) {
        const std::uint32_t key = boxes.below(300);
        const Aabb box = boxes.next();
        if (!live.contains(key)) {
            leaves[key] = tree.insert(box, key);
            live[key] = box;
        } else if (boxes.below(3) == 0) {
            tree.remove(leaves[key]);
            leaves.erase(key);
            live.erase(key);
            ++removed;
        } else {
            // Half of the moves are short: refitted in place, not inserted anew.
            const Aabb near = shifted(live[key], {0.05f, -0.05f});
            live[key] = boxes.below(2) == 0 ? near : box;
            tree.move(leaves[key], live[key]);
            ++moved;
        }
        if (round % 50 == 0) tree.audit();
        const Aabb queried = boxes.next();
        std::vector<std::uint32_t> expected;
        for (const auto& [other, other_box] : live)
            if (overlaps(other_box, queried)) expected.push_back(other);
        REQUIRE(sorted_hits(tree, queried) == expected);
        if (round % 50 != 0) continue;
        for (const std::uint32_t parts : {1u, 2u, 20u, 400u}) {  // all leaves are marked, to none or one
            const auto is_marked = [parts](std::uint32_t marked) { return marked % parts == 0; };
            std::set<ProxyPair> pairs = all_overlaps(live);
            std::erase_if(pairs, [&](ProxyPair pair) { return !is_marked(pair.a) && !is_marked(pair.b); });
            REQUIRE(pairs_of(tree, leaves, is_marked) == pairs);
        }
    }
    CHECK(removed > 300);
    CHECK(moved > 600);
}

TEST_CASE("boxes inserted along a line do not degenerate the tree to a list") {
    // Worst case for greedy insertion. With n boxes of perimeter 4 in a row a balanced tree costs about
    // sum over levels of 2 n = 2 n log2 n; a list costs the sum of 2 k, about n^2.
    constexpr int n = 1024;
    AabbTree tree;
    for (int i = 0; i < n; ++i) {
        const auto x = static_cast<float>(i);
        tree.insert({{x, 0.0f}, {x + 1.0f, 1.0f}}, static_cast<std::uint32_t>(i));
    }
    tree.audit();
    CHECK(tree.cost() - 4.0 * n < 2.0 * (2.0 * n * 10.0));  // the inner nodes: within twice the balanced tree's
}

TEST_CASE("a query of a tree that is as deep as a list finds all leaves") {
    AabbTree tree;  // each box holds those before it
    constexpr std::uint32_t n = 120;
    std::map<std::uint32_t, AabbTree::Node> leaves;
    for (std::uint32_t i = 0; i < n; ++i) {
        const float side = std::ldexp(1.0f, static_cast<int>(i));
        leaves[i] = tree.insert({{-side, -side}, {side, side}}, i);
    }
    CHECK(sorted_hits(tree, {{0.0f, 0.0f}, {0.0f, 0.0f}}).size() == n);
    CHECK(pairs_of(tree, leaves, [](std::uint32_t) { return true; }).size() == n * (n - 1) / 2);
    CHECK(pairs_of(tree, leaves, [](std::uint32_t key) { return key == n / 2; }).size() == n - 1);
    for (const auto& [key, leaf] : leaves) CHECK(tree.place(leaf, tree.box(leaf)));
    CHECK(refit_all(tree, 1000, 16) < 16);  // the list has no room for all nodes
    CHECK(tree.place(leaves[n - 1], tree.box(leaves[n - 1])));
    CHECK(refit_all(tree, 1000, 16) <= 1);
}

TEST_CASE("pairs are those of brute force through random edits, each reported once") {
    Crew own_crew;
    SUBCASE("on one thread") {}
    SUBCASE("on three threads") {
        own_crew = Crew(eager_threads(3));
        REQUIRE(own_crew.thread_count() == 3);
    }
    RandomBoxes boxes(2);
    BroadPhase broad;
    std::map<std::uint32_t, Proxy> live;
    std::set<ProxyPair> known;
    std::size_t reported = 0;
    for (int round = 0; round < 400; ++round) {
        const int edits = round % 2 == 0 ? 10 : 100;  // touches few of the boxes, or most of them
        for (int edit = 0; edit < edits; ++edit) {
            const std::uint32_t key = boxes.below(150);
            if (!live.contains(key)) {
                live[key] = {boxes.next(), static_cast<ProxyLayer>(boxes.below(3))};
                broad.add(key, live[key].box, live[key].layer);
            } else if (boxes.below(3) == 0) {
                live.erase(key);
                broad.remove(key);
                std::erase_if(known, [&](ProxyPair pair) {
                    if (pair.a != key && pair.b != key) return false;
                    broad.remove_pair(pair);
                    return true;
                });
            } else {
                live[key].box = boxes.next();
                move(broad, {{key, live[key].box}});
            }
        }
        std::vector<BroadPhase::MovedProxy> moved;
        for (auto& [key, proxy] : live) {
            if (boxes.below(3) == 0) continue;
            // Most moves are short: such boxes are refitted together. The others are inserted anew.
            proxy.box = boxes.below(10) > 0 ? shifted(proxy.box, {0.05f, -0.05f}) : boxes.next();
            moved.push_back({key, proxy.box});
        }
        own_crew.work_together(moved.size(), [&] { move(broad, moved, own_crew); });
        broad.audit();
        std::vector<ProxyPair> found;
        own_crew.work_together(moved.size(), [&] { found = broad.find_new_pairs(accept_all, own_crew); });
        REQUIRE(std::is_sorted(found.begin(), found.end()));
        for (const ProxyPair pair : found) REQUIRE(known.insert(pair).second);
        reported += found.size();
        std::erase_if(known, [&](ProxyPair pair) {
            if (broad.overlap(pair)) return false;
            broad.remove_pair(pair);
            return true;
        });
        REQUIRE(known == all_overlaps(live));
        REQUIRE(broad.pair_count() == known.size());
        broad.audit();
    }
    CHECK(reported > 1000);
}

TEST_CASE("leaves that move together are refitted where they are, one that leaves its sibling is inserted anew") {
    AabbTree tree;
    std::map<std::uint32_t, AabbTree::Node> leaves;
    const Aabb unit{{0.0f, 0.0f}, {1.0f, 1.0f}};
    for (std::uint32_t i = 0; i < 64; ++i)
        leaves[i] = tree.insert(shifted(unit, {static_cast<float>(i % 8), static_cast<float>(i / 8)}), i);
    // The order in which a query visits leaves shows the links of the tree.
    const auto all_hits = [&](Vec2 corner) {
        std::vector<std::uint32_t> keys;
        tree.query(shifted({{0.0f, 0.0f}, {8.0f, 8.0f}}, corner), [&](std::uint32_t key) { keys.push_back(key); });
        return keys;
    };
    const std::vector<std::uint32_t> hits = all_hits({});
    REQUIRE(hits.size() == 64);
    const double cost = tree.cost();
    const auto move_all = [&](Vec2 path, std::uint32_t stray) {
        for (const auto& [key, leaf] : leaves)
            CHECK_FALSE(tree.place(leaf, shifted(tree.box(leaf), key == stray ? -path : path)));
        CHECK(refit_all(tree, 8, 64) >= 8);
        for (const auto& [key, leaf] : leaves) tree.reinsert_if_apart(leaf);
        tree.audit();
    };
    move_all({128.0f, 256.0f}, 64);
    CHECK(all_hits({128.0f, 256.0f}) == hits);
    CHECK(tree.cost() <= cost);
    move_all({128.0f, 256.0f}, 17);
    // The root alone covers the stray: below it are the others, whose cost is a little less without it.
    const Vec2 span{256.0f + 8.0f, 512.0f + 8.0f};
    CHECK(tree.cost() < cost + 2.0 * static_cast<double>(span.x + span.y));
    CHECK(sorted_hits(tree, shifted(unit, {1.0f, 2.0f})).size() == 1);
}

TEST_CASE("a rejected pair is found again when one of its proxies is touched") {
    BroadPhase broad;
    broad.add(0, {{0, 0}, {1, 1}}, ProxyLayer::dynamic);
    broad.add(1, {{0.5f, 0}, {1.5f, 1}}, ProxyLayer::dynamic);
    CHECK(broad.find_new_pairs([](ProxyPair) { return false; }, crew).empty());
    CHECK(broad.find_new_pairs(accept_all, crew).empty());
    broad.touch(1);
    CHECK(broad.find_new_pairs(accept_all, crew) == std::vector<ProxyPair>{{0, 1}});
    broad.touch(0);
    CHECK(broad.find_new_pairs(accept_all, crew).empty());
}

TEST_CASE("boxes that touch in a point are a pair, two fixed ones are not") {
    BroadPhase broad;
    broad.add(3, {{0, 0}, {1, 1}}, ProxyLayer::fixed);
    broad.add(1, {{1, 1}, {2, 2}}, ProxyLayer::dynamic);
    broad.add(2, {{0, 0}, {0.5f, 0.5f}}, ProxyLayer::fixed);
    CHECK(broad.find_new_pairs(accept_all, crew) == std::vector<ProxyPair>{{1, 3}});
}

TEST_CASE("a pair set agrees with std::set through random edits") {
    RandomBoxes random(3);
    PairSet pairs;
    std::set<ProxyPair> expected;
    for (int round = 0; round < 20000; ++round) {
        const ProxyPair pair = make_pair_of(random.below(40), 40 + random.below(40));
        if (expected.contains(pair) && random.below(2) == 0) {
            expected.erase(pair);
            pairs.erase(pair);
        } else if (expected.insert(pair).second) {
            REQUIRE_FALSE(pairs.contains(pair));
            pairs.insert(pair);
        }
        REQUIRE(pairs.size() == expected.size());
        const ProxyPair queried = make_pair_of(random.below(40), 40 + random.below(40));
        REQUIRE(pairs.contains(queried) == expected.contains(queried));
    }
}
