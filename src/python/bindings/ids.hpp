// Ids as Python integers: the generation in the upper 32 bits, the index in the lower ones.
#pragma once

#include <cstdint>

#include "tumble/id.hpp"

namespace tumble::python {

template <class IdType>
std::uint64_t to_number(IdType id) {
    return std::uint64_t{id.generation} << 32 | id.index;
}

template <class IdType>
IdType to_id(std::uint64_t number) {
    return {static_cast<std::uint32_t>(number), static_cast<std::uint32_t>(number >> 32)};
}

}  // namespace tumble::python
