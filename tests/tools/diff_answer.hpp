// The answer of `tumble diff --json`.
#pragma once

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "process.hpp"

namespace tumble::test {

inline nlohmann::json compare(const Answer& answer) {
    REQUIRE_MESSAGE(!answer.out.empty(), answer.err);
    return nlohmann::json::parse(answer.out);
}

}  // namespace tumble::test
