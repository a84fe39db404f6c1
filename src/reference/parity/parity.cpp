// The parity run over all families: shares, blocks, threads.
#include "reference/parity/parity.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "debug/check.hpp"
#include "reference/families/cast_families.hpp"
#include "reference/families/pair_families.hpp"
#include "reference/parity/cast_block.hpp"
#include "reference/parity/parallel_blocks.hpp"
#include "reference/parity/parity_block.hpp"

namespace tumble::reference {

namespace {

// A row of the run: a family of pairs at rest, or of moving pairs.
struct Family {
    const PairFamily* resting = nullptr;
    const CastFamily* moving = nullptr;

    std::string name() const { return std::string(resting ? resting->name : moving->name); }
    double share() const { return resting ? resting->share : moving->share; }
    std::uint64_t block_pairs() const;
};

struct Block {
    std::size_t row = 0;
    Family family;
    std::uint64_t begin = 0;
    std::uint64_t end = 0;

    ParityRow compare(const ParityOptions& options) const {
        return family.resting ? compare_family_block(*family.resting, begin, end, options)
                              : compare_cast_block(*family.moving, begin, end, options);
    }
};

constexpr std::uint64_t kBlockPairs = 256;  // its queries and answers stay in the second-level cache
constexpr std::uint64_t kLargeBlockPairs = 8;

std::uint64_t Family::block_pairs() const {
    return resting && resting->kind == FamilyKind::large ? kLargeBlockPairs : kBlockPairs;
}

std::vector<Family> chosen_families(const std::vector<std::string>& names) {
    std::vector<Family> chosen;
    if (names.empty()) {
        for (const PairFamily& family : pair_families()) chosen.push_back({&family, nullptr});
        for (const CastFamily& family : cast_families()) chosen.push_back({nullptr, &family});
    }
    for (const std::string& name : names) {
        chosen.push_back({find_pair_family(name), find_cast_family(name)});
        if (!chosen.back().resting && !chosen.back().moving)
            throw std::invalid_argument("no family of pairs is called '" + name + "'");
    }
    return chosen;
}

// Divides the pairs among the families by their shares. Rounding the running sum keeps the total exact.
std::vector<Block> make_blocks(const std::vector<Family>& families, std::uint64_t pairs) {
    double all_shares = 0.0, share = 0.0;
    for (const Family& family : families) all_shares += family.share();
    std::vector<Block> blocks;
    std::uint64_t given = 0;
    for (std::size_t row = 0; row < families.size(); ++row) {
        share += families[row].share();
        const bool is_last = row + 1 == families.size();
        const auto until =
            is_last ? pairs
                    : static_cast<std::uint64_t>(std::llround(static_cast<double>(pairs) * (share / all_shares)));
        const std::uint64_t count = until - given, step = families[row].block_pairs();
        for (std::uint64_t begin = 0; begin < count; begin += step)
            blocks.push_back({row, families[row], begin, std::min(begin + step, count)});
        TUMBLE_CHECK(given <= until);
        given = until;
    }
    return blocks;
}

}  // namespace

ParityResult run_parity(const ParityOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    const std::vector<Family> families = chosen_families(options.families);
    ParityResult result;
    result.pairs = options.pairs;
    result.seed = options.seed;
    for (const Family& family : families) {
        result.families.emplace_back();
        result.families.back().name = family.name();
    }
    const std::vector<Block> blocks = make_blocks(families, options.pairs);
    std::uint64_t done = 0;
    run_blocks<ParityRow>(
        blocks.size(), options.threads, [&](std::size_t i) { return blocks[i].compare(options); },
        [&](std::size_t i, const ParityRow& row) {
            result.families[blocks[i].row].merge(row);
            done += blocks[i].end - blocks[i].begin;
            if (options.progress) options.progress(done);
        });
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

}  // namespace tumble::reference
