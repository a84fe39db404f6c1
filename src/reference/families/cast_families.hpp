// Seeded generators of moving pairs, in one table: the casts and times of impact of the tests and of the parity run.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "reference/query/cast_query.hpp"

namespace tumble::reference {

struct CastFamily {
    std::string_view name;
    std::string_view description;
    CastQuery (*generate)(std::uint64_t seed, std::uint64_t index);
    double share = 1.0;  // as of a PairFamily
};

std::span<const CastFamily> cast_families();

// Null if there is none of that name.
const CastFamily* find_cast_family(std::string_view name);

}  // namespace tumble::reference
