// The run over the table of families: shares, blocks, threads.
#include "reference/parity.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "reference/pair_families.hpp"
#include "reference/parity_block.hpp"
#include "reference/parallel_blocks.hpp"

namespace tumble::reference {

namespace {

struct Block {
    std::size_t row = 0;
    const PairFamily* family = nullptr;
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
};

constexpr std::uint64_t kBlockPairs = 256;   // its queries and answers stay in the second-level cache
constexpr std::uint64_t kLargeBlockPairs = 8;

std::vector<const PairFamily*> chosen_families(const std::vector<std::string>& names) {
    std::vector<const PairFamily*> chosen;
    if (names.empty())
        for (const PairFamily& family : pair_families()) chosen.push_back(&family);
    for (const std::string& name : names) {
        chosen.push_back(find_pair_family(name));
        if (!chosen.back()) throw std::invalid_argument("no family of pairs is called '" + name + "'");
    }
    return chosen;
}

// Splits the pairs among the families by their shares; the rounded running sum keeps the total exact.
std::vector<Block> make_blocks(const std::vector<const PairFamily*>& families, std::uint64_t pairs) {
    double all_shares = 0.0, share = 0.0;
    for (const PairFamily* family : families) all_shares += family->share;
    std::vector<Block> blocks;
    std::uint64_t given = 0;
    for (std::size_t row = 0; row < families.size(); ++row) {
        share += families[row]->share;
        const bool is_last = row + 1 == families.size();
        const auto until = is_last ? pairs : static_cast<std::uint64_t>(std::llround(static_cast<double>(pairs) * (share / all_shares)));
        const std::uint64_t count = until - given;
        const std::uint64_t step = families[row]->kind == FamilyKind::large ? kLargeBlockPairs : kBlockPairs;
        for (std::uint64_t begin = 0; begin < count; begin += step)
            blocks.push_back({row, families[row], begin, std::min(begin + step, count)});
        given = until;
    }
    return blocks;
}

}  // namespace

ParityResult run_parity(const ParityOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    const std::vector<const PairFamily*> families = chosen_families(options.families);
    ParityResult result;
    result.pairs = options.pairs;
    result.seed = options.seed;
    for (const PairFamily* family : families) {
        result.families.emplace_back();
        result.families.back().name = family->name;
    }
    const std::vector<Block> blocks = make_blocks(families, options.pairs);
    std::uint64_t done = 0;
    run_blocks<ParityRow>(
        blocks.size(), options.threads,
        [&](std::size_t i) { return compare_family_block(*blocks[i].family, blocks[i].begin, blocks[i].end, options); },
        [&](std::size_t i, const ParityRow& row) {
            result.families[blocks[i].row].merge(row);
            done += blocks[i].end - blocks[i].begin;
            if (options.progress) options.progress(done);
        });
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

}  // namespace tumble::reference
